// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_wear_implicit_extrapolation_h
#define tribody_wear_implicit_extrapolation_h

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <optional>

namespace Tribody
{
  namespace Wear
  {
    /**
     * The equation of wear over the number of cycles N,
     * @f$ dy/dN = W(N, y) @f$, as its integrator sees it.
     */
    struct WearEquation
    {
      /**
       * Solve @f$ y = a + \gamma\,W(N, y) @f$ at N @p cycles [gamma in cycles],
       * beginning at the @p guess. Each stage of an implicit method has this
       * form, and it is the optimality condition of a convex quadratic
       * programme: there is one solution, however large gamma is.
       * @return y, or nothing if it was not found: shorter steps are tried.
       */
      std::function<
        std::optional<Eigen::VectorXd>(const double           cycles,
                                       const Eigen::VectorXd &a,
                                       const double           gamma,
                                       const Eigen::VectorXd &guess)>
        solve_stage;
      /// Functions of y of the size of one, negative at first; the first to
      /// become zero ends the integration.
      std::function<Eigen::VectorXd(const Eigen::VectorXd &y)> events;
      /// How many values events() returns.
      unsigned int n_events = 0;
    };

    /// What an integration of the wear keeps from step to step.
    struct ExtrapolationMemory
    {
      /// Length of the next step [cycles]; 0: none has been taken.
      double proposal = 0.;
      /// Slope of the line that guesses are on, one value per entry of y;
      /// empty at first.
      Eigen::VectorXd slope;
    };

    /**
     * Implicit cycle jumps: an L-stable, stiffly accurate diagonally implicit
     * Runge-Kutta method of ARKODE with its own step control integrates
     * WearEquation, which solves the stages. Their guesses are on the line
     * through what was solved last, because the state is hardly curved while
     * its rate is stiff. For the same reason the rate is never computed: that
     * of a stage follows from its solution, and the first one is given.
     *
     * An error e of y counts as @f$ \sqrt{\sum_i (w_i e_i)^2} @f$ with weights
     * that the caller chooses. For a surface the sum should be an integral over
     * it: the state of a single node has a kink where the edge of contact
     * passes, and a measure of the worst node would make the steps follow the
     * mesh.
     */
    class ImplicitExtrapolation
    {
    public:
      /// @param tolerance what the error of a step may count.
      ImplicitExtrapolation(const WearEquation &equation,
                            const double        tolerance);

      ~ImplicitExtrapolation();

      ImplicitExtrapolation(const ImplicitExtrapolation &) = delete;
      ImplicitExtrapolation &
      operator=(const ImplicitExtrapolation &) = delete;

      /**
       * Begin at @p cycles with @p y, or go on from there with an equation
       * that has changed; the length of the next step is kept. The first one
       * is as long as it takes the first rate to change y by what counts 1.
       *
       * @param rate W(y) per cycle.
       * @param weights w, one per entry of y.
       * @param max_step bound of the next step [cycles]; 0: none.
       */
      void
      start(const double           cycles,
            const Eigen::VectorXd &y,
            const Eigen::VectorXd &rate,
            const Eigen::VectorXd &weights,
            const double           max_step = 0.);

      /**
       * One step, not beyond @p end [cycles].
       * @return whether one of the events has happened; the step then ends
       *   there, to 1e-10 of the event.
       * @throws ExcRun if no step can be taken, and what the functions of the
       *   equation throw.
       */
      bool
      step(const double end);

      /// N that has been reached [cycles]; state() belongs to it.
      double
      cycles() const;

      /// y at cycles().
      const Eigen::VectorXd &
      state() const;

      /// Estimate of the error of the last step, one value per entry of y.
      Eigen::VectorXd
      local_error() const;

      /// The rate at the end of the last step as its last stage has it.
      const Eigen::VectorXd &
      end_rate() const;

      /// What start() and step() go on from, beside their arguments.
      const ExtrapolationMemory &
      lasting_memory() const;

      /// Go on as the integrator that @p lasting is from.
      /// @pre start() follows.
      void
      restore(const ExtrapolationMemory &lasting);

    private:
      struct Memory;
      std::unique_ptr<Memory> memory;
    };
  } // namespace Wear
} // namespace Tribody

#endif
