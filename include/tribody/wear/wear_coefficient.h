// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_wear_wear_coefficient_h
#define tribody_wear_wear_coefficient_h

#include <tribody/base/choice.h>

#include <string>

namespace Tribody
{
  namespace Wear
  {
    /**
     * The wear coefficient [Pa^-1] that @p text prints, in the spellings of
     * data sheets. What Units::from_string() understands has its meaning;
     * otherwise
     * - all behind a single slash divides, "mm3/N m", "in3-min/ft-lb-hr",
     *   hyphens and dots between units multiply, and "Nm" is "N m";
     * - "lb" is a force, since k with a mass has no meaning;
     * - a power of ten may stand between number and unit, "26 1e-8 mm3/Nm",
     *   "26 x 10^-8 mm3/Nm";
     * - "2 um/km at 1 MPa" is a depth per sliding distance at a pressure;
     * - superscripts, multiplication signs and the like are those of UTF-8.
     * @throws ExcInput for what is not understood; lists spellings that are.
     */
    double
    coefficient_from_string(const std::string &text);

    /// A data sheet's spelling of a quantity as Units::from_string() reads it;
    /// what needs no change is returned as it is.
    std::string
    plain_spelling(const std::string &text);

    /// What a wear coefficient was taken to be when it was measured.
    enum class CoefficientBasis
    {
      /// Depth per local contact pressure and sliding distance, Archard's k.
      local,
      /// Depth of a worn-in bushing per projected pressure F/(2 R L).
      projected_pressure,
      /// Volume of a worn-in bushing per force.
      bushing_volume
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<CoefficientBasis>
    choice_names(const CoefficientBasis)
    {
      return {{CoefficientBasis::local, "local"},
              {CoefficientBasis::projected_pressure, "projected pressure"},
              {CoefficientBasis::bushing_volume, "bushing volume"}};
    }

    /**
     * Archard's k [Pa^-1] from the @p coefficient of a worn-in bushing, which
     * is 4/pi times as large. In a bore that is worn in over its half the rigid
     * pin sinks by h, each place by @f$h\cos\theta@f$, so that the pressure is
     * @f$p_0\cos\theta@f$ and carries
     * @f[ F = R L \int_{-\pi/2}^{\pi/2} p_0 \cos^2\theta\,d\theta
     *       = \frac{\pi}{2}\,p_0 R L, \qquad
     *   \frac{dh}{ds} = k\,p_0 = \frac{4}{\pi}\,k\,\frac{F}{2 R L}, \qquad
     *   \frac{dV}{ds} = k R L \int_{-\pi/2}^{\pi/2} p_0 \cos\theta\,d\theta
     *                 = 2\,k\,p_0 R L = \frac{4}{\pi}\,k F. @f]
     */
    double
    local_coefficient(const double coefficient, const CoefficientBasis basis);
  } // namespace Wear
} // namespace Tribody

#endif
