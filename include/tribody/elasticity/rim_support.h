// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_elasticity_rim_support_h
#define tribody_elasticity_rim_support_h

#include <tribody/base/choice.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
  template <typename Number>
  class AffineConstraints;
  template <int dim, int spacedim>
  class DoFHandler;
  template <int dim, int spacedim>
  class Mapping;

  namespace TrilinosWrappers
  {
    class SparseMatrix;
  }
} // namespace dealii

namespace Tribody
{
  struct BoreNodes;

  namespace Elasticity
  {
    /**
     * What holds a bushing at its rim: a rigid seat, u = 0 (clamped), or
     * springs spread over the rim (elastic foundation) that push back with
     * @f[ \sigma n = -k_n (u \cdot n)\,n - k_t (u \cdot t)\,t, @f]
     * n and t being normal and tangent of the rim; or nothing but the pressure
     * of a rigid, round and smooth bore around it (housing), in which it lies
     * with a gap. Keys keep it from turning, see assemble_keys().
     */
    struct RimSupport
    {
      /// What is at the rim, as above.
      enum class Kind
      {
        clamped,
        elastic_foundation,
        housing
      };

      /// Decides which of the values below count.
      Kind kind = Kind::clamped;
      /// k_n [N/m^3].
      double normal_stiffness = 0.;
      /// k_t [N/m^3]; 0: k_n.
      double tangential_stiffness = 0.;
      /// What the radius of the housing exceeds that of the rim by [m].
      double housing_gap = 0.;

      /// Declares in the current subsection.
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @param path of the subsection, for the message.
      /// @throws ExcParameter for springs or a housing that cannot hold the
      /// bushing.
      void
      check(const std::string &path) const;

      /// Whether the rim does not move at all.
      bool
      is_clamped() const
      {
        return kind == Kind::clamped;
      }

      /// Whether the ring is free and its rim has contacts of its own.
      bool
      is_housing() const
      {
        return kind == Kind::housing;
      }
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<RimSupport::Kind>
    choice_names(const RimSupport::Kind)
    {
      return {{RimSupport::Kind::clamped, "clamped"},
              {RimSupport::Kind::elastic_foundation, "elastic foundation"},
              {RimSupport::Kind::housing, "housing"}};
    }

    /**
     * Add the springs of @p support at BoundaryIds::rim to @p matrix, which
     * must be that of assemble_stiffness() with the same arguments.
     */
    void
    assemble_foundation(const dealii::Mapping<2, 2>             &mapping,
                        const dealii::DoFHandler<2, 2>          &dof_handler,
                        const dealii::AffineConstraints<double> &constraints,
                        const RimSupport                        &support,
                        dealii::TrilinosWrappers::SparseMatrix  &matrix);

    /**
     * Hold a free ring by three keys: springs along the rim, at three of the
     * nodes @p rim, a third of these apart. They add to
     * the stiffness @p matrix what it takes to be regular, and no more: under
     * forces in equilibrium they carry nothing; a moment they take by forces
     * along the rim that add up to zero. So the ring deforms as if it were
     * free, however stiff the keys.
     * @param stiffness of a key, per axial length [Pa].
     */
    void
    assemble_keys(const BoreNodes                        &rim,
                  const double                            stiffness,
                  dealii::TrilinosWrappers::SparseMatrix &matrix);
  } // namespace Elasticity
} // namespace Tribody

#endif
