// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/wear/wear_law.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Wear
  {
    bool
    WearLaw::depends_on_temperature() const
    {
      return std::any_of(factors.begin(),
                         factors.end(),
                         [](const CoefficientFactor &factor) {
                           return Wear::depends_on_temperature(factor);
                         });
    }



    FactorValue
    WearLaw::evaluate(const double pressure, const Sliding &sliding) const
    {
      FactorValue product;
      for (const CoefficientFactor &factor : factors)
        {
          const FactorValue f = evaluate_factor(factor, pressure, sliding);
          product.d_pressure =
            product.d_pressure * f.value + product.value * f.d_pressure;
          product.value *= f.value;
        }
      return product;
    }



    Eigen::VectorXd
    WearLaw::area_increments(const Eigen::VectorXd &nodal_forces,
                             const Eigen::VectorXd &weights,
                             const Sliding         &sliding) const
    {
      Eigen::VectorXd areas =
        (archard.wear_coefficient * sliding.increment * sliding.factor) *
        nodal_forces;
      if (!is_constant())
        for (Eigen::Index i = 0; i < areas.size(); ++i)
          if (areas[i] != 0.)
            areas[i] *=
              evaluate(std::abs(nodal_forces[i]) / weights[i], sliding).value;
      return areas;
    }



    Eigen::VectorXd
    WearLaw::area_derivatives(const Eigen::VectorXd &nodal_forces,
                              const Eigen::VectorXd &weights,
                              const Sliding         &sliding) const
    {
      // A = k ds f(p) lambda with p = lambda/w.
      const double k =
        archard.wear_coefficient * sliding.increment * sliding.factor;
      Eigen::VectorXd derivatives =
        Eigen::VectorXd::Constant(nodal_forces.size(), k);
      if (is_constant())
        return derivatives;
      for (Eigen::Index i = 0; i < derivatives.size(); ++i)
        if (nodal_forces[i] == 0.)
          derivatives[i] = 0.;
        else
          {
            const double      pressure = std::abs(nodal_forces[i]) / weights[i];
            const FactorValue f        = evaluate(pressure, sliding);
            derivatives[i] = k * (f.value + pressure * f.d_pressure);
          }
      return derivatives;
    }
  } // namespace Wear
} // namespace Tribody
