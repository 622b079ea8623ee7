// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_elasticity_plane_state_h
#define tribody_elasticity_plane_state_h

#include <tribody/base/choice.h>
#include <tribody/material/material.h>

namespace Tribody
{
  namespace Elasticity
  {
    /**
     * What happens along the axis of the joint: nothing moves (strain, a long
     * bushing) or nothing pushes (stress, a thin one).
     */
    enum class PlaneState
    {
      strain,
      stress
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<PlaneState>
    choice_names(const PlaneState)
    {
      return {{PlaneState::strain, "plane strain"},
              {PlaneState::stress, "plane stress"}};
    }

    /**
     * The law of Hooke in the plane,
     * @f[ \sigma = \lambda\,(\mathrm{tr}\,\varepsilon)\,I + 2\mu\,\varepsilon,
     *     \qquad \mu = \frac{E}{2(1+\nu)}, @f]
     * with @f$\lambda = E\nu/((1+\nu)(1-2\nu))@f$ in plane strain and
     * @f$\lambda = E\nu/(1-\nu^2)@f$ in plane stress.
     */
    struct PlaneHooke
    {
      /// Lame's first parameter in the plane [Pa].
      double lambda;
      /// Shear modulus [Pa].
      double mu;
      /// @f$\sigma_{zz} / (\sigma_{xx} + \sigma_{yy})@f$ [-].
      double axial_ratio;

      /// Of a @p material in the given @p state; its density does not matter.
      PlaneHooke(const Material &material, const PlaneState state)
      {
        const double E  = material.youngs_modulus;
        const double nu = material.poissons_ratio;

        mu = E / (2. * (1. + nu));
        if (state == PlaneState::strain)
          {
            lambda      = E * nu / ((1. + nu) * (1. - 2. * nu));
            axial_ratio = nu;
          }
        else
          {
            lambda      = E * nu / (1. - nu * nu);
            axial_ratio = 0.;
          }
      }
    };
  } // namespace Elasticity
} // namespace Tribody

#endif
