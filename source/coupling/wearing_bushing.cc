#include <deal.II/base/utilities.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/vector.h>

#include <tribody/base/exceptions.h>
#include <tribody/contact/contact_solver.h>
#include <tribody/contact/force_sensitivity.h>
#include <tribody/coupling/wearing_bushing.h>
#include <tribody/elasticity/pin_elasticity.h>
#include <tribody/elasticity/stress_postprocessor.h>
#include <tribody/multibody/duty_cycle.h>
#include <tribody/output/bushing_vtu.h>
#include <tribody/surface/turned_interpolation.h>
#include <tribody/wear/archard_law.h>
#include <tribody/wear/constant_extrapolation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // A mesh must exist before the members that live on it are constructed.
      dealii::Triangulation<2>
      make_mesh(const BushingParameters          &parameters,
                const Multibody::JointParameters &joint)
      {
        dealii::Triangulation<2> triangulation;
        Elasticity::make_ring_mesh(parameters.mesh,
                                   joint.bushing_radius,
                                   parameters.outer_radius,
                                   triangulation);
        return triangulation;
      }



      Elasticity::PlaneState
      plane_state(const std::string &name)
      {
        return name == "plane stress" ? Elasticity::PlaneState::stress
                                      : Elasticity::PlaneState::strain;
      }



      Wear::WearProfile
      make_profile(const BoreNodes &nodes)
      {
        return Wear::make_wear_profile(nodes.positions,
                                       nodes.radial_directions(),
                                       nodes.degree);
      }
    } // namespace



    WearingBushing::WearingBushing(const BushingParameters          &parameters,
                                   const Multibody::JointParameters &joint,
                                   const double compliance_update)
      : parameters(parameters)
      , joint(joint)
      , compliance_update(compliance_update)
      , triangulation(make_mesh(parameters, joint))
      , geometry(triangulation, parameters.element_degree, parameters.name)
      , elasticity(triangulation,
                   parameters.element_degree,
                   joint.bushing_material,
                   plane_state(parameters.plane_state))
      , wear_profile(make_profile(geometry.bore_nodes()))
      , surface(wear_profile.surface())
    {
      if (parameters.pin_is_elastic(joint))
        setup_pin();
      update_compliance();
    }



    void
    WearingBushing::setup_pin()
    {
      dealii::Triangulation<2> mesh;
      Elasticity::make_pin_mesh(parameters.mesh,
                                parameters.pin_hole_radius,
                                joint.pin_radius,
                                mesh);
      Elasticity::PinElasticity pin(mesh,
                                    parameters.element_degree,
                                    joint.pin_material,
                                    plane_state(parameters.plane_state));
      pin.reinit(dealii::MappingQ<2>(parameters.element_degree));
      pin_surface = make_bore_surface(pin.surface_nodes().positions,
                                      parameters.element_degree);
      pin_compliance =
        pin.normal_compliance(pin.surface_nodes().radial_directions(),
                              Elasticity::RingSymmetry::cells_alike);
    }



    CycleContact
    WearingBushing::compute_cycle_contact(
      const Eigen::VectorXd           &depth,
      const Multibody::JointDutyCycle &cycle,
      const CycleContact              *similar) const
    {
      Wear::WearProfile worn = wear_profile;
      worn.depth             = depth;

      CycleContact contact;
      contact.surface            = worn.surface();
      contact.sliding_increments = cycle.sliding_increment;
      contact.removed_area       = Eigen::VectorXd::Zero(depth.size());
      contact.peak_pressure      = Eigen::VectorXd::Zero(depth.size());

      const Wear::ArchardLaw archard{parameters.wear_coefficient};
      Contact::ContactSolver solver(contact.surface,
                                    compliance,
                                    joint.pin_radius,
                                    parameters.contact_solver);

      // Neighbouring samples differ little, and the same sample on a similar
      // bore differs less.
      for (Eigen::Index j = 0; j < cycle.normal_force.size(); ++j)
        {
          const Contact::ContactSolution *start = nullptr;
          if (similar != nullptr)
            start = &similar->samples[j];
          else if (j > 0)
            start = &contact.samples.back();
          contact.samples.push_back(
            solver.solve_force_controlled(force_per_length(cycle, j), start));

          const Contact::ContactSolution &solution = contact.samples.back();
          AssertThrow(solution.report.converged,
                      ExcRun(unsolved_contact(cycle, j, solution.report)));

          for (Eigen::Index i = 0; i < depth.size(); ++i)
            contact.removed_area[i] +=
              archard.area_increment(solution.nodal_force[i],
                                     cycle.sliding_increment[j]);
          contact.peak_pressure =
            contact.peak_pressure.cwiseMax(solution.pressure);
          contact.max_pressure =
            std::max(contact.max_pressure,
                     Contact::peak_pressure(solution, contact.surface));
          if (cycle.normal_force[j] > cycle.normal_force[contact.peak_sample])
            contact.peak_sample = j;
        }

      contact.wear_rate =
        worn.depth_for_removed_area(contact.surface, contact.removed_area);
      return contact;
    }



    Eigen::Vector2d
    WearingBushing::force_per_length(const Multibody::JointDutyCycle &cycle,
                                     const Eigen::Index               j) const
    {
      const double angle = cycle.contact_angle_bushing[j];
      return cycle.normal_force[j] / parameters.axial_length *
             Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }



    std::string
    WearingBushing::unsolved_contact(const Multibody::JointDutyCycle &cycle,
                                     const Eigen::Index               j,
                                     const SolverReport &report) const
    {
      return "Bushing " + name() + ": the contact problem of sample " +
             std::to_string(j) + " of the cycle (normal force " +
             std::to_string(cycle.normal_force[j]) +
             " N) has no solution: " + report.message +
             ". A finer mesh (Bore cells) or shorter wear steps (Cycles per "
             "step) may help.";
    }



    Eigen::MatrixXd
    WearingBushing::compute_wear_rate_jacobian(
      const CycleContact &contact) const
    {
      const Eigen::Index        n        = contact.surface.n_nodes();
      Eigen::MatrixXd           jacobian = Eigen::MatrixXd::Zero(n, n);
      Contact::ForceSensitivity sensitivity(contact.surface.positions,
                                            compliance,
                                            joint.pin_radius);
      // Samples with the same nodes in contact one after the other.
      std::vector<std::size_t> order(contact.samples.size());
      std::iota(order.begin(), order.end(), 0U);
      std::stable_sort(order.begin(),
                       order.end(),
                       [&](const std::size_t a, const std::size_t b) {
                         return contact.samples[a].active_set <
                                contact.samples[b].active_set;
                       });
      for (const std::size_t j : order)
        sensitivity.add_to(jacobian,
                           contact.samples[j],
                           parameters.wear_coefficient *
                             contact.sliding_increments[j]);
      const Eigen::VectorXd area_derivative =
        wear_profile.area_derivative(contact.surface);
      return area_derivative.cwiseInverse().asDiagonal() * jacobian;
    }



    void
    WearingBushing::set_depth(const Eigen::VectorXd &depth)
    {
      geometry.update(depth);
      wear_profile.depth = depth;
      surface            = wear_profile.surface();

      const double wall = parameters.outer_radius - joint.bushing_radius;
      if ((depth - depth_at_compliance).lpNorm<Eigen::Infinity>() >
          compliance_update * wall)
        update_compliance();
    }



    void
    WearingBushing::update_compliance()
    {
      elasticity.reinit(geometry.mapping());
      const bool is_unworn = wear_profile.depth.isZero(0.);
      compliance =
        elasticity.normal_compliance(surface.normals,
                                     is_unworn
                                       ? Elasticity::RingSymmetry::cells_alike
                                       : Elasticity::RingSymmetry::none);
      if (has_elastic_pin())
        {
          const Eigen::MatrixXd P =
            make_turned_interpolation(surface, pin_surface, /*angle = */ 0.);
          compliance += P.transpose() * pin_compliance * P;
        }
      depth_at_compliance = wear_profile.depth;
      ++n_builds;
    }



    ClearanceProfile
    WearingBushing::clearance_profile() const
    {
      const double unworn = joint.bushing_radius - joint.pin_radius;
      return ClearanceProfile(node_angles(),
                              (wear_profile.depth.array() + unworn).matrix());
    }



    double
    WearingBushing::volume_for_depth(const Eigen::VectorXd &depth) const
    {
      Wear::WearProfile profile = wear_profile;
      profile.depth             = depth;
      const double area         = profile.surface().enclosed_area;
      profile.depth             = Eigen::VectorXd::Zero(depth.size());
      return (area - profile.surface().enclosed_area) * parameters.axial_length;
    }



    double
    WearingBushing::worn_volume() const
    {
      return geometry.removed_area() * parameters.axial_length;
    }



    double
    WearingBushing::max_stable_step(const double sliding_per_cycle) const
    {
      // Nothing wears, nothing can become unstable.
      const double wear_per_pressure =
        parameters.wear_coefficient * sliding_per_cycle;
      if (!(wear_per_pressure > 0.))
        return std::numeric_limits<double>::max();
      return Wear::max_stable_step(compliance,
                                   wear_profile.area_derivative(surface),
                                   wear_per_pressure);
    }



    void
    WearingBushing::write_vtu(const std::string  &file_name,
                              const CycleContact &contact) const
    {
      const Contact::ContactSolution &solution = contact.at_peak_force();
      const Eigen::Matrix2Xd          nodal_forces =
        surface.normals * solution.nodal_force.asDiagonal();
      const dealii::Vector<double> displacement =
        elasticity.solve(nodal_forces);
      const Elasticity::StressPostprocessor stresses(elasticity.hooke());

      Output::write_bushing_vtu(file_name,
                                {geometry.mapping(),
                                 elasticity.get_dof_handler(),
                                 elasticity.bore_nodes(),
                                 stresses,
                                 displacement,
                                 geometry.wear_displacement(),
                                 solution.pressure,
                                 wear_profile.depth});
    }
  } // namespace Coupling
} // namespace Tribody
