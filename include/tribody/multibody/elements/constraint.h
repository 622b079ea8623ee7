// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_constraint_h
#define tribody_multibody_elements_constraint_h

#include <tribody/multibody/elements/body_pair.h>

#include <string>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * One to three scalar equations @f$\Phi(q,t)=0@f$ between two bodies, with
     * all the derivatives that the equations of motion and their Jacobian
     * need. It is assumed that @f$\Phi_{qt}=0@f$. With less than three
     * equations, the last rows of everything are zero.
     *
     * To add a joint: derive from this class, and make it in
     * Mechanism::add_joint().
     */
    class Constraint
    {
    public:
      /// Of all kinds: a rigid joint has this many.
      static constexpr unsigned int max_equations = 3;

      /// One entry per equation: values or multipliers.
      using Values = Eigen::Matrix<double, max_equations, 1>;
      /// One row per equation, one column per coordinate of the two bodies.
      using Jacobian = Eigen::Matrix<double, max_equations, 6>;

      /// @param description for messages, see the member.
      Constraint(const std::string &description,
                 const BodyPair    &bodies,
                 const unsigned int n_equations)
        : description(description)
        , bodies(bodies)
        , n_equations(n_equations)
      {}

      virtual ~Constraint() = default;

      /// @f$\Phi@f$ [m or rad] at time @p t [s].
      virtual Values
      value(const double t, const PairVector &q) const = 0;

      /// @f$\Phi_q@f$.
      virtual Jacobian
      jacobian(const PairVector &q) const = 0;

      /// @f$\sum_k w_k\,\partial^2\Phi_k/\partial q^2@f$, symmetric.
      virtual PairMatrix
      weighted_hessian(const PairVector &q, const Values &weights) const = 0;

      /// @f$\Phi_t@f$.
      virtual Values
      time_derivative(const double /*t*/) const
      {
        return Values::Zero();
      }

      /// @f$\Phi_{tt}@f$.
      virtual Values
      second_time_derivative(const double /*t*/) const
      {
        return Values::Zero();
      }

      /// Whether equation @p i is one between angles [rad], not lengths [m].
      virtual bool
      is_angle(const unsigned int i) const = 0;

      /// Force of the first body on the second [N], in global axes.
      virtual Eigen::Vector2d
      reaction_force(const PairVector &q, const Values &multipliers) const = 0;

      /// This constraint's part of all values or multipliers, which begins at
      /// @p first_row.
      Values
      gather(const Eigen::Ref<const Eigen::VectorXd> &global,
             const unsigned int                       first_row) const
      {
        Values local            = Values::Zero();
        local.head(n_equations) = global.segment(first_row, n_equations);
        return local;
      }

      /// "Joint crank_pin", as in the parameter file.
      const std::string description;
      /// The bodies that it connects.
      const BodyPair bodies;
      /// From 1 to max_equations.
      const unsigned int n_equations;
    };
  } // namespace Multibody
} // namespace Tribody

#endif
