// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_wear_archard_law_h
#define tribody_wear_archard_law_h

namespace Tribody
{
  namespace Wear
  {
    /**
     * Archard's law in its local form. Sliding by @f$\Delta s@f$ under the
     * contact pressure @f$p@f$ lowers the surface, along its normal, by
     * @f[ \Delta h = k\,p\,|\Delta s|, \qquad [k] = \mathrm{Pa}^{-1}. @f]
     * Integrated over the part @f$w@f$ of the surface that a nodal force
     * @f$\lambda = p\,w@f$ per axial length acts on, it removes the area
     * @f$k\,\lambda\,|\Delta s|@f$ of the cross section: this form needs no
     * division and conserves volume whatever the surface looks like.
     *
     * Pure functions; what has been worn away so far is kept in WearProfile.
     * See @cite archard1953 and eqs. (22) to (25) of @cite mukras2010. For a
     * coefficient that is not constant see WearLaw.
     */
    struct ArchardLaw
    {
      /// Wear coefficient k (volume per load and sliding distance) [Pa^-1],
      /// not negative.
      double wear_coefficient = 0.;

      /// Cross-section area removed [m^2] by a nodal force per axial length
      /// @p nodal_force [N/m], not negative.
      double
      area_increment(const double nodal_force,
                     const double sliding_distance) const
      {
        return wear_coefficient * nodal_force * sliding_distance;
      }
    };
  } // namespace Wear
} // namespace Tribody

#endif
