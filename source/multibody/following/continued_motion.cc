// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/following/continued_motion.h>
#include <tribody/multibody/following/following_pins.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>

namespace Tribody
{
  namespace Multibody
  {
    MotionEnd
    make_motion_end(const EquationsOfMotion &equations,
                    const MechanismState    &state)
    {
      const std::size_t n = equations.mechanism().clearance_joints().size();
      MotionEnd         end{state, Eigen::VectorXd(n)};
      for (std::size_t j = 0; j < n; ++j)
        end.penetrations(j) = equations.compute_penetration(j, state.q);
      return end;
    }



    MechanismState
    continue_in_worn_bores(const EquationsOfMotion &equations,
                           const EquationsOfMotion &closed,
                           const MotionEnd         &end)
    {
      // The way to the bore turns with the place on it.
      constexpr unsigned int n_rounds = 3;
      const FollowingPins    pins(equations, closed);
      MechanismState         state = end.state;
      for (unsigned int round = 0; round < n_rounds; ++round)
        {
          Eigen::Matrix2Xd eccentricities(2, pins.joints().size());
          for (std::size_t p = 0; p < pins.joints().size(); ++p)
            {
              const JointEntry &joint =
                equations.mechanism().joints()[pins.joints()[p]];
              if (joint.link != nullptr)
                {
                  eccentricities.col(p) =
                    joint.link->eccentricity(joint.bodies.gather(state.q));
                  continue;
                }
              const JointContact contact =
                equations.compute_contact(joint.index, state);
              eccentricities.col(p) = contact.eccentricity;
              if (const double depth = end.penetrations(joint.index); depth > 0)
                eccentricities.col(p) +=
                  (depth - contact.penetration) * contact.direction;
            }
          state.q = pins.place_at(state.time, state.q, eccentricities);
        }
      state.v =
        compute_nearest_velocities(equations, state.time, state.q, state.v);
      return state;
    }
  } // namespace Multibody
} // namespace Tribody
