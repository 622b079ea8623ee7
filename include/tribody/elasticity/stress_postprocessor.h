// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_elasticity_stress_postprocessor_h
#define tribody_elasticity_stress_postprocessor_h

#include <deal.II/numerics/data_postprocessor.h>

#include <tribody/elasticity/plane_state.h>

namespace Tribody
{
  namespace Elasticity
  {
    /**
     * Stresses [Pa] from a displacement field, for DataOut: the tensor in the
     * plane (stress), @f$\sigma_{zz}@f$ (axial_stress, zero in plane stress)
     * and von Mises' equivalent stress
     * @f[ \sigma_v = \sqrt{\tfrac12[(\sigma_{xx}-\sigma_{yy})^2
     *   + (\sigma_{yy}-\sigma_{zz})^2 + (\sigma_{zz}-\sigma_{xx})^2]
     *   + 3\sigma_{xy}^2}. @f]
     */
    class StressPostprocessor : public dealii::DataPostprocessor<2>
    {
    public:
      /// @param law of the material whose displacement is shown.
      explicit StressPostprocessor(const PlaneHooke &law);

      /// For DataOut: stresses from the gradients of the displacement.
      void
      evaluate_vector_field(
        const dealii::DataPostprocessorInputs::Vector<2> &inputs,
        std::vector<dealii::Vector<double>> &stresses) const override;

      std::vector<std::string>
      /// For DataOut: stress (four times, a tensor), axial_stress,
      /// von_mises_stress.
      get_names() const override;

      std::vector<
        dealii::DataComponentInterpretation::DataComponentInterpretation>
      /// For DataOut: which of the components form a tensor.
      get_data_component_interpretation() const override;

      /// For DataOut: gradients.
      dealii::UpdateFlags
      get_needed_update_flags() const override;

    private:
      PlaneHooke law;
    };
  } // namespace Elasticity
} // namespace Tribody

#endif
