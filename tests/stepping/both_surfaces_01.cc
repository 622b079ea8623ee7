// SPDX-License-Identifier: LGPL-2.1-or-later

// Pin and bushing wear together under given duty cycles. Known:
// - The derivative of the wear rates with respect to the depths of both
//   surfaces is what central differences give, for a constant coefficient and
//   for one that depends on the pressure. Left out of it are the cosine of the
//   angle between the wear's direction and the contact's (1e-4 here) and 1e-4
//   of the transfer between the surfaces. For constant coefficients it is
//   symmetric in the metric that Newton's line search uses, and nowhere
//   positive, but for what the contact's directions change under load (1e-3 of
//   the norm is allowed).
// - Each surface loses what its law removes, to rounding; bushing and pin lose
//   k_b and k_p times the same integral of pressure over area and distance.
// - Under a load that turns evenly relative to both, equal materials wear
//   round: what the depth varies by is below 1 % of it. Both lose the same.
// - Where the motion stops settling, a cycle has more samples than the one
//   before: what was found for that is a start of no use and no harm, so that
//   the result is that without a start, to 1e-12.
// - Two like joints in one run end as one alone: to the bit in steps of the
//   same length, within the estimated error in implicit steps.

#include <deal.II/base/mpi.h>

#include <Eigen/Eigenvalues>

#include <tribody/stepping/wear_process.h>

#include <cmath>
#include <iostream>

using namespace Tribody;
using namespace Tribody::Coupling;

namespace
{
  BushingParameters
  make_parameters(const std::string &name)
  {
    BushingParameters bushing;
    bushing.name                 = name;
    bushing.axial_length         = 8.6e-3;
    bushing.outer_radius         = 15.875e-3;
    bushing.wear_coefficient     = 5e-13;
    bushing.pin_wear_coefficient = 2e-13;
    bushing.mesh.n_bore_cells    = 60;
    return bushing;
  }



  Multibody::JointParameters
  make_joint(const std::string &name)
  {
    Multibody::JointParameters joint;
    joint.name             = name;
    joint.bushing_material = {"plastic", 0.139e9, 0.38, 2160.};
    joint.pin_material     = joint.bushing_material;
    return joint;
  }



  // 60 mm of sliding per cycle in 4 s. The load swings by 60 deg in the
  // bushing, and the pin by 40 deg; or it turns relative to both.
  Multibody::JointDutyCycle
  make_duty_cycle(const std::string &name, const bool turns)
  {
    const unsigned int        n = turns ? 48 : 24;
    Multibody::JointDutyCycle joint;
    joint.name                  = name;
    joint.normal_force          = Eigen::VectorXd(n);
    joint.contact_angle_bushing = Eigen::VectorXd(n);
    joint.contact_angle_pin     = Eigen::VectorXd(n);
    joint.sliding_increment     = Eigen::VectorXd::Constant(n, 60e-3 / n);
    joint.sliding_speed         = Eigen::VectorXd::Constant(n, 15e-3);
    for (unsigned int j = 0; j < n; ++j)
      {
        const double phase = 2. * M_PI * j / n;
        joint.contact_angle_bushing[j] =
          turns ? phase : 0.3 + M_PI / 3. * std::sin(phase);
        const double alpha         = turns ? 2. * phase : 0.7 * std::cos(phase);
        joint.contact_angle_pin[j] = joint.contact_angle_bushing[j] - alpha;
        joint.normal_force[j] = turns ? 90. : 75. + 25. * std::cos(phase + 0.5);
      }
    return joint;
  }



  struct Run
  {
    Run(const std::vector<BushingParameters> &parameters,
        const bool                            turns,
        const Extrapolation extrapolation = Extrapolation::implicit)
      : process(make_wear(extrapolation), make_bushings(parameters))
    {
      Multibody::DutyCycle cycle;
      for (const BushingParameters &bushing : parameters)
        cycle.joints.push_back(make_duty_cycle(bushing.name, turns));
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
    make_bushings(const std::vector<BushingParameters> &parameters)
    {
      std::deque<WearingBushing> bushings;
      for (const BushingParameters &bushing : parameters)
        bushings.emplace_back(bushing, make_joint(bushing.name), 0.005);
      return bushings;
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

    const Multibody::JointDutyCycle &
    cycle() const
    {
      return process.state().duty_cycles.front().joints[0];
    }

    WearProcess process;
  };



  void
  test_jacobian(const std::string &factor)
  {
    BushingParameters parameters           = make_parameters("pin");
    parameters.wear_coefficient_factor     = factor;
    parameters.pin_wear_coefficient_factor = factor;
    Run run({parameters}, false);
    run.go_to(3000.);

    const WearingBushing            &bushing = run.bushing();
    const Multibody::JointDutyCycle &cycle   = run.cycle();
    const CycleContact              &contact = run.joint().contact;
    const Eigen::MatrixXd            jacobian =
      bushing.compute_wear_rate_jacobian(contact);
    const Eigen::Index n        = contact.removed_area.size();
    double             error[2] = {0., 0.};
    for (int on_pin = 0; on_pin < 2; ++on_pin)
      {
        Eigen::VectorXd direction(n);
        for (Eigen::Index i = 0; i < n; ++i)
          direction[i] =
            (i < n / 2) == (on_pin == 0) ? 0.6 + 0.4 * std::sin(0.37 * i) : 0.;
        constexpr double step = 1e-10;
        const auto       rate = [&](const double by) {
          return bushing
            .compute_cycle_contact(bushing.depth() + by * direction,
                                   cycle,
                                   &contact)
            .removed_area.cwiseQuotient(contact.area_derivative)
            .eval();
        };
        const Eigen::VectorXd difference =
          (rate(step) - rate(-step)) / (2. * step);
        const Eigen::VectorXd product = jacobian * direction;
        error[on_pin] = (product - difference).norm() / difference.norm();
      }
    std::cout << "factor " << factor
              << ": Jacobian right to 2e-3 for a change of the bushing "
              << (error[0] < 2e-3) << ", of the pin " << (error[1] < 2e-3);
    if (factor == "1")
      {
        const Eigen::VectorXd &D      = contact.area_derivative;
        Eigen::VectorXd        metric = D;
        metric.head(n / 2) /= parameters.wear_coefficient;
        metric.tail(n / 2) /= parameters.pin_wear_coefficient;
        const Eigen::MatrixXd G_J = metric.asDiagonal() * jacobian;
        std::cout << "; symmetric "
                  << ((G_J - G_J.transpose()).norm() < 1e-9 * G_J.norm())
                  << ", not positive "
                  << (Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
                        0.5 * (G_J + G_J.transpose()), Eigen::EigenvaluesOnly)
                        .eigenvalues()
                        .maxCoeff() < 1e-3 * G_J.norm());
      }
    std::cout << std::endl;

    const SurfaceTotals &of_bushing = run.joint().totals.surfaces[0];
    const SurfaceTotals &of_pin     = run.joint().totals.surfaces[1];
    std::cout << "volume balance below 1e-9: bushing "
              << (std::abs(bushing.worn_volume() / of_bushing.removed_volume -
                           1.) < 1e-9)
              << ", pin "
              << (std::abs(bushing.pin_worn_volume() / of_pin.removed_volume -
                           1.) < 1e-9)
              << "; same integral "
              << (std::abs(bushing.worn_volume() / parameters.wear_coefficient /
                             (bushing.pin_worn_volume() /
                              parameters.pin_wear_coefficient) -
                           1.) < 1e-9)
              << ", nothing grows: "
              << (bushing.depth().minCoeff() >
                  -1e-2 * bushing.depth().maxCoeff())
              << std::endl;
  }



  // The surfaces are the same, so that only the angles tell the facings apart.
  void
  test_other_numbers_of_samples()
  {
    const Run                       run({make_parameters("pin")}, false);
    const WearingBushing           &bushing = run.bushing();
    const Multibody::JointDutyCycle few     = run.cycle();
    const Multibody::JointDutyCycle many    = make_duty_cycle("pin", true);
    const auto contact = [&](const Multibody::JointDutyCycle &cycle,
                             const CycleContact              *similar) {
      return bushing.compute_cycle_contact(bushing.depth(), cycle, similar);
    };
    const auto agree = [](const CycleContact &a, const CycleContact &b) {
      return a.samples.size() == b.samples.size() &&
             a.facings.angles == b.facings.angles &&
             (a.wear_rate - b.wear_rate).norm() < 1e-12 * b.wear_rate.norm();
    };
    const CycleContact of_few  = contact(few, nullptr);
    const CycleContact of_many = contact(many, nullptr);
    std::cout << "after a cycle of fewer samples as without: "
              << agree(contact(many, &of_few), of_many)
              << ", of more: " << agree(contact(few, &of_many), of_few)
              << ", of as many: " << agree(contact(few, &of_few), of_few)
              << std::endl;
  }



  void
  test_roundness()
  {
    BushingParameters parameters    = make_parameters("pin");
    parameters.pin_wear_coefficient = parameters.wear_coefficient;
    Run run({parameters}, true);
    run.go_to(20000.);

    const WearingBushing &bushing = run.bushing();
    for (const WearingSurface &surface : bushing.surfaces())
      {
        const Eigen::VectorXd &h = surface.profile.depth;
        const double roundness   = (h.maxCoeff() - h.minCoeff()) / h.mean();
        std::cout << surface.name
                  << ": round to 1 % of the depth: " << (roundness < 1e-2)
                  << ", at least a clearance deep: " << (h.mean() > 10e-6)
                  << std::endl;
      }
    std::cout << "both lose the same: "
              << (std::abs(bushing.worn_volume() / bushing.pin_worn_volume() -
                           1.) < 1e-9)
              << std::endl;
  }



  void
  test_two_joints()
  {
    const std::vector<BushingParameters> alone = {make_parameters("a")};
    const std::vector<BushingParameters> both  = {make_parameters("a"),
                                                  make_parameters("b")};
    Run one_explicit(alone, false, Extrapolation::constant);
    Run two_explicit(both, false, Extrapolation::constant);
    one_explicit.go_to(20.);
    two_explicit.go_to(20.);
    const auto depth = [](const Run &run, const std::size_t j) {
      return run.process.state().joints[j].depth;
    };
    std::cout << "two joints, explicit: as one alone to the bit "
              << (depth(one_explicit, 0) == depth(two_explicit, 0) &&
                  depth(one_explicit, 0) == depth(two_explicit, 1));

    const double end = 3000.;
    Run          one(alone, false), two(both, false);
    one.process.restore(one_explicit.process.state());
    two.process.restore(two_explicit.process.state());
    one.go_to(end);
    two.go_to(end);
    const double difference =
      (depth(one, 0) - depth(two, 0)).head(120).lpNorm<Eigen::Infinity>();
    std::cout << "; implicit: both joints alike "
              << ((depth(two, 0) - depth(two, 1)).lpNorm<Eigen::Infinity>() <
                  1e-9 * depth(two, 0).maxCoeff())
              << ", as one alone to the estimate "
              << (difference < one.joint().totals.depth_error[0] +
                                 two.joint().totals.depth_error[0])
              << std::endl;
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_jacobian("1");
  test_jacobian("(p/1e6)^0.3");
  test_other_numbers_of_samples();
  test_roundness();
  test_two_joints();
}
