// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_assembly_redundancy_h
#define tribody_multibody_assembly_redundancy_h

#include <Eigen/Core>

#include <tribody/multibody/system/mechanism_parameters.h>

#include <string>

namespace Tribody
{
  namespace Multibody
  {
    class EquationsOfMotion;

    /// Newton's method ends up to 1e-6 of the size away from a singular
    /// position, and the rows of Phi_q, of length one, are dependent to that
    /// only.
    constexpr double singular_threshold = 1e-5;

    /// Constraints that depend on each other.
    struct DependentConstraints
    {
      /// How many are too many.
      unsigned int n = 0;
      /// Joints and drivers of the shortest combination that vanishes.
      std::string names;
    };

    /// Those at @p q whose rows of Phi_q, of length one, depend on each other
    /// to @p threshold.
    DependentConstraints
    find_dependent_constraints(const EquationsOfMotion &equations,
                               const Eigen::VectorXd   &q,
                               const double threshold = singular_threshold);

    /**
     * The same mechanism with MechanismParameters::n_redundant counted: the
     * constraints of joints that follow from those of others not only where it
     * is assembled but also beside that, as of a scissor lift that is guided on
     * each level. A position that is only singular has none, and drivers have
     * none, as they may contradict later on.
     * @throws ExcParameter if it cannot be assembled.
     */
    MechanismParameters
    count_redundant_constraints(const MechanismParameters &parameters);

    /// For the user: what is redundant at @p q, and what it means for the
    /// results. Empty if nothing is.
    std::string
    describe_redundancy(const EquationsOfMotion &equations,
                        const Eigen::VectorXd   &q);
  } // namespace Multibody
} // namespace Tribody

#endif
