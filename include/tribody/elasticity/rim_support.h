#ifndef tribody_elasticity_rim_support_h
#define tribody_elasticity_rim_support_h

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
  namespace Elasticity
  {
    /**
     * What holds a bushing at its rim: a rigid seat, u = 0 ("clamped"), or
     * springs spread over the rim ("elastic foundation") that push back with
     * @f[ \sigma n = -k_n (u \cdot n)\,n - k_t (u \cdot t)\,t, @f]
     * n and t being normal and tangent of the rim.
     */
    struct RimSupport
    {
      /// "clamped" or "elastic foundation".
      std::string kind = "clamped";
      /// k_n [N/m^3].
      double normal_stiffness = 0.;
      /// k_t [N/m^3]; 0: k_n.
      double tangential_stiffness = 0.;

      /// Declares in the current subsection.
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @param path of the subsection, for the message.
      /// @throws ExcParameter for springs that cannot hold the bushing.
      void
      check(const std::string &path) const;

      bool
      is_clamped() const
      {
        return kind == "clamped";
      }
    };

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
  } // namespace Elasticity
} // namespace Tribody

#endif
