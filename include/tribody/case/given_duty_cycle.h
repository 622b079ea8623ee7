// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_case_given_duty_cycle_h
#define tribody_case_given_duty_cycle_h

#include <tribody/multibody/cycle/duty_cycle.h>

#include <string>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /// A joint whose loads stand in a file.
    struct GivenLoads
    {
      /// Of the joint.
      std::string joint;
      /// That it is read from.
      std::string file_name;
      /// R_j [m].
      double bushing_radius;
      /// For the heat of friction; 0 where nobody asks for it [-].
      double friction_coefficient = 0.;
    };

    /**
     * A duty cycle from files of a rig, of another program, or of this one,
     * one for each joint that there is. Columns are those of
     * - a record in time: 'time', 'force_x' and 'force_y' of the pin on the
     *   bushing in the axes of the bushing, or 'force' and 'force_angle', and
     *   'pin_angle', the angle of the pin in the bushing, which goes on beyond
     *   a turn. From each row to the next is one sample, under the mean of both
     *   forces; the cycle is from the first row to the last;
     * - or a duty cycle of this program: 'time', 'phase', 'normal_force',
     *   'contact_angle_bushing', 'contact_angle_pin', 'sliding_increment'; a
     * row is a sample, at equal times.
     *
     * Friction is in the force or not as the file has it: all of it presses
     * on the bore. Where the pin is in its clearance is not known: zero.
     * @throws ExcParameter with file and line for what does not make a cycle.
     */
    Multibody::DutyCycle
    read_duty_cycle(const std::vector<GivenLoads> &joints);
  } // namespace Coupling
} // namespace Tribody

#endif
