// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_contact_contact_solution_h
#define tribody_contact_contact_solution_h

#include <Eigen/Core>

#include <tribody/base/solver_report.h>

#include <mpi.h>
#include <vector>

namespace Tribody
{
  struct BoreSurface;

  namespace Contact
  {
    /// Indices of the bore nodes in contact, ascending.
    using ActiveSet = std::vector<Eigen::Index>;

    /**
     * How the rim of a free ring and its housing press on each other. All
     * vectors have one entry per node of the rim, and none without a housing.
     */
    struct RimContact
    {
      /// Nodal forces on the rim against its normals, per axial length [N/m],
      /// not negative.
      Eigen::VectorXd nodal_force;
      /// Contact pressure [Pa].
      Eigen::VectorXd pressure;
      /// What is left open between deformed ring and housing [m].
      Eigen::VectorXd gap;
      /// By how much the ring is displaced in the housing [m]: the circle that
      /// fits its rim best, as far as the compliance is seen from there.
      Eigen::Vector2d ring_place = Eigen::Vector2d::Zero();
      /// Force of the ring on the housing per axial length [N/m].
      Eigen::Vector2d force = Eigen::Vector2d::Zero();
      /// As in ContactSolution.
      ActiveSet active_set;
      /// As in ContactSolution: what an iteration would take next.
      ActiveSet next_active_set;
    };

    /**
     * How pin and bore press on each other in one instant. A plain value; all
     * vectors have one entry per bore node. A new member belongs into
     * broadcast(), too.
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
      /// Nodes that are held on the pin.
      ActiveSet active_set;
      /// The nodes that an iteration of the active sets would take next: the
      /// same if the contact is solved.
      ActiveSet next_active_set;
      /// See contact_half_angle() [rad].
      double half_angle = 0.;
      /// How the iteration ended.
      SolverReport report;
      /// Of a ring in a housing; else empty.
      RimContact rim;
    };

    /// How many nodes are held though the next active set has them free, or the
    /// other way round.
    std::size_t
    n_differing_nodes(const ContactSolution &solution);

    /// Let the next active set of @p solution be its active set; or change only
    /// the last node in which they differ. What is released presses no longer.
    void
    take_next_active_set(ContactSolution &solution, const bool one_by_one);

    /**
     * What to start the next contact of a sequence in equal steps from: places,
     * shares of the force and nodes in contact if it goes on as it went from
     * the solution @p before to @p last.
     *
     * Towards the end of a contact the pressure falls like the root of the
     * distance and beyond it the gap opens like its power 3/2. So the squares
     * of the nodes' shares of the force and the powers 2/3 of the gaps are
     * extrapolated; as far as these laws hold, an end that moves steadily is
     * found. Where the contact jumps there is nothing to extrapolate: if one of
     * the two touches nothing, or more than a fifth of the nodes would change,
     * the result is @p last.
     *
     * @pre Both come from a solver, for the same nodes.
     * @return a start only: no pressures, gaps or report.
     */
    ContactSolution
    extrapolate(const ContactSolution &before, const ContactSolution &last);

    /// Replace @p solution by that of rank @p root of @p communicator, on whose
    /// ranks all must know the same bore.
    void
    broadcast(ContactSolution   &solution,
              const unsigned int root,
              const MPI_Comm    &communicator);

    /**
     * Half of the angle, seen from the pin's centre, between the two ends of
     * the contact [rad]; openings in between are not subtracted. Zero without
     * contact, pi if the pin touches all around.
     *
     * At an end the gap opens like @f$d^{3/2}@f$ of the distance d, with the
     * next term smaller by d over the width of the contact. So a parabola
     * through the power 2/3 of the gaps beyond the end, by least squares, is
     * zero at the end. Gaps are displacements of nodes, more accurate than
     * pressures, which are averages around nodes and singular at the end; the
     * node next to the end is left out. An end is placed within half a node
     * distance of the last node in contact and the first one out of it, and
     * halfway between them if fewer than six nodes are in contact or fewer than
     * nine are out of it.
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
