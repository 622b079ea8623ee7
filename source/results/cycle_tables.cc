// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/units.h>
#include <tribody/results/cycle_tables.h>
#include <tribody/tables/table_writer.h>

#include <cmath>
#include <string>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // In [0, 360).
      double
      positive_degrees(const double radians)
      {
        const double angle = std::fmod(Units::degrees(radians), 360.);
        return angle < 0. ? angle + 360. : angle;
      }



      void
      write_clearance_joint(const std::string               &file_name,
                            const Multibody::DutyCycle      &cycle,
                            const Multibody::JointDutyCycle &joint)
      {
        TableWriter table(
          file_name,
          {"Revolute joint '" + joint.name +
             "' with clearance: one settled cycle.",
           "Forces act on the body with the bushing: normal_force along the "
           "contact direction (from the bushing's centre to the contact "
           "point), "
           "friction_force along that direction turned by +90 deg;",
           "force_x, force_y: their sum in global axes. contact_angle_bushing "
           "and contact_angle_pin: the contact direction in the frames of the "
           "two bodies, counter-clockwise.",
           "state: 0 free, 1 impact, 2 following. moment: of the forces about "
           "the centre of the bushing, which is at point_x, point_y in global "
           "axes."},
          {"time [s]",
           "phase [deg]",
           "normal_force [N]",
           "friction_force [N]",
           "contact_angle_bushing [deg]",
           "contact_angle_pin [deg]",
           "sliding_increment [m]",
           "eccentricity [m]",
           "penetration [m]",
           "state [-]",
           "force_x [N]",
           "force_y [N]",
           "force [N]",
           "moment [N m]",
           "point_x [m]",
           "point_y [m]"});
        for (Eigen::Index j = 0; j < cycle.time.size(); ++j)
          table.write_row({cycle.time[j],
                           cycle.phase[j],
                           joint.normal_force[j],
                           joint.friction_force[j],
                           positive_degrees(joint.contact_angle_bushing[j]),
                           positive_degrees(joint.contact_angle_pin[j]),
                           joint.sliding_increment[j],
                           joint.eccentricity[j],
                           joint.penetration[j],
                           static_cast<double>(joint.state[j]),
                           joint.force_x[j],
                           joint.force_y[j],
                           std::hypot(joint.force_x[j], joint.force_y[j]),
                           joint.moment[j],
                           joint.point_x[j],
                           joint.point_y[j]});
        table.finish();
      }



      void
      write_ideal_joint(const std::string               &file_name,
                        const Multibody::DutyCycle      &cycle,
                        const Multibody::JointDutyCycle &joint)
      {
        TableWriter table(file_name,
                          {"Joint '" + joint.name +
                             "' without clearance: one settled cycle.",
                           "Force of the pin (first body) on the bushing "
                           "(second body), in global axes.",
                           "moment: on the second body about its marker, which "
                           "is at point_x, point_y in global axes; positive "
                           "counter-clockwise."},
                          {"time [s]",
                           "phase [deg]",
                           "force_x [N]",
                           "force_y [N]",
                           "force [N]",
                           "moment [N m]",
                           "point_x [m]",
                           "point_y [m]"});
        for (Eigen::Index j = 0; j < cycle.time.size(); ++j)
          table.write_row({cycle.time[j],
                           cycle.phase[j],
                           joint.force_x[j],
                           joint.force_y[j],
                           std::hypot(joint.force_x[j], joint.force_y[j]),
                           joint.moment[j],
                           joint.point_x[j],
                           joint.point_y[j]});
        table.finish();
      }



      void
      write_contacts(const std::string               &file_name,
                     const Multibody::DutyCycle      &cycle,
                     const Multibody::JointDutyCycle &joint)
      {
        TableWriter table(
          file_name,
          {"Contacts of the revolute joint '" + joint.name +
             "' in the recorded cycle, also those that lie in it in part.",
           "onset_phase: negative if before the cycle. approach_speed: of the "
           "pin towards the bushing's surface at the onset; separation_speed: "
           "away from it at the loss.",
           "state: 1 impact (shorter than the interval between samples), 2 "
           "following. begun, ended: 0 if the contact was there at the start "
           "of the motion, or is still there at the end of the record."},
          {"onset [s]",
           "onset_phase [deg]",
           "loss [s]",
           "duration [s]",
           "approach_speed [m/s]",
           "separation_speed [m/s]",
           "peak_force [N]",
           "state [-]",
           "begun [-]",
           "ended [-]"});
        for (const Multibody::ContactInterval &contact : joint.contacts)
          table.write_row(
            {contact.onset,
             cycle.phase[0] +
               360. * (contact.onset - cycle.time[0]) / cycle.period,
             contact.loss,
             contact.loss - contact.onset,
             contact.approach_speed,
             contact.separation_speed,
             contact.peak_force,
             static_cast<double>(contact.state),
             static_cast<double>(contact.has_onset),
             static_cast<double>(contact.has_loss)});
        table.finish();
      }



      void
      write_body(const std::string          &file_name,
                 const Multibody::DutyCycle &cycle,
                 const std::string          &name,
                 const unsigned int          body)
      {
        TableWriter table(file_name,
                          {"Body '" + name + "': one settled cycle.",
                           "Position, velocity and acceleration of its centre "
                           "of mass in global axes; angle, angular velocity "
                           "and acceleration of its frame, positive "
                           "counter-clockwise."},
                          {"time [s]",
                           "phase [deg]",
                           "x [m]",
                           "y [m]",
                           "angle [deg]",
                           "velocity_x [m/s]",
                           "velocity_y [m/s]",
                           "angular_velocity [rad/s]",
                           "acceleration_x [m/s^2]",
                           "acceleration_y [m/s^2]",
                           "angular_acceleration [rad/s^2]"});
        for (Eigen::Index j = 0; j < cycle.time.size(); ++j)
          {
            const Eigen::Vector3d q =
              cycle.coordinates.col(j).segment<3>(3 * body);
            const Eigen::Vector3d v =
              cycle.velocities.col(j).segment<3>(3 * body);
            const Eigen::Vector3d a =
              cycle.accelerations.col(j).segment<3>(3 * body);
            table.write_row({cycle.time[j],
                             cycle.phase[j],
                             q(0),
                             q(1),
                             Units::degrees(q(2)),
                             v(0),
                             v(1),
                             v(2),
                             a(0),
                             a(1),
                             a(2)});
          }
        table.finish();
      }



      void
      write_driver(const std::string                &file_name,
                   const Multibody::DutyCycle       &cycle,
                   const Multibody::DriverDutyCycle &driver)
      {
        TableWriter table(file_name,
                          {"Driver '" + driver.name + "': one settled cycle.",
                           "Force and moment on the driven body, in global "
                           "axes; the moment about its centre of mass, "
                           "positive counter-clockwise. power: into the "
                           "mechanism."},
                          {"time [s]",
                           "phase [deg]",
                           "force_x [N]",
                           "force_y [N]",
                           "moment [N m]",
                           "power [W]"});
        for (Eigen::Index j = 0; j < cycle.time.size(); ++j)
          table.write_row({cycle.time[j],
                           cycle.phase[j],
                           driver.force_x[j],
                           driver.force_y[j],
                           driver.moment[j],
                           driver.power[j]});
        table.finish();
      }



      void
      write_watched_path(const std::string            &file_name,
                         const Multibody::DutyCycle   &cycle,
                         const Multibody::WatchedPath &path)
      {
        TableWriter table(file_name,
                          {"Marker '" + path.name +
                             "': its path in one settled cycle, beside the "
                             "path with ideal joints at the same times.",
                           "Positions in global axes. deviation: the distance "
                           "between the two."},
                          {"time [s]",
                           "phase [deg]",
                           "x [m]",
                           "y [m]",
                           "ideal_x [m]",
                           "ideal_y [m]",
                           "deviation [m]"});
        for (Eigen::Index j = 0; j < cycle.time.size(); ++j)
          table.write_row({cycle.time[j],
                           cycle.phase[j],
                           path.position(0, j),
                           path.position(1, j),
                           path.ideal(0, j),
                           path.ideal(1, j),
                           path.deviation[j]});
        table.finish();
      }



      void
      write_energy(const std::string          &file_name,
                   const Multibody::DutyCycle &cycle)
      {
        std::vector<std::string> columns  = {"time [s]",
                                             "phase [deg]",
                                             "kinetic_energy [J]",
                                             "potential_energy [J]"};
        std::vector<std::string> comments = {
          "Energies of the mechanism: one settled cycle. potential_energy: of "
          "gravity and springs."};
        const bool has_work = cycle.energy.cycle.has_work;
        if (has_work)
          {
            comments.emplace_back(
              "Work of drivers and of forces given as functions of time, work "
              "against contacts and losses count from the beginning of the "
              "cycle, half an interval before the first row.");
            comments.emplace_back(
              "balance_error: work minus the changes of kinetic, potential and "
              "contact energy minus losses; zero for an exact motion.");
            columns.insert(columns.end(),
                           {"driver_work [J]",
                            "force_work [J]",
                            "damper_loss [J]",
                            "impact_loss [J]",
                            "balance_error [J]"});
            for (const Multibody::JointDutyCycle &joint : cycle.joints)
              if (joint.has_contact_law)
                for (const char *column : {" contact_energy [J]",
                                           " normal_loss [J]",
                                           " friction_loss [J]"})
                  columns.push_back(joint.name + column);
          }
        TableWriter table(file_name, comments, columns);
        for (Eigen::Index j = 0; j < cycle.time.size(); ++j)
          {
            const Multibody::EnergyRecord &energy = cycle.energy.samples[j];
            std::vector<double>            row    = {cycle.time[j],
                                                     cycle.phase[j],
                                                     cycle.energy.kinetic[j],
                                                     cycle.energy.potential[j]};
            if (has_work)
              {
                row.insert(row.end(),
                           {energy.driver_work,
                            energy.force_work,
                            energy.damper_loss,
                            energy.impact_loss,
                            energy.balance_error()});
                for (Eigen::Index i = 0; i < energy.normal_loss.size(); ++i)
                  row.insert(row.end(),
                             {energy.contact_energy[i],
                              energy.normal_loss[i],
                              energy.friction_loss[i]});
              }
            table.write_row(row);
          }
        table.finish();
      }
    } // namespace



    void
    write_cycle_tables(const Output::OutputDirectory        &directory,
                       const Multibody::MechanismParameters &mechanism,
                       const Multibody::DutyCycle           &cycle,
                       const std::string                    &load_case,
                       const unsigned int                    number)
    {
      const std::string suffix   = load_case.empty() ? "" : "_" + load_case;
      const auto        numbered = [&](const std::string &stem) {
        return Output::numbered_name(stem + suffix, number, "csv");
      };
      for (const Multibody::JointDutyCycle &joint : cycle.joints)
        {
          const std::string file_name =
            directory.joint_file(joint.name, numbered("duty_cycle"));
          if (!joint.has_gap)
            {
              write_ideal_joint(file_name, cycle, joint);
              continue;
            }
          write_clearance_joint(file_name, cycle, joint);
          write_contacts(directory.joint_file(joint.name, numbered("contacts")),
                         cycle,
                         joint);
        }
      for (std::size_t i = 0; i < mechanism.bodies.size(); ++i)
        write_body(directory.joint_file("bodies",
                                        numbered(mechanism.bodies[i].name)),
                   cycle,
                   mechanism.bodies[i].name,
                   i);
      for (const Multibody::DriverDutyCycle &driver : cycle.drivers)
        write_driver(directory.joint_file("drivers", numbered(driver.name)),
                     cycle,
                     driver);
      for (const Multibody::WatchedPath &path : cycle.watched_paths)
        write_watched_path(directory.joint_file("watched_markers",
                                                numbered(path.name)),
                           cycle,
                           path);
      write_energy(directory.file(numbered("energy")), cycle);
    }
  } // namespace Coupling
} // namespace Tribody
