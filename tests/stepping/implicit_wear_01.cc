// SPDX-License-Identifier: LGPL-2.1-or-later

// Implicit cycle jumps of a bushing under given duty cycles, without a
// mechanism. Known:
// - Under a force that swings by 60 deg to both sides and changes its size by
//   half: what a run estimates of its own errors is never less than a third of
//   its difference from the tightest run; explicit steps that are short enough
//   to be smooth end within the estimate of the implicit run.
// - At any tolerance the volume lost is what Archard's law removes, to
//   round-off, and the wear rate has no mesh-size oscillation; a mesh twice as
//   fine takes no more than a quarter more steps.
// - A stiff bushing under a force of constant direction wears to the closed
// form
//   of the crescent: depth within 0.3 %, volume within 0.1 % over four decades
//   of cycles. At the beginning, 2 cycles, the bushing is 0.2 um deep and gives
//   way by 0.2 nm. The steps that this takes do not depend on the
//   stiffness.

#include <deal.II/base/mpi.h>

#include <tribody/stepping/wear_process.h>
#include <tribody/wear/crescent.h>

#include <cmath>
#include <iostream>

using namespace Tribody;
using namespace Tribody::Coupling;

namespace
{
  constexpr double tolerance = 5e-3;

  std::deque<WearingBushing>
  make_bushing(const double youngs_modulus, const unsigned int n_bore_cells)
  {
    Multibody::JointParameters joint;
    joint.name             = "pin";
    joint.bushing_material = {"plastic", youngs_modulus, 0.38, 2160.};
    BushingParameters bushing;
    bushing.name              = joint.name;
    bushing.pin               = PinModel::rigid;
    bushing.axial_length      = 8.6e-3;
    bushing.outer_radius      = 15.875e-3;
    bushing.wear_coefficient  = 5.05e-13;
    bushing.mesh.n_bore_cells = n_bore_cells;

    std::deque<WearingBushing> bushings;
    bushings.emplace_back(bushing, joint, 0.005);
    return bushings;
  }



  // Force around 0.3 rad, 60 mm of sliding per cycle.
  Multibody::DutyCycle
  make_duty_cycle(const unsigned int n_samples, const double swing)
  {
    Multibody::JointDutyCycle joint;
    joint.name                  = "pin";
    joint.normal_force          = Eigen::VectorXd(n_samples);
    joint.contact_angle_bushing = Eigen::VectorXd(n_samples);
    joint.sliding_increment =
      Eigen::VectorXd::Constant(n_samples, 60e-3 / n_samples);
    for (unsigned int j = 0; j < n_samples; ++j)
      {
        const double phase             = 2. * M_PI * j / n_samples;
        joint.contact_angle_bushing[j] = 0.3 + swing * std::sin(phase);
        joint.normal_force[j] =
          swing > 0. ? 75. + 25. * std::cos(phase + 0.5) : 90.;
      }
    Multibody::DutyCycle cycle;
    cycle.joints = {joint};
    return cycle;
  }



  struct Run
  {
    Run(const double                youngs_modulus,
        const unsigned int          n_bore_cells,
        const Multibody::DutyCycle &duty_cycle,
        const Extrapolation         extrapolation,
        const double                eps = tolerance)
      : process(make_wear(extrapolation, eps),
                make_bushing(youngs_modulus, n_bore_cells))
    {
      process.renew_duty_cycle(duty_cycle);
      process.solve_contacts();
    }

    static WearParameters
    make_wear(const Extrapolation extrapolation, const double eps)
    {
      WearParameters wear;
      wear.extrapolation = extrapolation;
      wear.tolerance     = eps;
      return wear;
    }

    void
    go_to(const double end)
    {
      while (process.state().cycles < end)
        {
          const double begin = process.state().cycles;
          process.take_step(end);
          process.complete_step(begin);
          oscillation =
            std::max(oscillation,
                     Wear::mesh_oscillation(
                       process.state().joints[0].contact.wear_rate));
        }
    }

    const WearingBushing &
    bushing() const
    {
      return process.bushings().front();
    }

    const JointTotals &
    totals() const
    {
      return process.state().joints[0].totals;
    }

    unsigned int
    n_steps() const
    {
      return process.state().counts.wear_steps;
    }

    double
    depth() const
    {
      return bushing().profile().max_depth();
    }

    double
    depth_error() const
    {
      return totals().depth_error.maxCoeff();
    }

    double
    volume() const
    {
      return bushing().worn_volume();
    }

    double
    balance() const
    {
      return std::abs(volume() / totals().surfaces[0].removed_volume - 1.);
    }

    WearProcess process;
    double      oscillation = 0.;
  };



  void
  test_swing()
  {
    const Multibody::DutyCycle duty_cycle = make_duty_cycle(24, M_PI / 3.);
    const double               end        = 20000.;

    Run reference(0.139e9, 60, duty_cycle, Extrapolation::implicit, 1e-6);
    reference.go_to(end);

    for (const double eps : {1e-2, tolerance, 1e-3, 1e-4, 1e-5})
      {
        Run run(0.139e9, 60, duty_cycle, Extrapolation::implicit, eps);
        run.go_to(end);
        std::cout << "tolerance " << eps << ": depth right to its estimate: "
                  << (std::abs(run.depth() - reference.depth()) <
                      3. * run.depth_error())
                  << ", volume: "
                  << (std::abs(run.volume() - reference.volume()) <
                      3. * run.totals().surfaces[0].volume_error)
                  << ", balance right to 1e-9: " << (run.balance() < 1e-9)
                  << ", oscillation below 1e-2: " << (run.oscillation < 1e-2)
                  << std::endl;

        if (eps != tolerance)
          continue;
        Run explicit_run(0.139e9, 60, duty_cycle, Extrapolation::constant);
        explicit_run.go_to(end);
        Run fine(0.139e9, 120, duty_cycle, Extrapolation::implicit, eps);
        fine.go_to(end);
        std::cout << "explicit steps within the estimate: "
                  << (std::abs(run.depth() - explicit_run.depth()) <
                      run.depth_error())
                  << ", five times as many: "
                  << (explicit_run.n_steps() > 5 * run.n_steps())
                  << "; steps below 16: " << (run.n_steps() < 16)
                  << ", on the finer mesh: "
                  << (fine.n_steps() <= 1.25 * run.n_steps()) << std::endl;
      }
  }



  void
  test_crescent()
  {
    for (const double youngs_modulus : {1e12})
      {
        Run                      run(youngs_modulus,
                180,
                make_duty_cycle(1, 0.),
                Extrapolation::implicit);
        const BushingParameters &bushing = run.bushing().bushing_parameters();
        const Multibody::JointParameters &joint =
          run.bushing().joint_parameters();
        const Wear::Crescent crescent{joint.bushing_radius,
                                      joint.bushing_radius - joint.pin_radius,
                                      bushing.axial_length,
                                      bushing.wear_coefficient,
                                      90.};
        double               depth_error = 0., volume_error = 0.;
        for (const double cycles : {5., 50., 500., 5000., 50000.})
          {
            run.go_to(cycles);
            const double depth = crescent.depth(cycles * run.process.state()
                                                           .duty_cycles.front()
                                                           .joints[0]
                                                           .sliding_distance());
            depth_error =
              std::max(depth_error, std::abs(run.depth() / depth - 1.));
            volume_error =
              std::max(volume_error,
                       std::abs(run.volume() / crescent.volume(depth) - 1.));
          }
        std::cout << "crescent: depth within 0.3 %: " << (depth_error < 3e-3)
                  << ", volume within 0.1 %: " << (volume_error < 1e-3)
                  << ", steps below 50: " << (run.n_steps() < 50) << std::endl;
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_swing();
  test_crescent();
}
