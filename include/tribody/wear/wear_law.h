// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_wear_wear_law_h
#define tribody_wear_wear_law_h

#include <Eigen/Core>

#include <tribody/wear/archard_law.h>
#include <tribody/wear/coefficient_factor.h>

#include <vector>

namespace Tribody
{
  namespace Wear
  {
    /**
     * What one surface loses: Archard's law with a coefficient that may depend
     * on pressure, sliding speed, the distance slid so far and temperature,
     * @f[ \Delta h = k \prod_m f_m(p, v, s, T)\; p\,|\Delta s|, @f]
     * each @f$f_m@f$ a CoefficientFactor. Like ArchardLaw it removes areas,
     * @f$ A_i = k \prod_m f_m(\lambda_i/w_i, v, s, T)\,\lambda_i |\Delta s|
     * @f$. Without factors it is ArchardLaw and as fast.
     */
    struct WearLaw
    {
      /// The constant part k.
      ArchardLaw archard;
      /// All f_m; their order does not matter.
      std::vector<CoefficientFactor> factors;

      /// Whether the coefficient depends on nothing.
      bool
      is_constant() const
      {
        return factors.empty();
      }

      /// Whether a change of the temperature would change it.
      bool
      depends_on_temperature() const;

      /**
       * Cross-section area removed from each node in one sample [m^2].
       * @param nodal_forces per axial length [N/m]; iterations that hold nodes
       *   by tension see the law continued as an odd function.
       * @param weights w of the nodes [m].
       */
      Eigen::VectorXd
      area_increments(const Eigen::VectorXd &nodal_forces,
                      const Eigen::VectorXd &weights,
                      const Sliding         &sliding) const;

      /// Derivatives of the area_increments with respect to the force of the
      /// same node [m^2 per N/m]. A coefficient that depends on the pressure
      /// is not asked where there is none: zero.
      Eigen::VectorXd
      area_derivatives(const Eigen::VectorXd &nodal_forces,
                       const Eigen::VectorXd &weights,
                       const Sliding         &sliding) const;

    private:
      FactorValue
      evaluate(const double pressure, const Sliding &sliding) const;
    };
  } // namespace Wear
} // namespace Tribody

#endif
