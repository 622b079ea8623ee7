// SPDX-License-Identifier: LGPL-2.1-or-later

// Wear of bushing and elastic pin where the bushing is a free ring in a
// housing. Known, for a ring that fits its housing, one with a gap as wide as
// the clearance and one twenty times as wide:
// - The derivative of the wear rates with respect to the depths of both
//   surfaces is what central differences give; what is left out of it, see
//   both_surfaces_01.
// - Each surface loses what its law removes, to rounding; bushing and pin lose
//   k_b and k_p times the same integral of pressure over area and distance.
// - Implicit steps and explicit ones of the stable length that the program
//   finds come to the same maximum depth within the implicit ones' tolerance.
// - The dynamics sees a clearance that is wider by the gap.

#include <deal.II/base/mpi.h>

#include <tribody/stepping/wear_process.h>

#include <cmath>
#include <iostream>

using namespace Tribody;
using namespace Tribody::Coupling;

namespace
{
  BushingParameters
  make_parameters(const double gap)
  {
    BushingParameters bushing;
    bushing.name                    = "pin";
    bushing.axial_length            = 8.6e-3;
    bushing.outer_radius            = 15.875e-3;
    bushing.rim_support.kind        = Elasticity::RimSupport::Kind::housing;
    bushing.rim_support.housing_gap = gap;
    bushing.wear_coefficient        = 5e-13;
    bushing.pin_wear_coefficient    = 2e-13;
    bushing.mesh.n_bore_cells       = 36;
    return bushing;
  }



  Multibody::JointParameters
  make_joint()
  {
    Multibody::JointParameters joint;
    joint.name             = "pin";
    joint.bushing_radius   = 9.5e-3;
    joint.pin_radius       = 9.49e-3;
    joint.bushing_material = {"plastic", 0.139e9, 0.38, 2160.};
    joint.pin_material     = joint.bushing_material;
    return joint;
  }



  // 60 mm of sliding per cycle in 4 s. The load swings by 60 deg in the
  // bushing, and the pin by 40 deg.
  Multibody::JointDutyCycle
  make_duty_cycle()
  {
    constexpr unsigned int    n = 24;
    Multibody::JointDutyCycle joint;
    joint.name                  = "pin";
    joint.normal_force          = Eigen::VectorXd(n);
    joint.contact_angle_bushing = Eigen::VectorXd(n);
    joint.contact_angle_pin     = Eigen::VectorXd(n);
    joint.sliding_increment     = Eigen::VectorXd::Constant(n, 60e-3 / n);
    joint.sliding_speed         = Eigen::VectorXd::Constant(n, 15e-3);
    for (unsigned int j = 0; j < n; ++j)
      {
        const double phase             = 2. * M_PI * j / n;
        joint.contact_angle_bushing[j] = 0.3 + M_PI / 3. * std::sin(phase);
        joint.contact_angle_pin[j] =
          joint.contact_angle_bushing[j] - 0.7 * std::cos(phase);
        joint.normal_force[j] = 75. + 25. * std::cos(phase + 0.5);
      }
    return joint;
  }



  struct Run
  {
    explicit Run(const double        gap,
                 const Extrapolation extrapolation = Extrapolation::implicit)
      : process(make_wear(extrapolation), make_bushings(gap))
    {
      Multibody::DutyCycle cycle;
      cycle.joints = {make_duty_cycle()};
      process.renew_duty_cycle(cycle);
      process.solve_contacts();
    }

    static WearParameters
    make_wear(const Extrapolation extrapolation)
    {
      WearParameters wear;
      wear.extrapolation = extrapolation;
      return wear;
    }

    static std::deque<WearingBushing>
    make_bushings(const double gap)
    {
      std::deque<WearingBushing> bushings;
      bushings.emplace_back(make_parameters(gap), make_joint(), 0.005);
      return bushings;
    }

    const WearingBushing &
    bushing() const
    {
      return process.bushings().front();
    }

    const JointState &
    joint() const
    {
      return process.state().joints[0];
    }

    void
    go_to(const double end)
    {
      while (process.state().cycles < end)
        {
          const double begin = process.state().cycles;
          process.take_step(end);
          process.complete_step(begin);
        }
    }

    WearProcess process;
  };



  void
  test_jacobian(const Run &run)
  {
    const CycleContact   &contact = run.joint().contact;
    const Eigen::MatrixXd jacobian =
      run.bushing().compute_wear_rate_jacobian(contact);
    const Eigen::Index n = contact.removed_area.size();
    std::cout << "  Jacobian right to 2e-3 for a change of bushing and pin ";
    for (const bool of_bushing : {true, false})
      {
        Eigen::VectorXd direction(n);
        for (Eigen::Index i = 0; i < n; ++i)
          direction[i] =
            (i < n / 2) == of_bushing ? 0.6 + 0.4 * std::sin(0.37 * i) : 0.;
        constexpr double step = 1e-10;
        const auto       rate = [&](const double by) {
          return run.bushing()
            .compute_cycle_contact(
              run.bushing().depth() + by * direction,
              run.process.state().duty_cycles.front().joints[0],
              &contact)
            .removed_area.cwiseQuotient(contact.area_derivative)
            .eval();
        };
        const Eigen::VectorXd difference =
          (rate(step) - rate(-step)) / (2. * step);
        const double error =
          (jacobian * direction - difference).norm() / difference.norm();
        std::cout << (error < 2e-3);
      }
    std::cout << std::endl;
  }



  void
  test_wear(const double gap)
  {
    constexpr double end = 3000.;
    Run              run(gap);
    run.go_to(end);
    const WearingBushing &bushing = run.bushing();

    std::size_t fewest = 1000, most = 0;
    bool        balanced = true;
    for (const Contact::ContactSolution &sample : run.joint().contact.samples)
      {
        fewest   = std::min(fewest, sample.rim.active_set.size());
        most     = std::max(most, sample.rim.active_set.size());
        balanced = balanced && (sample.rim.force - sample.force).norm() <
                                 1e-10 * sample.force.norm();
      }
    std::cout << "gap of " << 1e6 * gap << " um: " << fewest << " to " << most
              << " of " << bushing.node_angles().size()
              << " nodes of the rim touch, carrying the force " << balanced
              << std::endl;
    test_jacobian(run);

    const auto &lost = run.joint().totals.surfaces;
    std::cout << "  balance below 1e-9: bushing "
              << (std::abs(bushing.worn_volume() / lost[0].removed_volume -
                           1.) < 1e-9)
              << ", pin "
              << (std::abs(bushing.pin_worn_volume() / lost[1].removed_volume -
                           1.) < 1e-9)
              << "; same integral "
              << (std::abs(bushing.worn_volume() / bushing.pin_worn_volume() -
                           2.5) < 1e-9)
              << std::endl;

    Run explicit_run(gap, Extrapolation::constant);
    explicit_run.go_to(end);
    const double depth = bushing.profile().max_depth();
    const double difference =
      std::abs(depth - explicit_run.bushing().profile().max_depth());
    std::cout << "  implicit and explicit steps differ by less than 0.5 % "
              << (difference < 5e-3 * depth) << std::endl;
    std::cout << "  clearance wider by the gap "
              << (std::abs(bushing.clearance().bushing.value(0.3) -
                           bushing.clearance_profile().value(0.3) - gap) <
                  1e-12)
              << std::endl;
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const double gap : {0., 10e-6, 200e-6})
    test_wear(gap);
}
