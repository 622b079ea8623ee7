// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_surface_periodic_profile_h
#define tribody_surface_periodic_profile_h

#include <Eigen/Core>

#include <memory>

namespace Tribody
{
  /**
   * A length along the surface of a bore or of a pin, as a periodic function
   * @f$f(\theta)@f$ of the angle in the frame of that surface: the clearance of
   * a bushing, which is bore radius minus pin radius plus what has been worn
   * away, or the depth that a pin has lost. Twice continuously differentiable
   * (a cubic spline through equidistant values), as the equations of motion
   * need it.
   *
   * A plain value; copies share the spline, which never changes.
   */
  class PeriodicProfile
  {
  public:
    /// f [m] with its derivatives with respect to the angle.
    struct Values
    {
      /// f [m].
      double value;
      /// f' [m/rad].
      double first_derivative;
      /// f'' [m/rad^2].
      double second_derivative;
    };

    /// The same @p value [m] everywhere.
    explicit PeriodicProfile(const double value = 0.);

    /**
     * Through the @p values [m] at the @p angles [rad], ascending within less
     * than one turn, at least four. Angles that are not equidistant are first
     * brought to a fine equidistant grid by modified Akima interpolation, which
     * does not overshoot where a worn arc begins.
     */
    PeriodicProfile(const Eigen::VectorXd &angles,
                    const Eigen::VectorXd &values);

    /// f [m] at the @p angle [rad], any real number.
    double
    value(const double angle) const;

    /// f, f' and f'' at the @p angle [rad], any real number.
    Values
    evaluate(const double angle) const;

    /// Mean over the angle [m].
    double
    mean() const
    {
      return the_mean;
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

    double                        the_mean;
    std::shared_ptr<const Spline> spline;
  };
} // namespace Tribody

#endif
