// SPDX-License-Identifier: LGPL-2.1-or-later

// Forces, torques and drivers given by tables, against closed forms. A pendulum
// that a table swings by phi = a sin(w t), 72 rows in a cycle: the spline's
// second derivative is wrong by h^2/12 of its largest value with h = 2 pi/72,
// its slope by sqrt(3)/216 h^3 and its value by h^4/384 (see
// periodic_table_01.cc); so are the tangential force on the pin, the velocity
// and the angle, and the force along the bar twice what the velocity is. Bounds
// are 5 % larger. A wheel on a motor that a table turns, with an unsteadiness
// of its own: the mean speed is that of the turns. A mass on a slide under a
// force in two columns, and in one column along an oblique vector; a torque on
// a wheel: the reactions are the interpolated values.

#include "report.h"
#include <tribody/base/exceptions.h>
#include <tribody/multibody/cycle/cycle_simulation.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/system/mechanism.h>

#include <cmath>
#include <fstream>
#include <iomanip>

using namespace Tribody;
using namespace Tribody::Multibody;

namespace
{
  constexpr double g = 9.81, m = 3., l = 0.4, a = 0.7, w = 30.;

  template <typename... Functions>
  void
  write_table(const std::string &header,
              const unsigned int n,
              const double       period,
              const Functions &...functions)
  {
    std::ofstream file("table.csv");
    file << std::setprecision(17) << header << '\n';
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double t = period * i / n;
        file << t;
        (void)std::initializer_list<int>{(file << ", " << functions(t), 0)...};
        file << '\n';
      }
  }

  MechanismParameters
  pendulum()
  {
    MechanismParameters p;
    p.gravity = {0., -g};
    BodyParameters bar;
    bar.name              = "bar";
    bar.mass              = m;
    bar.moment_of_inertia = 0.1;
    bar.markers           = {{"O", {0., l}}, {"C", {}}};
    bar.initial_position  = {0., -l};
    p.bodies              = {bar};
    JointParameters pin;
    pin.name           = "pin";
    pin.pin_marker     = "ground.O";
    pin.bushing_marker = "bar.O";
    p.joints           = {pin};
    DriverParameters motor;
    motor.name = "motor";
    motor.body = "bar";
    p.drivers  = {motor};
    return p;
  }

  DutyCycle
  run(const MechanismParameters &p)
  {
    const Mechanism    mechanism(p);
    DynamicsParameters dynamics;
    dynamics.analysis                = Analysis::inverse_dynamics;
    dynamics.cycle_duration          = 2. * M_PI / w;
    dynamics.maximum_settling_cycles = 0;
    return CycleSimulation(mechanism, dynamics).run();
  }

  void
  swing()
  {
    write_table("time [s], angle [deg]", 72, 2. * M_PI / w, [](const double t) {
      return a * std::sin(w * t) * 180. / M_PI;
    });
    MechanismParameters p   = pendulum();
    p.drivers[0].table.file = "table.csv";
    p.drivers[0].read_table();
    const DutyCycle cycle = run(p);
    double          along = 0., across = 0., place = 0., speed = 0.;
    for (unsigned int s = 0; s < cycle.time.size(); ++s)
      {
        const double          phase  = w * cycle.time(s);
        const double          phi    = a * std::sin(phase);
        const double          phi_t  = a * w * std::cos(phase);
        const double          phi_tt = -a * w * w * std::sin(phase);
        const Eigen::Vector2d force(cycle.joint("pin").force_x(s),
                                    cycle.joint("pin").force_y(s));
        const Eigen::Vector2d error =
          turned(force, -phi) -
          Eigen::Vector2d(m * (l * phi_tt + g * std::sin(phi)),
                          m * (l * phi_t * phi_t + g * std::cos(phi)));
        along  = std::max(along, std::abs(error.y()));
        across = std::max(across, std::abs(error.x()));
        place  = std::max(place, std::abs(cycle.coordinates(2, s) - phi));
        speed  = std::max(speed, std::abs(cycle.velocities(2, s) - phi_t));
      }
    const double h = 2. * M_PI / 72.;
    report_below("swung pendulum: angle",
                 place / a,
                 1.05 / 384. * std::pow(h, 4));
    report_below("angular velocity",
                 speed / (a * w),
                 1.05 * std::sqrt(3.) / 216. * std::pow(h, 3));
    report_below("force across the bar",
                 across / (m * l * a * w * w),
                 1.05 * h * h / 12.);
    report_below("force along it",
                 along / (m * l * a * w * w),
                 2. * a * 1.05 * std::sqrt(3.) / 216. * std::pow(h, 3));
  }

  void
  turn()
  {
    write_table("time [s], angle [rad]", 72, 2. * M_PI / w, [](const double t) {
      return 1. - 2. * w * t + 0.05 * std::sin(w * t);
    });
    MechanismParameters p   = pendulum();
    p.drivers[0].table.file = "table.csv";
    p.drivers[0].read_table();
    const Mechanism mechanism(p);
    report_below("turned by two turns: relative error of the period of a turn",
                 std::abs(mechanism.period() / (M_PI / w) - 1.),
                 1e-14);
    const DriverMotion motion = p.drivers[0].motion();
    double             error  = 0.;
    for (double t = -1.; t < 1.; t += 0.00317)
      error = std::max(error,
                       std::abs(motion.value(t) - 1. + 2. * w * t -
                                0.05 * std::sin(w * t)));
    report_below("its angle, over many periods",
                 error,
                 0.05 * 1.05 / 384. * std::pow(2. * M_PI / 72., 4));
  }

  // Of the ground on the driven pendulum that stands still, beside its weight.
  void
  check_force(const std::string &what, const ForceParameters &force)
  {
    MechanismParameters p      = pendulum();
    p.drivers[0].time_function = "0";
    p.forces                   = {force};
    const DutyCycle cycle      = run(p);
    double          error      = 0.;
    for (unsigned int s = 0; s < cycle.time.size(); ++s)
      {
        const double          t = cycle.time(s);
        const Eigen::Vector2d given(30. * std::sin(w * t),
                                    40. * std::sin(w * t));
        error = std::max(error,
                         (Eigen::Vector2d(cycle.joint("pin").force_x(s),
                                          cycle.joint("pin").force_y(s)) +
                          given - Eigen::Vector2d(0., m * g))
                           .norm());
      }
    const double h = 2. * M_PI / 360.;
    report_below(what, error / 50., h * h / 8.);
  }

  void
  forces()
  {
    const auto x = [](const double t) { return 0.03 * std::sin(w * t); };
    const auto y = [](const double t) { return 40. * std::sin(w * t); };
    const auto f = [](const double t) { return 50. * std::sin(w * t); };
    write_table("time [s], x [kN], y [N], f [N]", 360, 2. * M_PI / w, x, y, f);
    ForceParameters force;
    force.name          = "push";
    force.marker        = "bar.C";
    force.table.file    = "table.csv";
    force.table.columns = "x, y";
    force.read_table();
    check_force("force in two columns, linear: relative error of the reaction",
                force);
    force.vector              = {0.3, 0.4};
    force.table.columns       = "f";
    force.table.interpolation = TableInterpolation::cubic;
    force.read_table();
    check_force("force in one, cubic", force);

    write_table("time [ms], torque [N cm]", 5, 1000., [](const double t) {
      return t < 999. ? 1e-3 * t : 0.;
    });
    TorqueParameters torque;
    torque.name       = "brake";
    torque.body       = "bar";
    torque.table.file = "table.csv";
    torque.read_table();
    const Mechanism mechanism([&]() {
      MechanismParameters p = pendulum();
      p.torques             = {torque};
      return p;
    }());
    report_below("torque, linear: error",
                 std::abs(mechanism.applied_torques()[0].compute_force(7.1)(2) -
                          1e-3),
                 1e-15);
  }
} // namespace

int
main()
{
  swing();
  turn();
  forces();
}
