// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/elasticity/stress_postprocessor.h>

#include <cmath>

namespace Tribody
{
  namespace Elasticity
  {
    StressPostprocessor::StressPostprocessor(const PlaneHooke &law)
      : law(law)
    {}



    void
    StressPostprocessor::evaluate_vector_field(
      const dealii::DataPostprocessorInputs::Vector<2> &inputs,
      std::vector<dealii::Vector<double>>              &stresses) const
    {
      for (std::size_t q = 0; q < inputs.solution_gradients.size(); ++q)
        {
          const auto  &grad  = inputs.solution_gradients[q];
          const double trace = grad[0][0] + grad[1][1];
          const double xx    = law.lambda * trace + 2. * law.mu * grad[0][0];
          const double yy    = law.lambda * trace + 2. * law.mu * grad[1][1];
          const double xy    = law.mu * (grad[0][1] + grad[1][0]);
          const double zz    = law.axial_ratio * (xx + yy);

          auto &stress = stresses[q];
          stress[0]    = xx;
          stress[1]    = xy;
          stress[2]    = xy;
          stress[3]    = yy;
          stress[4]    = zz;
          stress[5] =
            std::sqrt(0.5 * ((xx - yy) * (xx - yy) + (yy - zz) * (yy - zz) +
                             (zz - xx) * (zz - xx)) +
                      3. * xy * xy);
        }
    }



    std::vector<std::string>
    StressPostprocessor::get_names() const
    {
      return {"stress",
              "stress",
              "stress",
              "stress",
              "axial_stress",
              "von_mises_stress"};
    }



    std::vector<
      dealii::DataComponentInterpretation::DataComponentInterpretation>
    StressPostprocessor::get_data_component_interpretation() const
    {
      using namespace dealii::DataComponentInterpretation;
      return {component_is_part_of_tensor,
              component_is_part_of_tensor,
              component_is_part_of_tensor,
              component_is_part_of_tensor,
              component_is_scalar,
              component_is_scalar};
    }



    dealii::UpdateFlags
    StressPostprocessor::get_needed_update_flags() const
    {
      return dealii::update_gradients;
    }
  } // namespace Elasticity
} // namespace Tribody
