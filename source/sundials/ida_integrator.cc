// SPDX-License-Identifier: LGPL-2.1-or-later

#include <idas/idas.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_newton.h>

#include <tribody/base/exceptions.h>
#include <tribody/sundials/callbacks.h>
#include <tribody/sundials/ida_integrator.h>
#include <tribody/sundials/ida_linear_solver.h>
#include <tribody/sundials/ida_vector.h>
#include <tribody/sundials/vector_view.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <utility>

namespace Tribody
{
  namespace Sundials
  {
    struct IdaIntegrator::Memory
    {
      Memory(const ImplicitSystem &system, const IdaSettings &settings);
      ~Memory();

      // Throw what a callback threw, or translate IDA's return code.
      void
      check(const int flag, const std::string &what);

      IntegratorStatistics
      statistics_of_this_run() const;

      void
      make_linear_solver();

      ImplicitSystem       system;
      IdaSettings          settings;
      std::exception_ptr   exception;
      double               time       = 0.;
      bool                 is_started = false;
      IntegratorStatistics previous_runs;
      std::vector<int>     roots_found;

      // The N_Vectors below are views of these.
      Eigen::VectorXd y;
      Eigen::VectorXd y_t;

      SUNContext         context = nullptr;
      void              *ida     = nullptr;
      N_Vector           nv_y    = nullptr;
      N_Vector           nv_y_t  = nullptr;
      SUNNonlinearSolver newton  = nullptr;
      // Made at the first start: its pattern is that of a real state.
      std::unique_ptr<IdaLinearSolver> linear_solver;
      // Norm of Newton's first correction in the current step.
      double first_correction = 0.;
    };



    namespace
    {
      // Newton's method has converged when what is left, estimated from the
      // rate seen in this step, is small. IDA's own test uses the rate of an
      // earlier step for the first iteration: with a Jacobian that has grown
      // old since, one iteration then passes that leaves the constraints open
      // by 1e-7 m.
      template <typename Memory>
      int
      convergence_test(SUNNonlinearSolver newton,
                       N_Vector,
                       N_Vector       correction,
                       const realtype tolerance,
                       N_Vector       weights,
                       void          *data)
      {
        // As IDA's: faster than this is convergence, slower calls for a new
        // Jacobian.
        constexpr double slowest_rate = 0.9;

        Memory      &memory    = *static_cast<Memory *>(data);
        const double norm      = N_VWrmsNorm(correction, weights);
        int          iteration = 0;
        SUNNonlinSolGetCurIter(newton, &iteration);
        if (iteration == 0)
          {
            // Nothing is known of the rate yet.
            memory.first_correction = norm;
            return norm <= tolerance ? SUN_NLS_SUCCESS : SUN_NLS_CONTINUE;
          }
        const double rate =
          std::pow(norm / memory.first_correction, 1. / iteration);
        if (rate > slowest_rate)
          return SUN_NLS_CONV_RECVR;
        return rate / (1. - rate) * norm <= tolerance ? SUN_NLS_SUCCESS
                                                      : SUN_NLS_CONTINUE;
      }



      template <typename Memory>
      int
      residual_callback(realtype t,
                        N_Vector y,
                        N_Vector y_t,
                        N_Vector r,
                        void    *data)
      {
        Memory &memory = *static_cast<Memory *>(data);
        return guarded(memory.exception, [&]() {
          Eigen::Map<Eigen::VectorXd> result = view(r);
          memory.system.residual(t, const_view(y), const_view(y_t), result);
          // A step that leads to overflow is repeated with half its length.
          return result.allFinite() ? 0 : 1;
        });
      }



      template <typename Memory>
      int
      jacobian_callback(realtype t,
                        realtype c,
                        N_Vector y,
                        N_Vector y_t,
                        N_Vector /*r*/,
                        SUNMatrix /*matrix*/,
                        void *data,
                        N_Vector,
                        N_Vector,
                        N_Vector)
      {
        Memory &memory = *static_cast<Memory *>(data);
        return guarded(memory.exception, [&]() {
          const bool is_finite =
            memory.linear_solver->assemble([&](MatrixEntries &entries) {
              memory.system.jacobian(
                t, c, const_view(y), const_view(y_t), entries);
            });
          return is_finite ? 0 : 1;
        });
      }



      template <typename Memory>
      int
      root_callback(realtype t,
                    N_Vector y,
                    N_Vector /*y_t*/,
                    realtype *values,
                    void     *data)
      {
        Memory &memory = *static_cast<Memory *>(data);
        return guarded(memory.exception, [&]() {
          memory.system.roots(t, const_view(y), values);
          return 0;
        });
      }
    } // namespace



    IntegratorStatistics &
    IntegratorStatistics::operator+=(const IntegratorStatistics &other)
    {
      n_steps += other.n_steps;
      n_residuals += other.n_residuals;
      n_jacobians += other.n_jacobians;
      n_error_test_failures += other.n_error_test_failures;
      n_nonlinear_failures += other.n_nonlinear_failures;
      n_starts += other.n_starts;
      return *this;
    }



    IdaIntegrator::Memory::Memory(const ImplicitSystem &system,
                                  const IdaSettings    &settings)
      : system(system)
      , settings(settings)
      , roots_found(system.n_roots, 0)
      , y(Eigen::VectorXd::Zero(settings.absolute_tolerances.size()))
      , y_t(y)
    {
      check(SUNContext_Create(nullptr, &context), "SUNContext_Create");
      nv_y   = make_ida_vector(y, context);
      nv_y_t = make_ida_vector(y_t, context);
      newton = SUNNonlinSol_Newton(nv_y, context);
      ida    = IDACreate(context);
      AssertThrow(ida != nullptr && newton != nullptr,
                  ExcRun("SUNDIALS could not allocate its memory."));
    }



    IdaIntegrator::Memory::~Memory()
    {
      IDAFree(&ida);
      SUNNonlinSolFree(newton);
      linear_solver.reset();
      N_VDestroy(nv_y);
      N_VDestroy(nv_y_t);
      SUNContext_Free(&context);
    }



    void
    IdaIntegrator::Memory::check(const int flag, const std::string &what)
    {
      if (exception)
        std::rethrow_exception(std::exchange(exception, nullptr));
      if (flag >= 0)
        return;
      char             *name = IDAGetReturnFlagName(flag);
      std::string const code = name;
      free(name);
      std::ostringstream message;
      message << "The integration of the motion failed at time " << time
              << " s (" << what << " of SUNDIALS returned " << code
              << "). Try a larger value of 'Dynamics/Accuracy' or another "
                 "'Dynamics/Maximum order', and check that masses, "
                 "stiffnesses and initial positions are as intended.";
      AssertThrow(false, ExcRun(message.str()));
    }



    IntegratorStatistics
    IdaIntegrator::Memory::statistics_of_this_run() const
    {
      if (!is_started)
        return {};
      long steps = 0, residuals = 0, jacobians = 0, errors = 0, nonlinear = 0;
      IDAGetNumSteps(ida, &steps);
      IDAGetNumResEvals(ida, &residuals);
      IDAGetNumJacEvals(ida, &jacobians);
      IDAGetNumErrTestFails(ida, &errors);
      IDAGetNumNonlinSolvConvFails(ida, &nonlinear);
      IntegratorStatistics run;
      run.n_steps               = steps;
      run.n_residuals           = residuals;
      run.n_jacobians           = jacobians;
      run.n_error_test_failures = errors;
      run.n_nonlinear_failures  = nonlinear;
      run.n_starts              = 1;
      return run;
    }



    void
    IdaIntegrator::Memory::make_linear_solver()
    {
      constexpr double some_c = 1.;
      linear_solver           = IdaLinearSolver::create(
        y.size(),
        [&](MatrixEntries &entries) {
          system.jacobian(
            time, some_c, const_view(nv_y), const_view(nv_y_t), entries);
        },
        context);
      check(IDASetLinearSolver(ida,
                               linear_solver->solver,
                               linear_solver->matrix),
            "IDASetLinearSolver");
      check(IDASetJacFn(ida, jacobian_callback<Memory>), "IDASetJacFn");
    }



    IdaIntegrator::IdaIntegrator(const ImplicitSystem &system,
                                 const IdaSettings    &settings)
      : memory(std::make_unique<Memory>(system, settings))
    {
      Memory    &m   = *memory;
      void      *ida = m.ida;
      const auto run = [&](const int flag, const char *what) {
        m.check(flag, what);
      };
      // Views of vectors that live until this function returns; IDA copies.
      const auto with_view = [&](const Eigen::VectorXd &x,
                                 const auto            &function) {
        N_Vector nv =
          N_VMake_Serial(x.size(), const_cast<double *>(x.data()), m.context);
        const int flag = function(nv);
        N_VDestroy(nv);
        return flag;
      };
      run(IDAInit(ida, residual_callback<Memory>, 0., m.nv_y, m.nv_y_t),
          "IDAInit");
      run(IDASetErrHandlerFn(ida, silent_error_handler, nullptr),
          "IDASetErrHandlerFn");
      run(IDASetUserData(ida, &m), "IDASetUserData");
      run(with_view(settings.absolute_tolerances,
                    [&](N_Vector x) {
                      return IDASVtolerances(ida,
                                             settings.relative_tolerance,
                                             x);
                    }),
          "IDASVtolerances");
      run(with_view(settings.is_differential,
                    [&](N_Vector x) { return IDASetId(ida, x); }),
          "IDASetId");
      run(IDASetSuppressAlg(ida, SUNTRUE), "IDASetSuppressAlg");
      run(IDASetMaxOrd(ida, settings.maximum_order), "IDASetMaxOrd");
      // Newton's method stops at this part of the error allowed in a step. What
      // it leaves behind (0.33 by default) shakes the lightly damped vibrations
      // of a joint: the 0.5 um joint then took four cycles to settle.
      run(IDASetNonlinConvCoef(ida, 0.03), "IDASetNonlinConvCoef");
      run(IDASetMaxStep(ida, settings.maximum_step), "IDASetMaxStep");
      run(IDASetNonlinearSolver(ida, m.newton), "IDASetNonlinearSolver");
      // After IDA, which sets its own.
      run(SUNNonlinSolSetConvTestFn(m.newton, convergence_test<Memory>, &m),
          "SUNNonlinSolSetConvTestFn");
      if (system.n_roots > 0)
        {
          run(IDARootInit(ida, system.n_roots, root_callback<Memory>),
              "IDARootInit");
          run(IDASetNoInactiveRootWarn(ida), "IDASetNoInactiveRootWarn");
        }
    }



    IdaIntegrator::~IdaIntegrator() = default;



    void
    IdaIntegrator::start(const double           t,
                         const Eigen::VectorXd &y,
                         const Eigen::VectorXd &y_t,
                         const double           initial_step)
    {
      memory->previous_runs += memory->statistics_of_this_run();
      memory->roots_found.assign(memory->system.n_roots, 0);
      memory->time = t;
      memory->y    = y;
      memory->y_t  = y_t;
      memory->check(IDAReInit(memory->ida, t, memory->nv_y, memory->nv_y_t),
                    "IDAReInit");
      memory->check(IDASetInitStep(memory->ida,
                                   initial_step > 0
                                     ? initial_step
                                     : memory->settings.initial_step),
                    "IDASetInitStep");
      if (!memory->is_started)
        memory->make_linear_solver();
      memory->is_started = true;
    }



    const std::vector<int> &
    IdaIntegrator::step(const double direction)
    {
      const auto solve = [&]() {
        return IDASolve(memory->ida,
                        direction,
                        &memory->time,
                        memory->nv_y,
                        memory->nv_y_t,
                        IDA_ONE_STEP);
      };
      int        flag = solve();
      const bool is_at_root =
        std::any_of(memory->roots_found.begin(),
                    memory->roots_found.end(),
                    [](const int found) { return found != 0; });
      if (flag == IDA_ILL_INPUT && is_at_root)
        {
          // IDA refuses to leave a root where the function stays zero (to
          // rounding): a start there ignores it until it no longer is.
          start(memory->time,
                Eigen::VectorXd(memory->y),
                Eigen::VectorXd(memory->y_t));
          flag = solve();
        }
      memory->check(flag, "IDASolve");
      if (flag == IDA_ROOT_RETURN)
        memory->check(IDAGetRootInfo(memory->ida, memory->roots_found.data()),
                      "IDAGetRootInfo");
      else
        memory->roots_found.assign(memory->system.n_roots, 0);
      return memory->roots_found;
    }



    double
    IdaIntegrator::time() const
    {
      return memory->time;
    }



    const Eigen::VectorXd &
    IdaIntegrator::solution() const
    {
      return memory->y;
    }



    void
    IdaIntegrator::interpolate(const double t, Eigen::VectorXd &y) const
    {
      y.resize(memory->y.size());
      N_Vector  nv   = N_VMake_Serial(y.size(), y.data(), memory->context);
      const int flag = IDAGetDky(memory->ida, t, 0, nv);
      N_VDestroy(nv);
      memory->check(flag, "IDAGetDky");
    }



    IntegratorStatistics
    IdaIntegrator::statistics() const
    {
      IntegratorStatistics total = memory->previous_runs;
      total += memory->statistics_of_this_run();
      return total;
    }
  } // namespace Sundials
} // namespace Tribody
