// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_sundials_ida_integrator_h
#define tribody_sundials_ida_integrator_h

#include <Eigen/Core>

#include <tribody/algebra/matrix_entries.h>

#include <exception>
#include <functional>
#include <memory>
#include <vector>

namespace Tribody
{
  namespace Sundials
  {
    /// A system F(t, y, y') = 0 with functions whose zeros matter.
    struct ImplicitSystem
    {
      /// A view of entries that SUNDIALS owns, to be written.
      using Vector = Eigen::Map<Eigen::VectorXd>;
      /// The same, to be read.
      using ConstVector = Eigen::Map<const Eigen::VectorXd>;

      /// F(t, y, y').
      std::function<
        void(const double, const ConstVector &, const ConstVector &, Vector &)>
        residual;
      /// Adds dF/dy + c dF/dy' at (t, c, y, y') to a matrix that is zero.
      std::function<void(const double,
                         const double,
                         const ConstVector &,
                         const ConstVector &,
                         MatrixEntries &)>
        jacobian;
      /// Functions of (t, y) at whose zeros step() stops.
      std::function<void(const double, const ConstVector &, double *)> roots;
      /// How many values roots() writes.
      unsigned int n_roots = 0;
    };

    /// How ImplicitSystem is to be integrated.
    struct IdaSettings
    {
      /// Error allowed in a step, relative to each unknown [-].
      double relative_tolerance = 0.;
      /// Error allowed in a step besides, one value per unknown and in its
      /// unit.
      Eigen::VectorXd absolute_tolerances;
      /// 1 for differential components, 0 for algebraic ones, which are left
      /// out of the error test.
      Eigen::VectorXd is_differential;
      /// Highest order of the BDF method, 1 to 5.
      unsigned int maximum_order = 5;
      /// Longest step; 0: no limit.
      double maximum_step = 0.;
      /// First step; 0: IDA estimates it.
      double initial_step = 0.;
    };

    /// What the integration has cost, summed over restarts.
    struct IntegratorStatistics
    {
      /// Internal steps that were accepted.
      unsigned long n_steps = 0;
      /// Evaluations of the residual.
      unsigned long n_residuals = 0;
      /// Jacobians that were assembled and factorised.
      unsigned long n_jacobians = 0;
      /// Steps that were taken again because their error was too large.
      unsigned long n_error_test_failures = 0;
      /// Newton iterations that did not converge.
      unsigned long n_nonlinear_failures = 0;
      /// Calls of start(); each begins with order 1.
      unsigned long n_starts = 0;

      /// Add what another integration has cost.
      IntegratorStatistics &
      operator+=(const IntegratorStatistics &other);

      /// Starts after the first.
      unsigned long
      n_restarts() const
      {
        return n_starts > 0 ? n_starts - 1 : 0;
      }
    };

    /**
     * IDA of SUNDIALS (BDF of variable order and step) with a direct solver
     * (IdaLinearSolver), step by step. Owns everything it allocates in C. An
     * exception thrown by a function of the system is kept while IDA returns,
     * and thrown again from step().
     */
    class IdaIntegrator
    {
    public:
      /// @throws ExcRun if SUNDIALS refuses.
      IdaIntegrator(const ImplicitSystem &system, const IdaSettings &settings);

      ~IdaIntegrator();

      IdaIntegrator(const IdaIntegrator &) = delete;
      IdaIntegrator &
      operator=(const IdaIntegrator &) = delete;

      /// (Re)start from consistent values at time @p t. A positive
      /// @p initial_step takes the place of that of the settings.
      void
      start(const double           t,
            const Eigen::VectorXd &y,
            const Eigen::VectorXd &y_t,
            const double           initial_step = 0.);

      /**
       * One internal step, or up to the next zero of a root function.
       * @param direction any later time.
       * @return for each root function 1 or -1 if it rose or fell through
       *   zero at time(), 0 otherwise.
       * @throws ExcRun naming the time if IDA fails.
       */
      const std::vector<int> &
      step(const double direction);

      /// Time reached [s]; solution() belongs to it.
      double
      time() const;

      /// y at time().
      const Eigen::VectorXd &
      solution() const;

      /// The solution at @p t, which lies within the last step.
      void
      interpolate(const double t, Eigen::VectorXd &y) const;

      /// Of all starts together.
      IntegratorStatistics
      statistics() const;

    private:
      // What belongs to SUNDIALS, so that this header does not need theirs.
      struct Memory;
      std::unique_ptr<Memory> memory;
    };
  } // namespace Sundials
} // namespace Tribody

#endif
