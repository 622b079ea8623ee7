#include <tribody/base/exceptions.h>
#include <tribody/contact/contact_solver.h>
#include <tribody/contact/force_sensitivity.h>
#include <tribody/coupling/wearing_bushing.h>
#include <tribody/multibody/duty_cycle.h>
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
      , elastic(parameters, joint, compliance_update)
      , wear_profile(make_profile(elastic.bore_nodes()))
    {}



    CycleContact
    WearingBushing::compute_cycle_contact(
      const Eigen::VectorXd           &depth,
      const Multibody::JointDutyCycle &cycle,
      const CycleContact              *similar) const
    {
      return compute_contact(depth, cycle, similar, Nodes::solved);
    }



    CycleContact
    WearingBushing::compute_held_contact(const Eigen::VectorXd           &depth,
                                         const Multibody::JointDutyCycle &cycle,
                                         const CycleContact &held) const
    {
      return compute_contact(depth, cycle, &held, Nodes::held);
    }



    CycleContact
    WearingBushing::compute_contact(const Eigen::VectorXd           &depth,
                                    const Multibody::JointDutyCycle &cycle,
                                    const CycleContact              *similar,
                                    const Nodes nodes) const
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
                                    elastic.compliance(),
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
          const Eigen::Vector2d force = force_per_length(cycle, j);
          contact.samples.push_back(
            nodes == Nodes::held ? solver.solve_held(force, *start)
                                 : solver.solve_force_controlled(force, start));

          const Contact::ContactSolution &solution = contact.samples.back();
          AssertThrow(nodes == Nodes::held || solution.report.converged,
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
                                            elastic.compliance(),
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
      Wear::WearProfile worn = wear_profile;
      worn.depth             = depth;
      elastic.update(worn);
      wear_profile = worn;
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
      return elastic.removed_area() * parameters.axial_length;
    }



    double
    WearingBushing::max_stable_step(const double sliding_per_cycle) const
    {
      // Nothing wears, nothing can become unstable.
      const double wear_per_pressure =
        parameters.wear_coefficient * sliding_per_cycle;
      if (!(wear_per_pressure > 0.))
        return std::numeric_limits<double>::max();
      return Wear::max_stable_step(elastic.compliance(),
                                   wear_profile.area_derivative(elastic.bore()),
                                   wear_per_pressure);
    }



    void
    WearingBushing::write_vtu(const std::string  &file_name,
                              const CycleContact &contact) const
    {
      elastic.write_vtu(file_name, contact.at_peak_force());
    }
  } // namespace Coupling
} // namespace Tribody
