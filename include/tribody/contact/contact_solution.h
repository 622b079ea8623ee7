#ifndef tribody_contact_contact_solution_h
#define tribody_contact_contact_solution_h

#include <Eigen/Core>

#include <tribody/base/solver_report.h>

#include <vector>

namespace Tribody
{
  struct BoreSurface;

  namespace Contact
  {
    /// Indices of the bore nodes in contact, ascending.
    using ActiveSet = std::vector<Eigen::Index>;

    /**
     * How pin and bore press on each other in one instant. A plain value; all
     * vectors have one entry per bore node.
     */
    struct ContactSolution
    {
      /// Nodal forces on the bore along its normals, per axial length [N/m],
      /// not negative.
      Eigen::VectorXd nodal_force;
      /// Contact pressure [Pa], the nodal forces over the lumped weights.
      Eigen::VectorXd pressure;
      /// What is left open between pin and deformed bore [m], zero in contact.
      Eigen::VectorXd gap;
      /// Centre of the pin relative to that of the bore [m].
      Eigen::Vector2d pin_centre = Eigen::Vector2d::Zero();
      /// Force of the pin on the bushing per axial length [N/m].
      Eigen::Vector2d force = Eigen::Vector2d::Zero();
      ActiveSet       active_set;
      /// The nodes that an iteration of the active sets would take next: the
      /// same if the contact is solved.
      ActiveSet next_active_set;
      /// See contact_half_angle() [rad].
      double       half_angle = 0.;
      SolverReport report;
    };

    /**
     * Half of the angle, seen from the pin's centre, between the two ends of
     * the contact [rad]; openings in between are not subtracted. Zero without
     * contact, pi if the pin touches all around.
     *
     * An end lies somewhere between the last node in contact and the first
     * one out of it. There the pressure falls to zero like the square root of
     * the distance, so the square of the pressure is extrapolated linearly,
     * from the second and third node (the last one carries the error of the
     * discretisation), and the result is kept between those two nodes.
     * With fewer than six nodes in contact the end is set halfway between
     * them.
     */
    double
    contact_half_angle(const ContactSolution &solution,
                       const BoreSurface     &surface);

    /**
     * The largest contact pressure [Pa]: that of a smooth curve through five
     * nodes in contact, at the top of its parabola. What alternates from node
     * to node is discretisation error (vertices and midpoints of quadratic
     * cells do) and does not count, nor does a spike at the edge of contact,
     * where no five nodes in contact surround it.
     * If no five neighbours are in contact, the nodes are all there is.
     */
    double
    peak_pressure(const ContactSolution &solution, const BoreSurface &surface);
  } // namespace Contact
} // namespace Tribody

#endif
