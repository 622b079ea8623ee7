// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/units.h>
#include <tribody/case/given_duty_cycle.h>
#include <tribody/tables/csv_table.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // Relative to a spacing of times.
      constexpr double rounding = 1e-6;

      using Multibody::JointDutyCycle;

      // A joint and the time that its file is about.
      struct Record
      {
        JointDutyCycle  joint;
        Eigen::VectorXd time;
        double          period;
        unsigned int    n_cycles = 1;
      };



      double
      positive_angle(const double angle)
      {
        const double turn = 2. * dealii::numbers::PI;
        return angle - turn * std::floor(angle / turn);
      }



      double
      angle_of(const Eigen::Vector2d &force)
      {
        return positive_angle(std::atan2(force.y(), force.x()));
      }



      Eigen::Vector2d
      force_at(const double size, const double angle)
      {
        return size * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      }



      void
      resize(JointDutyCycle &joint, const Eigen::Index n)
      {
        for (Eigen::VectorXd *field : {&joint.normal_force,
                                       &joint.contact_angle_bushing,
                                       &joint.contact_angle_pin,
                                       &joint.sliding_increment,
                                       &joint.sliding_speed,
                                       &joint.force_x,
                                       &joint.force_y,
                                       &joint.friction_force,
                                       &joint.eccentricity,
                                       &joint.penetration,
                                       &joint.moment,
                                       &joint.point_x,
                                       &joint.point_y})
          field->setZero(n);
        joint.state.assign(n, Multibody::ContactState::following);
        joint.sliding_halves.setZero(2 * n);
        joint.force_between.setZero(n + 1);
        joint.angle_between.setZero(n + 1);
      }



      Eigen::VectorXd
      rising_times(const CsvTable &table)
      {
        const Eigen::VectorXd time = table.column("time", "s");
        AssertThrow(time.size() >= 3,
                    ExcInput(table.file_name() +
                             ": a cycle takes at least three rows"));
        for (Eigen::Index i = 1; i < time.size(); ++i)
          AssertThrow(time[i] > time[i - 1],
                      ExcInput(table.location(i) + ": the time " +
                               significant_digits(time[i], 9) +
                               " s does not come after that of the row "
                               "before"));
        return time;
      }



      // In the axes of the bushing, one column per row of the table.
      Eigen::Matrix2Xd
      read_forces(const CsvTable &table)
      {
        Eigen::Matrix2Xd forces(2, table.n_rows());
        if (table.has_column("force_x") || !table.has_column("force"))
          {
            forces.row(0) = table.column("force_x", "N");
            forces.row(1) = table.column("force_y", "N");
            return forces;
          }
        const Eigen::VectorXd size  = table.column("force", "N");
        const Eigen::VectorXd angle = table.column("force_angle", "rad", "deg");
        for (Eigen::Index i = 0; i < table.n_rows(); ++i)
          {
            AssertThrow(size[i] >= 0.,
                        ExcInput(table.location(i) + ": the force " +
                                 significant_digits(size[i], 6) +
                                 " N is negative; turn its 'force_angle' by "
                                 "180 deg instead"));
            forces.col(i) = force_at(size[i], angle[i]);
          }
        return forces;
      }



      Record
      read_time_record(const CsvTable &table, const double radius)
      {
        const Eigen::VectorXd  time   = rising_times(table);
        const Eigen::Matrix2Xd forces = read_forces(table);
        const Eigen::VectorXd  angle  = table.column("pin_angle", "rad", "deg");
        const Eigen::Index     n      = time.size() - 1;

        Record record;
        record.period         = time[n] - time[0];
        record.time           = 0.5 * (time.head(n) + time.tail(n));
        JointDutyCycle &joint = record.joint;
        resize(joint, n);
        joint.durations.resize(n);
        for (Eigen::Index i = 0; i <= n; ++i)
          {
            joint.force_between[i] = forces.col(i).norm();
            joint.angle_between[i] = angle_of(forces.col(i));
          }
        for (Eigen::Index i = 0; i < n; ++i)
          {
            const double turned = std::abs(angle[i + 1] - angle[i]);
            AssertThrow(turned <= dealii::numbers::PI,
                        ExcInput(
                          table.location(i + 1) +
                          ": since the row before the pin "
                          "has turned by " +
                          significant_digits(Units::degrees(turned), 6) +
                          " deg. 'pin_angle' goes on beyond a turn, to 370 deg "
                          "and not to 10; or there are too few rows"));
            const Eigen::Vector2d force =
              0.5 * (forces.col(i) + forces.col(i + 1));
            joint.force_x[i]               = force.x();
            joint.force_y[i]               = force.y();
            joint.normal_force[i]          = force.norm();
            joint.contact_angle_bushing[i] = angle_of(force);
            joint.contact_angle_pin[i]     = positive_angle(
              joint.contact_angle_bushing[i] - 0.5 * (angle[i] + angle[i + 1]));
            joint.durations[i]         = time[i + 1] - time[i];
            joint.sliding_increment[i] = radius * turned;
            joint.sliding_speed[i] =
              joint.sliding_increment[i] / joint.durations[i];
            joint.sliding_halves.segment<2>(2 * i).setConstant(
              0.5 * joint.sliding_increment[i]);
          }
        return record;
      }



      // How many cycles one after the other the rows are of.
      unsigned int
      count_cycles(const CsvTable &table)
      {
        if (!table.has_column("phase"))
          return 1;
        const Eigen::VectorXd phase = table.column("phase", "rad", "deg");
        unsigned int          n     = 1;
        for (Eigen::Index i = 1; i < phase.size(); ++i)
          n += phase[i] <= phase[i - 1];
        AssertThrow(phase.size() % n == 0,
                    ExcInput(table.file_name() + ": the rows are " +
                             std::to_string(n) +
                             " cycles, and not of the same length"));
        return n;
      }



      Record
      read_own_record(const CsvTable &table)
      {
        const Eigen::VectorXd time    = rising_times(table);
        const Eigen::Index    n       = time.size();
        const double          spacing = (time[n - 1] - time[0]) / (n - 1);
        for (Eigen::Index i = 1; i < n; ++i)
          AssertThrow(std::abs(time[i] - time[i - 1] - spacing) <=
                        std::sqrt(rounding) * spacing,
                      ExcInput(table.location(i) +
                               ": a row is a sample, and samples are at equal "
                               "times"));
        Record record;
        record.n_cycles       = count_cycles(table);
        record.period         = spacing * n / record.n_cycles;
        record.time           = time;
        JointDutyCycle &joint = record.joint;
        resize(joint, n);
        joint.normal_force = table.column("normal_force", "N");
        joint.contact_angle_bushing =
          table.column("contact_angle_bushing", "rad", "deg");
        joint.contact_angle_pin =
          table.column("contact_angle_pin", "rad", "deg");
        joint.sliding_increment = table.column("sliding_increment", "m");
        for (Eigen::Index i = 0; i < n; ++i)
          AssertThrow(joint.normal_force[i] >= 0. &&
                        joint.sliding_increment[i] >= 0.,
                      ExcInput(table.location(i) +
                               ": the normal force or the sliding is "
                               "negative"));
        joint.sliding_speed =
          joint.sliding_increment * (record.n_cycles / spacing);
        const auto force = [&joint](const Eigen::Index i) {
          return force_at(joint.normal_force[i],
                          joint.contact_angle_bushing[i]);
        };
        for (Eigen::Index i = 0; i <= n; ++i)
          {
            const Eigen::Vector2d between =
              0.5 * (force((i + n - 1) % n) + force(i % n));
            joint.force_between[i] = between.norm();
            joint.angle_between[i] = angle_of(between);
          }
        for (Eigen::Index i = 0; i < n; ++i)
          {
            joint.force_x[i] = force(i).x();
            joint.force_y[i] = force(i).y();
            joint.sliding_halves.segment<2>(2 * i).setConstant(
              0.5 * joint.sliding_increment[i]);
          }
        return record;
      }



      Record
      read_record(const GivenLoads &loads)
      {
        const CsvTable table(loads.file_name);
        const bool     is_own = table.has_column("sliding_increment") &&
                            table.has_column("contact_angle_bushing");
        Record record        = is_own ? read_own_record(table)
                                      : read_time_record(table, loads.bushing_radius);
        record.joint.name    = loads.joint;
        record.joint.has_gap = true;
        record.joint.friction_force =
          loads.friction_coefficient * record.joint.normal_force;
        record.joint.state_shares = {{0., 0., 1.}};
        AssertThrow(record.joint.normal_force.maxCoeff() > 0.,
                    ExcInput(loads.file_name + ": there is no force"));
        return record;
      }



      // Errors name the parameter, too.
      Record
      read_parameter(const GivenLoads &loads)
      {
        try
          {
            return read_record(loads);
          }
        catch (const ExcInput &exception)
          {
            throw ExcParameter("Bushing " + loads.joint + "/Duty cycle file",
                               message_of(exception));
          }
      }



      // As far as a mechanism would have it.
      void
      set_energy(Multibody::EnergyHistory &energy, const Eigen::Index n)
      {
        energy.kinetic   = Eigen::VectorXd::Zero(n);
        energy.potential = Eigen::VectorXd::Zero(n);
        energy.samples.resize(n);
      }
    } // namespace



    Multibody::DutyCycle
    read_duty_cycle(const std::vector<GivenLoads> &joints)
    {
      Multibody::DutyCycle cycle;
      for (const GivenLoads &loads : joints)
        {
          const Record record = read_parameter(loads);
          if (cycle.joints.empty())
            {
              cycle.period                     = record.period;
              cycle.time                       = record.time;
              cycle.settling.n_averaged_cycles = record.n_cycles;
            }
          AssertThrow(
            record.time.size() == cycle.time.size() &&
              record.n_cycles == cycle.settling.n_averaged_cycles &&
              (record.time - cycle.time).cwiseAbs().maxCoeff() <=
                rounding * cycle.period,
            ExcParameter(
              "Bushing " + loads.joint + "/Duty cycle file",
              loads.file_name + " has not the times of " +
                joints.front().file_name +
                "; the duty cycles of all joints have the same rows"));
          cycle.joints.push_back(record.joint);
        }
      const Eigen::Index n = cycle.time.size();
      cycle.phase          = Eigen::VectorXd(n);
      for (Eigen::Index i = 0; i < n; ++i)
        cycle.phase[i] =
          360. * std::fmod((cycle.time[i] - cycle.time[0]) / cycle.period, 1.);
      cycle.coordinates.resize(0, n);
      cycle.velocities.resize(0, n);
      cycle.accelerations.resize(0, n);
      set_energy(cycle.energy, n);
      cycle.settling.converged = true;
      cycle.is_quasi_static    = true;
      return cycle;
    }
  } // namespace Coupling
} // namespace Tribody
