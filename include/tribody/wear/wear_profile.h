// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_wear_wear_profile_h
#define tribody_wear_wear_profile_h

#include <Eigen/Core>

#include <tribody/surface/bore_surface.h>

namespace Tribody
{
  namespace Wear
  {
    /**
     * How deep the surface of a bore or of a pin has worn: at every node the
     * distance h >= 0 by which it has moved along the as-manufactured normal
     * into the material, which for a round surface is the radius through it.
     * The whole memory of the wear process: worn geometry, clearance and volume
     * follow from it.
     */
    struct WearProfile
    {
      /// As-manufactured node positions [m], one column per node.
      Eigen::Matrix2Xd positions;
      /// Unit as-manufactured normals, into the material.
      Eigen::Matrix2Xd normals;
      /// Wear depth h [m].
      Eigen::VectorXd depth;
      /// Degree of the curve through the nodes.
      unsigned int degree = 1;

      /// Which side of the curve the material is on: 1 outside (a bore), -1
      /// inside (a pin).
      double side = 1.;

      /// The worn surface.
      BoreSurface
      surface() const;

      /// Derivative of the area that is lost with respect to the depth at
      /// each node, @f$ \pm \mathbf n_i \cdot \mathbf w_i @f$ [m], positive.
      Eigen::VectorXd
      area_derivative(const BoreSurface &surface) const;

      /**
       * What the depth grows by when node i loses the cross-section area
       * @p removed_area [m^2]: @f$ \Delta h_i = A_i / (\mathbf n_i \cdot
       * \mathbf w_i) @f$, because that product is the derivative of the lost
       * area with respect to @f$h_i@f$. So what the law removes and what the
       * geometry loses agree to first order in the step.
       *
       * @param surface the worn surface().
       */
      Eigen::VectorXd
      depth_for_removed_area(const BoreSurface     &surface,
                             const Eigen::VectorXd &removed_area) const;

      /**
       * The depth after node i has lost the cross-section area @p removed_area
       * [m^2], exactly: the area inside the curve is quadratic in the depth, so
       * that its change is @f$ \sum_i D_i(\bar h) \Delta h_i @f$ with the
       * derivative D at the mean @f$ \bar h @f$ of both depths. With
       * @f$ D_i(\bar h) \Delta h_i = A_i @f$ the geometry loses the sum of
       * what its nodes lose, whatever the step.
       */
      Eigen::VectorXd
      depth_after_removing(const Eigen::VectorXd &removed_area) const;

      /// Cross-section area that the curve with this depth has lost [m^2].
      double
      lost_area() const;

      /// Largest depth of all nodes [m].
      double
      max_depth() const;

      /// Node where the wear is deepest.
      Eigen::Index
      deepest_node() const;
    };

    /// An unworn bore.
    WearProfile
    make_wear_profile(const Eigen::Matrix2Xd &positions,
                      const Eigen::Matrix2Xd &normals,
                      const unsigned int      degree);

    /// An unworn round pin of the given @p radius [m] with nodes at the
    /// @p angles [rad], as make_bore_surface() wants them.
    WearProfile
    make_pin_profile(const double           radius,
                     const Eigen::VectorXd &angles,
                     const unsigned int     degree);

    /**
     * Amplitude of the mesh-size oscillation in a field on the bore, relative
     * to the field's largest value: of the fourth difference
     * @f$ |v_{i-2} - 4 v_{i-1} + 6 v_i - 4 v_{i+1} + v_{i+2}| / 16 @f$ (a
     * sawtooth of amplitude a gives a, a smooth field the fourth power of the
     * node distance) the largest median over eleven nodes, as far as all five
     * values are positive. So the edge of contact does not count, nor those of
     * the contacts at single instants, which a rigid bore has inside the worn
     * arc. Zero for a field that vanishes.
     */
    double
    mesh_oscillation(const Eigen::VectorXd &values);
  } // namespace Wear
} // namespace Tribody

#endif
