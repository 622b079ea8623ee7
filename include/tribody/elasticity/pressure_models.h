// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_elasticity_pressure_models_h
#define tribody_elasticity_pressure_models_h

#include <Eigen/Core>

#include <tribody/elasticity/plane_state.h>
#include <tribody/surface/bore_surface.h>

namespace Tribody
{
  namespace Elasticity
  {
    /**
     * The compliance of a thin layer that is bonded to a rigid ground, after
     * Winkler: each place of the bore yields to its own pressure only,
     * @f[ u = \frac{p\,t}{\lambda + 2\mu}, @f]
     * in plane strain @f$p t (1+\nu)(1-2\nu)/(E(1-\nu))@f$, in plane stress
     * @f$p t (1-\nu^2)/E@f$. What it leaves out is smaller by the thickness
     * over the width of the contact, which for a bushing is no small number.
     *
     * @param bore the worn bore; the layer reaches from there to @p
     *   outer_radius [m].
     * @return as BushingElasticity::normal_compliance(), diagonal.
     */
    Eigen::MatrixXd
    winkler_compliance(const BoreSurface &bore,
                       const PlaneHooke  &law,
                       const double       outer_radius);

    /**
     * The compliance of a round hole of radius R in an infinite plate, in which
     * a pressure @f$p\cos n\theta@f$ moves the surface by
     * @f[ u = \frac{p R}{4\mu}
     *         \frac{(\kappa+1) n + (\kappa-1)}{n^2-1} \quad (n \ge 2), \qquad
     *     u = \frac{p R}{2\mu} \quad (n = 0), \qquad
     *     \kappa = \frac{\lambda + 3\mu}{\lambda + \mu}. @f]
     * With the compliance of a disc of the same material for the pin this is
     * Persson's problem. A plate without an end moves infinitely far under a
     * force; n = 1 therefore gets the leading term of a plate that is held at
     * @p held_radius, @f$ u = p R\,\kappa \ln(b/R)/(2\mu(\kappa+1)) @f$. It
     * moves the pin and nothing else.
     *
     * Nodal forces and displacements belong to the shape functions
     * @f$\varphi@f$ of the bore curve as with finite elements: the displacement
     * of the hole is projected onto them in the mean square, and forces act
     * so that their work is the same,
     * @f[ C = M^{-1} K M^{-1}, \quad M_{ij} = \int \varphi_i \varphi_j\,ds,
     *     \quad K_{ij} = \int u[\varphi_i]\,\varphi_j\,ds, @f]
     * with u[p] the displacement under p.
     *
     * @param bore the unworn bore, round.
     * @param held_radius b [m].
     */
    Eigen::MatrixXd
    infinite_plate_compliance(const BoreSurface &bore,
                              const PlaneHooke  &law,
                              const double       held_radius);
  } // namespace Elasticity
} // namespace Tribody

#endif
