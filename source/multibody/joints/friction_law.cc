// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/joints/friction_law.h>
#include <tribody/multibody/joints/joint_parameters.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      // Parts of v_0 at which tanh, and part of the friction of slipping at
      // which that of a law with memory, is one for all that matters.
      constexpr double saturated = 3., nearly_all = 0.99;



      StribeckCurve
      stribeck_curve(const JointParameters &joint)
      {
        return {joint.friction_coefficient,
                joint.static_friction_coefficient,
                joint.stribeck_speed};
      }
    } // namespace



    NoFriction
    NoFriction::make(const JointParameters & /*joint*/)
    {
      return {};
    }



    FrictionRatio
    NoFriction::ratio(const double /*sliding_speed*/) const
    {
      return {};
    }



    double
    NoFriction::transition_speed() const
    {
      return infinity;
    }



    bool
    NoFriction::holds(const double /*sliding_speed*/,
                      const double /*ratio*/) const
    {
      return false;
    }



    RegularisedCoulombFriction
    RegularisedCoulombFriction::make(const JointParameters &joint)
    {
      return {joint.friction_coefficient, joint.friction_regularisation_speed};
    }



    FrictionRatio
    RegularisedCoulombFriction::ratio(const double sliding_speed) const
    {
      const double s = std::tanh(sliding_speed / regularisation_speed);
      return {coefficient * s,
              coefficient * (1 - s * s) / regularisation_speed,
              0.};
    }



    double
    RegularisedCoulombFriction::transition_speed() const
    {
      return coefficient > 0 ? regularisation_speed : infinity;
    }



    bool
    RegularisedCoulombFriction::holds(const double sliding_speed,
                                      const double /*ratio*/) const
    {
      return coefficient > 0 &&
             std::abs(sliding_speed) < saturated * regularisation_speed;
    }



    AmbrosioFriction
    AmbrosioFriction::make(const JointParameters &joint)
    {
      return {joint.friction_coefficient,
              joint.friction_lower_speed,
              joint.friction_upper_speed};
    }



    FrictionRatio
    AmbrosioFriction::ratio(const double sliding_speed) const
    {
      const double signed_coefficient =
        std::copysign(coefficient, sliding_speed);
      const double range = upper_speed - lower_speed;
      const double part  = (std::abs(sliding_speed) - lower_speed) / range;
      if (part <= 0)
        return {};
      if (part >= 1)
        return {signed_coefficient, 0., 0.};
      return {signed_coefficient * part, coefficient / range, 0.};
    }



    double
    AmbrosioFriction::transition_speed() const
    {
      return coefficient > 0 ? upper_speed - lower_speed : infinity;
    }



    bool
    AmbrosioFriction::holds(const double sliding_speed,
                            const double /*ratio*/) const
    {
      return coefficient > 0 && std::abs(sliding_speed) < upper_speed;
    }



    double
    StribeckCurve::value(const double speed) const
    {
      const double x = speed / stribeck_speed;
      return kinetic_coefficient +
             (static_coefficient - kinetic_coefficient) * std::exp(-x * x);
    }



    double
    StribeckCurve::derivative(const double speed) const
    {
      const double x = speed / stribeck_speed;
      return -2 * x / stribeck_speed *
             (static_coefficient - kinetic_coefficient) * std::exp(-x * x);
    }



    StribeckFriction
    StribeckFriction::make(const JointParameters &joint)
    {
      return {stribeck_curve(joint),
              joint.friction_regularisation_speed,
              joint.viscous_friction};
    }



    FrictionRatio
    StribeckFriction::ratio(const double sliding_speed) const
    {
      const double s = std::tanh(sliding_speed / regularisation_speed);
      const double g = curve.value(sliding_speed);
      return {g * s + viscous_coefficient * sliding_speed,
              curve.derivative(sliding_speed) * s +
                g * (1 - s * s) / regularisation_speed + viscous_coefficient,
              0.};
    }



    double
    StribeckFriction::transition_speed() const
    {
      return curve.static_coefficient > 0 ? regularisation_speed : infinity;
    }



    bool
    StribeckFriction::holds(const double sliding_speed,
                            const double /*ratio*/) const
    {
      return curve.static_coefficient > 0 &&
             std::abs(sliding_speed) < saturated * regularisation_speed;
    }



    LuGreFriction
    LuGreFriction::make(const JointParameters &joint)
    {
      return {stribeck_curve(joint),
              joint.bristle_stiffness,
              joint.bristle_damping,
              joint.viscous_friction};
    }



    FrictionStateRate
    LuGreFriction::state_rate(const double sliding_speed,
                              const double state) const
    {
      const double g    = curve.value(sliding_speed);
      const double slip = bristle_stiffness * std::abs(sliding_speed) / g;
      const double d_slip =
        std::copysign(bristle_stiffness / g, sliding_speed) -
        slip * curve.derivative(sliding_speed) / g;
      return {sliding_speed - slip * state, 1 - d_slip * state, -slip};
    }



    FrictionRatio
    LuGreFriction::ratio(const double sliding_speed, const double state) const
    {
      const FrictionStateRate rate = state_rate(sliding_speed, state);
      return {bristle_stiffness * state + bristle_damping * rate.value +
                viscous_coefficient * sliding_speed,
              bristle_damping * rate.d_sliding_speed + viscous_coefficient,
              bristle_stiffness + bristle_damping * rate.d_state};
    }



    double
    LuGreFriction::steady_state(const double sliding_speed) const
    {
      if (sliding_speed == 0)
        return 0.;
      return std::copysign(curve.value(sliding_speed), sliding_speed) /
             bristle_stiffness;
    }



    double
    LuGreFriction::transition_speed() const
    {
      // Friction follows the displacement; the speed acts through the damping.
      return curve.static_coefficient / (bristle_damping + viscous_coefficient);
    }



    bool
    LuGreFriction::holds(const double sliding_speed, const double ratio) const
    {
      return std::abs(ratio) < nearly_all * curve.value(sliding_speed);
    }



    bool
    has_state(const FrictionLaw &law)
    {
      return std::holds_alternative<LuGreFriction>(law);
    }



    FrictionRatio
    compute_friction_ratio(const FrictionLaw &law,
                           const double       sliding_speed,
                           const double       state)
    {
      return std::visit(
        [&](const auto &chosen) -> FrictionRatio {
          using Law = std::decay_t<decltype(chosen)>;
          if constexpr (std::is_same_v<Law, LuGreFriction>)
            return chosen.ratio(sliding_speed, state);
          else
            return chosen.ratio(sliding_speed);
        },
        law);
    }



    FrictionStateRate
    compute_friction_state_rate(const FrictionLaw &law,
                                const double       sliding_speed,
                                const double       state)
    {
      const auto *lugre = std::get_if<LuGreFriction>(&law);
      return lugre ? lugre->state_rate(sliding_speed, state)
                   : FrictionStateRate();
    }



    double
    compute_steady_friction_state(const FrictionLaw &law,
                                  const double       sliding_speed)
    {
      const auto *lugre = std::get_if<LuGreFriction>(&law);
      return lugre ? lugre->steady_state(sliding_speed) : 0.;
    }



    double
    compute_transition_speed(const FrictionLaw &law)
    {
      return std::visit(
        [](const auto &chosen) { return chosen.transition_speed(); }, law);
    }



    bool
    friction_holds(const FrictionLaw &law,
                   const double       sliding_speed,
                   const double       ratio)
    {
      return std::visit(
        [&](const auto &chosen) { return chosen.holds(sliding_speed, ratio); },
        law);
    }
  } // namespace Multibody
} // namespace Tribody
