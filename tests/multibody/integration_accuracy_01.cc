// SPDX-License-Identifier: LGPL-2.1-or-later

// How much accuracy a motion gets, for wear whose error is known. With an error
// of c a^(2/3), that of a second order method, the wear of two motions in turn
// differs by c (4^(2/3) - 1) a^(2/3) = 1.52 times the error of the finer one:
// the first accuracy at which that is within 0.2 % is taken, and the error that
// is stated is never below the true one. Scatter does not become less with
// accuracy and ends the search; a motion that comes nearer to one that repeats
// goes on. Motions that fail are passed over, but not the
// finest.

#include <tribody/base/exceptions.h>
#include <tribody/multibody/cycle/integration_accuracy.h>

#include <cmath>
#include <iostream>

using namespace Tribody;
using namespace Tribody::Multibody;

namespace
{
  // One joint with so much force, constant over four samples.
  DutyCycle
  cycle_with(const double force)
  {
    JointDutyCycle joint;
    joint.name                  = "joint";
    const Eigen::VectorXd ones  = Eigen::VectorXd::Ones(4);
    joint.normal_force          = force * ones;
    joint.contact_angle_bushing = 0. * ones;
    joint.contact_angle_pin     = 0. * ones;
    joint.sliding_increment     = ones;
    joint.sliding_speed         = ones;
    joint.force_between         = Eigen::VectorXd::Constant(5, force);
    joint.angle_between         = Eigen::VectorXd::Zero(5);
    joint.sliding_halves        = Eigen::VectorXd::Constant(8, 0.5);
    DutyCycle cycle;
    cycle.settling.converged = true;
    cycle.joints.push_back(joint);
    return cycle;
  }



  template <typename Force>
  void
  search(const char *name, const Force &force)
  {
    unsigned int    n_motions = 0;
    double          last      = 0.;
    const DutyCycle cycle     = integrate_as_needed(
      [&](const double accuracy, const DutyCycle *) {
        ++n_motions;
        last = accuracy;
        return cycle_with(force(accuracy));
      },
      {});
    const double stated = cycle.joints[0].integration_error;
    const double wear   = cycle.joints[0].mean_normal_force();
    std::cout << name << ": accuracy " << last << " after " << n_motions
              << " motions, stated error " << stated << ", true one not larger "
              << (std::abs(wear - 1.) <= stated) << std::endl;
  }
} // namespace

int
main()
{
  std::cout.precision(3);
  const auto second_order = [](const double c) {
    return [c](const double a) { return 1. + c * std::pow(a, 2. / 3.); };
  };
  search("nothing to gain", second_order(1e-9));
  search("second order", second_order(0.1));
  search("second order, worse", second_order(1.));
  bool sign = false;
  search("scatter of 1 %", [&](const double) {
    sign = !sign;
    return sign ? 1.005 : 0.995;
  });
  {
    // As far from settled as its accuracy: within 1e-3 it is.
    unsigned int    n_motions = 0;
    const DutyCycle cycle     = integrate_as_needed(
      [&](const double accuracy, const DutyCycle *) {
        ++n_motions;
        DutyCycle result          = cycle_with(1.);
        result.accuracy           = accuracy;
        result.settling.distance  = accuracy;
        result.settling.converged = accuracy < 1e-3;
        return result;
      },
      {});
    std::cout << "settles with less: accuracy " << cycle.accuracy << " after "
              << n_motions << " motions" << std::endl;
  }
  search("loose ones fail", [&](const double a) {
    AssertThrow(a < 1e-3, ExcRun("the pin has left its bore"));
    return second_order(0.1)(a);
  });
  try
    {
      search("all fail", [](const double) -> double {
        throw ExcRun("the pin has left its bore");
      });
    }
  catch (const ExcRun &error)
    {
      std::cout << "all fail: " << message_of(error) << std::endl;
    }
}
