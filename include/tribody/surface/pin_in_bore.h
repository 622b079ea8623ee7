// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_surface_pin_in_bore_h
#define tribody_surface_pin_in_bore_h

#include <Eigen/Core>

#include <tribody/base/choice.h>
#include <tribody/surface/joint_clearance.h>

namespace Tribody
{
  /**
   * How deep a pin is in its bore and where they touch, with derivatives by w =
   * (e_x, e_y, alpha): the pin's centre and the angle from the bushing's frame
   * to the pin's. All vectors are in the bushing's frame.
   */
  struct SurfaceContact
  {
    /// A gradient by w.
    using RowVector3 = Eigen::RowVector3d;
    /// Derivatives of a vector by w, one column each.
    using Matrix23 = Eigen::Matrix<double, 2, 3>;

    /// delta [m], positive where pin and bore overlap.
    double penetration = 0.;
    /// Its gradient [-, -, m].
    RowVector3 d_penetration = RowVector3::Zero();
    /// Its second derivatives.
    Eigen::Matrix3d d2_penetration = Eigen::Matrix3d::Zero();
    /// n, the unit normal of the contact, into the bushing.
    Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
    /// Derivatives of n.
    Matrix23 d_direction = Matrix23::Zero();
    /// Normal force per derivative of the stored energy by delta [-]; one for a
    /// round pin.
    double force_ratio = 1.;
    /// Its gradient.
    RowVector3 d_force_ratio = RowVector3::Zero();
    /// From the pin's centre to the pin's surface at the contact [m].
    Eigen::Vector2d pin_point = Eigen::Vector2d::Zero();
    /// Derivatives of pin_point.
    Matrix23 d_pin_point = Matrix23::Zero();
    /// From the bushing's centre to the bore at the contact [m].
    Eigen::Vector2d bushing_point = Eigen::Vector2d::Zero();
    /// Derivatives of bushing_point.
    Matrix23 d_bushing_point = Matrix23::Zero();
  };

  /// What to take for penetration and direction of contact in a worn joint.
  enum class PenetrationMeasure
  {
    /// The deepest penetration of the pin into the bore, and the normal there.
    deepest,
    /// @f$ |e| - c(\theta) @f$ in the direction of e (eq. 28 of
    /// @cite mukras2010).
    scalar
  };

  /// Their words, see ChoiceNames.
  inline ChoiceNames<PenetrationMeasure>
  choice_names(const PenetrationMeasure)
  {
    return {{PenetrationMeasure::deepest, "deepest penetration"},
            {PenetrationMeasure::scalar, "scalar clearance"}};
  }

  /**
   * A pin off the centre of its bore. The bore is the curve @f$ x(\theta) =
   * (R_i + c(\theta))\,u(\theta) @f$, u the unit vector at the angle
   * @f$\theta@f$; the pin's radius in the direction @f$\psi@f$ of x - e is
   * @f$ R_i - h_p(\psi - \alpha) @f$. Measured along that direction, the pin
   * overlaps the bore by
   * @f[ \delta(\theta; e, \alpha) = R_i - h_p(\psi - \alpha) - |x(\theta) - e|
   *   @f]
   * and the deepest penetration is the largest of these. There
   * @f$ \partial\delta/\partial\theta = 0 @f$, so that its derivatives by e and
   * alpha are those at fixed theta; in the second ones the deepest point moves.
   * A force f(delta) along the gradient by e has a potential.
   *
   * The deepest penetration is continuous and is differentiable as long as
   * there is one deepest point; where there are two, the direction jumps from
   * one to the other.
   *
   * Beyond the bore, where the distance of the pin's centre from it would make
   * the overlap small again, the scalar measure goes on: both are R_i at the
   * bore itself.
   *
   * In a round bore with a round pin both measures are
   * @f$ |e| - c @f$ with @f$ n = e/|e| @f$.
   */
  class PinInBore
  {
  public:
    /// @param pin_radius R_i as manufactured [m].
    PinInBore(const JointClearance    &clearance,
              const double             pin_radius,
              const PenetrationMeasure measure = PenetrationMeasure::deepest);

    /// With the pin's centre at @p e [m] and turned by @p alpha [rad]. At the
    /// very centre of a round bore the direction has no meaning.
    SurfaceContact
    find_contact(const Eigen::Vector2d &e, const double alpha) const;

    /// delta [m] alone.
    double
    compute_penetration(const Eigen::Vector2d &e, const double alpha) const;

    /**
     * Where the centre of the pin, turned by @p alpha, has to be [m] to
     * penetrate the bore by @p penetration [m] with the contact normal
     * @p direction: where a force in that direction presses it to. Of all
     * places where it penetrates the bore by no more, this is the farthest in
     * the direction; where the pin rests on two points at once, a force between
     * their normals holds it there.
     */
    Eigen::Vector2d
    find_position(const Eigen::Vector2d &direction,
                  const double           penetration,
                  const double           alpha) const;

    /// The surfaces it was made for.
    const JointClearance &
    clearance() const
    {
      return surfaces;
    }

    /// R_i as manufactured [m].
    double
    pin_radius() const
    {
      return radius;
    }

  private:
    struct Overlap;

    bool
    is_along_eccentricity() const;

    // Whether the pin's centre is outside the bore.
    bool
    is_beyond_bore(const Eigen::Vector2d &e) const;

    SurfaceContact
    find_along_eccentricity(const Eigen::Vector2d &e, const double alpha) const;

    Overlap
    find_deepest(const Eigen::Vector2d &e, const double alpha) const;

    Overlap
    evaluate_overlap(const double           theta,
                     const Eigen::Vector2d &e,
                     const double           alpha) const;

    Eigen::Vector2d
    find_farthest_step(const Eigen::Vector2d &e,
                       const double           alpha,
                       const Eigen::Vector2d &direction,
                       const double           penetration) const;

    Eigen::Index
    deepest_table_entry(const Eigen::Vector2d &e, const double alpha) const;

    JointClearance     surfaces;
    double             radius;
    PenetrationMeasure measure;

    /// Points of the bore [m] at equidistant angles from zero on; empty if
    /// both surfaces are round.
    Eigen::ArrayXd table_x;
    Eigen::ArrayXd table_y;
    /// Least wear of the pin [m], a bound that saves most of a search.
    double least_pin_wear = 0.;
  };
} // namespace Tribody

#endif
