// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_surface_clearance_profile_h
#define tribody_surface_clearance_profile_h

#include <Eigen/Core>

#include <memory>

namespace Tribody
{
  /**
   * The clearance @f$c(\theta)@f$ of a revolute joint as a periodic function of
   * the angle in the bushing's frame: bore radius minus pin radius, plus what
   * has been worn away. Twice continuously differentiable (a cubic spline
   * through equidistant values), as the equations of motion need it.
   *
   * A plain value; copies share the spline, which never changes.
   */
  class ClearanceProfile
  {
  public:
    /// Clearance with its derivatives with respect to the angle.
    struct Values
    {
      /// c [m].
      double clearance;
      /// dc/d(angle) [m/rad].
      double first_derivative;
      /// Its second derivative [m/rad^2].
      double second_derivative;
    };

    /// The same clearance [m] everywhere.
    explicit ClearanceProfile(const double clearance = 0.);

    /**
     * Through the values @p clearances [m] at the @p angles [rad], ascending
     * within less than one turn, at least four. Angles that are not equidistant
     * are first brought to a fine equidistant grid by modified Akima
     * interpolation, which does not overshoot where a worn arc begins.
     */
    ClearanceProfile(const Eigen::VectorXd &angles,
                     const Eigen::VectorXd &clearances);

    /// Clearance [m] at the @p angle [rad], any real number.
    double
    clearance(const double angle) const;

    /// Clearance and derivatives at the @p angle [rad], any real number.
    Values
    evaluate(const double angle) const;

    /// Mean over the angle [m].
    double
    mean() const
    {
      return mean_clearance;
    }

    /// Whether it is the same everywhere, by construction.
    bool
    is_constant() const
    {
      return spline == nullptr;
    }

    /// Equidistant values that the spline goes through; 0 without a spline.
    unsigned int
    n_nodes() const;

  private:
    struct Spline;

    double                        mean_clearance;
    std::shared_ptr<const Spline> spline;
  };
} // namespace Tribody

#endif
