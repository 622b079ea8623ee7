// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_wear_crescent_h
#define tribody_wear_crescent_h

namespace Tribody
{
  namespace Wear
  {
    /**
     * Wear of a stiff bushing by a stiff pin under a force of constant size
     * and direction, in closed form. The pin, of the radius of the bore but
     * for the clearance c, sinks into the bushing along the force; the worn
     * region is a crescent of half-angle t with cos t = c/(h + c), the pressure
     * goes with the cosine of the angle from the force, and
     * @f[ \frac{dh}{ds} = \frac{k F}{R L (t + \tfrac12 \sin 2t)}, \qquad
     *     V = L R \left[2 (h + c) \sin t - 2 c\, t\right]. @f]
     * The comparison that an engineer makes by hand: elasticity of the bushing
     * and changes of the force are left out.
     */
    struct Crescent
    {
      /// Radius R of the bore [m].
      double radius;
      /// Radial clearance c of the unworn joint [m], positive.
      double clearance;
      /// Axial length L [m].
      double axial_length;
      /// Wear coefficient k [Pa^-1].
      double wear_coefficient;
      /// Normal force F [N].
      double normal_force;

      /// Sliding distance [m] after which the bushing is @p depth [m] deep.
      double
      sliding_distance(const double depth) const;

      /// Maximum depth [m] after @p sliding_distance [m].
      double
      depth(const double sliding_distance) const;

      /// Worn volume [m^3] at the maximum depth @p depth [m].
      double
      volume(const double depth) const;
    };
  } // namespace Wear
} // namespace Tribody

#endif
