#ifndef tribody_wear_implicit_extrapolation_h
#define tribody_wear_implicit_extrapolation_h

#include <Eigen/Core>

#include <functional>
#include <memory>

namespace Tribody
{
  namespace Wear
  {
    /**
     * The equation of wear over the number of cycles N,
     * @f$ dy/dN = W(y) @f$, as its integrator sees it. The state y holds wear
     * depths; what else a caller wants integrated along may follow them.
     */
    struct WearEquation
    {
      /// W(y).
      std::function<Eigen::VectorXd(const Eigen::VectorXd &y)> rate;
      /// dW/dy at the state of the last call of rate.
      std::function<Eigen::MatrixXd()> jacobian;
      /// Functions of y whose change of sign ends the integration, and their
      /// number.
      std::function<Eigen::VectorXd(const Eigen::VectorXd &y)> events;
      unsigned int                                             n_events = 0;
    };

    /// How accurate an ImplicitExtrapolation is.
    struct ImplicitSettings
    {
      /// Error of the depth that a step may make, relative to the largest
      /// depth reached [-].
      double tolerance = 5e-3;
      /// Depths below this do not make the tolerance tighter [m].
      double depth_floor = 1e-6;
      /// Entries of y that are depths; the others are left out of the error
      /// test.
      Eigen::Index n_depths = 0;
    };

    /**
     * Implicit cycle jumps: an L-stable, stiffly accurate diagonally implicit
     * Runge-Kutta method of ARKODE with its own step control integrates
     * WearEquation. Each stage solves @f$ y = a + \gamma\,\Delta N\,W(y) @f$,
     * the optimality condition of a convex quadratic programme, by Newton's
     * method with a new Jacobian in every iteration: one that lags behind
     * belongs to other active sets and does not converge while the contact
     * grows.
     */
    class ImplicitExtrapolation
    {
    public:
      ImplicitExtrapolation(const WearEquation     &equation,
                            const ImplicitSettings &settings);

      ~ImplicitExtrapolation();

      ImplicitExtrapolation(const ImplicitExtrapolation &) = delete;
      ImplicitExtrapolation &
      operator=(const ImplicitExtrapolation &) = delete;

      /**
       * Begin at @p cycles with @p y, or go on from there with an equation
       * that has changed; the length of the next step is kept.
       */
      void
      start(const double cycles, const Eigen::VectorXd &y);

      /**
       * One step, not beyond @p end [cycles].
       * @return whether one of the events has happened; the step then ends
       *   there.
       * @throws ExcRun if no step can be taken, and what the functions of the
       *   equation throw.
       */
      bool
      step(const double end);

      double
      cycles() const;

      const Eigen::VectorXd &
      state() const;

      /// Estimate of the error of the last step, one value per entry of y.
      Eigen::VectorXd
      local_error() const;

    private:
      struct Memory;
      std::unique_ptr<Memory> memory;
    };
  } // namespace Wear
} // namespace Tribody

#endif
