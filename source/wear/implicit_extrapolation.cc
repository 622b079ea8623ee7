#include <Eigen/LU>
#include <arkode/arkode_arkstep.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>

#include <tribody/base/exceptions.h>
#include <tribody/wear/implicit_extrapolation.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <string>
#include <utility>

namespace Tribody
{
  namespace Wear
  {
    struct ImplicitExtrapolation::Memory
    {
      Memory(const WearEquation &equation, const double tolerance)
        : equation(equation)
        , tolerance(tolerance)
      {}

      ~Memory()
      {
        ARKStepFree(&arkode);
        SUNLinSolFreeEmpty(linear_solver);
        N_VDestroy(view);
        SUNContext_Free(&context);
      }

      void
      create(const double start_cycles);

      /// Take from a stage that has been solved what the next one starts from.
      void
      finish_stage();

      /**
       * Newton's correction for the residual -@p b at the last iterate. If the
       * correction before has led beyond the minimum of the convex function
       * whose gradient the residual is, the way back to the minimum on its line
       * (secant) comes first: between two active sets the plain iteration may
       * go to and fro for ever.
       */
      Eigen::VectorXd
      newton_correction(Eigen::VectorXd b, const double gamma);

      /// Throw what a callback threw, or translate a return code.
      void
      check(const int flag, const std::string &function);

      WearEquation       equation;
      double             tolerance;
      std::exception_ptr exception;

      double          cycles = 0.;
      Eigen::VectorXd y;
      Eigen::VectorXd weights;
      Eigen::VectorXd metric;

      /// Where the last step began, and the step that was to follow it.
      double          step_start = 0.;
      Eigen::VectorXd y_start;
      double          proposal = 0.;
      /// The last iterate, its rate and the correction that solved for it.
      Eigen::VectorXd                      iterate;
      Eigen::VectorXd                      rate;
      Eigen::MatrixXd                      jacobian;
      Eigen::PartialPivLU<Eigen::MatrixXd> newton_matrix;
      Eigen::VectorXd                      residual;
      Eigen::VectorXd                      correction;
      /// Slope of the line that Newton's iteration starts from; empty at first.
      Eigen::VectorXd slope;
      bool            stage_solved = false;
      double          stage_cycles = 0.;
      Eigen::VectorXd end_rate;

      SUNContext      context       = nullptr;
      void           *arkode        = nullptr;
      N_Vector        view          = nullptr; ///< of y
      SUNLinearSolver linear_solver = nullptr;
    };



    namespace
    {
      using View = Eigen::Map<Eigen::VectorXd>;

      View
      view_of(const N_Vector x)
      {
        return {N_VGetArrayPointer(x),
                static_cast<Eigen::Index>(N_VGetLength(x))};
      }



      // Exceptions must not pass through C: kept, and rethrown by check().
      template <typename Function>
      int
      guarded(std::exception_ptr &exception, const Function &function)
      {
        try
          {
            function();
            return 0;
          }
        catch (...)
          {
            exception = std::current_exception();
            return -1;
          }
      }



      template <typename Memory>
      int
      rate_callback(realtype cycles, N_Vector y, N_Vector rate, void *data)
      {
        Memory &memory = *static_cast<Memory *>(data);
        return guarded(memory.exception, [&]() {
          memory.iterate = view_of(y);
          memory.rate    = memory.equation.rate(cycles, memory.iterate);
          view_of(rate)  = memory.rate;
        });
      }



      template <typename Memory>
      int
      event_callback(realtype, N_Vector y, realtype *values, void *data)
      {
        Memory &memory = *static_cast<Memory *>(data);
        return guarded(memory.exception, [&]() {
          View(values, memory.equation.n_events) =
            memory.equation.events(view_of(y));
        });
      }



      // ARKODE's norm is a mean over the entries.
      template <typename Memory>
      int
      weight_callback(N_Vector, N_Vector weights, void *data)
      {
        const Memory &memory = *static_cast<Memory *>(data);
        const double  n      = memory.weights.size();
        view_of(weights) =
          memory.weights.cwiseMax(1e-30) * (std::sqrt(n) / memory.tolerance);
        return 0;
      }



      // On the line through the beginning of the step and the last stage; for
      // the first stage, through the step before.
      template <typename Memory>
      int
      predict_callback(realtype cycles, N_Vector prediction, void *data)
      {
        Memory &memory = *static_cast<Memory *>(data);
        memory.finish_stage();
        memory.stage_solved = false;
        memory.stage_cycles = cycles;
        if (memory.slope.size() > 0)
          view_of(prediction) =
            memory.y_start + (cycles - memory.step_start) * memory.slope;
        return 0;
      }



      SUNLinearSolver_Type
      solver_type(SUNLinearSolver)
      {
        return SUNLINEARSOLVER_MATRIX_EMBEDDED;
      }



      // (I - gamma J) x = b with J at the iterate whose residual is b: ARKODE
      // has just evaluated it.
      template <typename Memory>
      int
      solve_callback(SUNLinearSolver solver,
                     SUNMatrix,
                     N_Vector x,
                     N_Vector b,
                     realtype)
      {
        Memory &memory = *static_cast<Memory *>(solver->content);
        return guarded(memory.exception, [&]() {
          double gamma = 0.;
          memory.check(ARKStepGetCurrentGamma(memory.arkode, &gamma),
                       "ARKStepGetCurrentGamma");
          view_of(x) = memory.newton_correction(view_of(b), gamma);
        });
      }



      // Part of the slope along a correction, with the opposite sign, that is
      // tolerated at its end.
      constexpr double max_overshoot = 0.3;



      void
      silent(int, const char *, const char *, char *, void *)
      {}
    } // namespace



    Eigen::VectorXd
    ImplicitExtrapolation::Memory::newton_correction(Eigen::VectorXd b,
                                                     const double    gamma)
    {
      Eigen::VectorXd way_back = Eigen::VectorXd::Zero(b.size());
      if (stage_solved)
        {
          const double before = correction.cwiseProduct(metric).dot(residual);
          const double after  = correction.cwiseProduct(metric).dot(b);
          if (after < -max_overshoot * before)
            {
              way_back = -std::min(0.9, after / (after - before)) * correction;
              const Eigen::VectorXd rate_there = rate;
              iterate += way_back;
              rate = equation.rate(stage_cycles, iterate);
              b += gamma * (rate - rate_there) - way_back;
            }
        }

      jacobian               = equation.jacobian();
      Eigen::MatrixXd matrix = -gamma * jacobian;
      matrix.diagonal().array() += 1.;
      newton_matrix.compute(matrix);
      residual     = b;
      correction   = newton_matrix.solve(residual);
      stage_solved = true;
      // ARKODE sees the sum, and a small sum would be convergence.
      if ((way_back + correction).norm() < 0.5 * way_back.norm())
        correction *= 0.5;
      return way_back + correction;
    }



    void
    ImplicitExtrapolation::Memory::finish_stage()
    {
      if (!stage_solved)
        return;
      slope = (iterate + correction - y_start) / (stage_cycles - step_start);
      stage_solved = false;
    }



    void
    ImplicitExtrapolation::Memory::check(const int          flag,
                                         const std::string &function)
    {
      if (exception)
        std::rethrow_exception(std::exchange(exception, nullptr));
      if (flag >= 0)
        return;
      char             *name = ARKStepGetReturnFlagName(flag);
      const std::string code = name;
      std::free(name);
      throw ExcRun("The integration of wear stopped after " +
                   std::to_string(cycles) + " cycles (" + function +
                   " of SUNDIALS returned " + code +
                   "). A larger 'Wear/Tolerance' or a finer mesh may help.");
    }



    void
    ImplicitExtrapolation::Memory::create(const double start_cycles)
    {
      check(SUNContext_Create(nullptr, &context), "SUNContext_Create");
      view   = N_VMake_Serial(y.size(), y.data(), context);
      arkode = ARKStepCreate(
        nullptr, rate_callback<Memory>, start_cycles, view, context);
      linear_solver = SUNLinSolNewEmpty(context);
      AssertThrow(arkode != nullptr && linear_solver != nullptr,
                  ExcRun("SUNDIALS could not allocate its memory."));
      linear_solver->content      = this;
      linear_solver->ops->gettype = solver_type;
      linear_solver->ops->solve   = solve_callback<Memory>;

      check(ARKStepSetErrHandlerFn(arkode, silent, nullptr),
            "ARKStepSetErrHandlerFn");
      check(ARKStepSetUserData(arkode, this), "ARKStepSetUserData");
      check(ARKStepWFtolerances(arkode, weight_callback<Memory>),
            "ARKStepWFtolerances");
      check(ARKStepSetTableNum(arkode,
                               ARKODE_ESDIRK325L2SA_5_2_3,
                               ARKODE_ERK_NONE),
            "ARKStepSetTableNum");
      // Every step is the first one of its equation: no history for a
      // controller that looks further back.
      check(ARKStepSetAdaptivityMethod(arkode, ARK_ADAPT_I, 1, 0, nullptr),
            "ARKStepSetAdaptivityMethod");
      // What Newton leaves stands in the pressure, and no error estimate sees
      // it.
      check(ARKStepSetNonlinConvCoef(arkode, 0.02), "ARKStepSetNonlinConvCoef");
      check(ARKStepSetStagePredictFn(arkode, predict_callback<Memory>),
            "ARKStepSetStagePredictFn");
      check(ARKStepSetLinearSolver(arkode, linear_solver, nullptr),
            "ARKStepSetLinearSolver");
      // The slope at a solved stage follows from the stage: no evaluation, and
      // no amplification of what Newton left.
      check(ARKStepSetDeduceImplicitRhs(arkode, SUNTRUE),
            "ARKStepSetDeduceImplicitRhs");
      check(ARKStepSetMaxNonlinIters(arkode, 15), "ARKStepSetMaxNonlinIters");
      if (equation.n_events > 0)
        check(ARKStepRootInit(arkode,
                              equation.n_events,
                              event_callback<Memory>),
              "ARKStepRootInit");
    }



    ImplicitExtrapolation::ImplicitExtrapolation(const WearEquation &equation,
                                                 const double        tolerance)
      : memory(std::make_unique<Memory>(equation, tolerance))
    {}



    ImplicitExtrapolation::~ImplicitExtrapolation() = default;



    void
    ImplicitExtrapolation::start(const double           cycles,
                                 const Eigen::VectorXd &y,
                                 const Eigen::VectorXd &weights,
                                 const Eigen::VectorXd &metric,
                                 const double           max_step)
    {
      Memory &m    = *memory;
      m.cycles     = cycles;
      m.y          = y;
      m.weights    = weights;
      m.metric     = metric;
      m.step_start = cycles;
      m.y_start    = y;
      if (m.arkode == nullptr)
        {
          m.create(cycles);
          const double change =
            m.equation.rate(cycles, y).cwiseProduct(weights).norm();
          if (change > 0.)
            m.proposal = 1. / change;
        }
      else
        m.check(ARKStepReset(m.arkode, cycles, m.view), "ARKStepReset");
      if (max_step > 0. && max_step < m.proposal)
        m.proposal = max_step;
      m.check(ARKStepSetInitStep(m.arkode, m.proposal), "ARKStepSetInitStep");
    }



    bool
    ImplicitExtrapolation::step(const double end)
    {
      Memory &m = *memory;
      m.check(ARKStepSetStopTime(m.arkode, end), "ARKStepSetStopTime");
      const int flag =
        ARKStepEvolve(m.arkode, end, m.view, &m.cycles, ARK_ONE_STEP);
      m.check(flag, "ARKStepEvolve");

      m.finish_stage();
      m.end_rate       = m.rate + m.jacobian * m.correction;
      double last_step = 0., next_step = 0.;
      m.check(ARKStepGetLastStep(m.arkode, &last_step), "ARKStepGetLastStep");
      m.check(ARKStepGetCurrentStep(m.arkode, &next_step),
              "ARKStepGetCurrentStep");
      // A step that was cut short to end where it had to says little about the
      // next one.
      m.proposal = last_step < m.proposal && m.cycles == end
                     ? std::max(m.proposal, next_step)
                     : next_step;
      return flag == ARK_ROOT_RETURN;
    }



    double
    ImplicitExtrapolation::cycles() const
    {
      return memory->cycles;
    }



    const Eigen::VectorXd &
    ImplicitExtrapolation::state() const
    {
      return memory->y;
    }



    Eigen::VectorXd
    ImplicitExtrapolation::local_error() const
    {
      Eigen::VectorXd error(memory->y.size());
      N_Vector nv = N_VMake_Serial(error.size(), error.data(), memory->context);
      const int flag = ARKStepGetEstLocalErrors(memory->arkode, nv);
      N_VDestroy(nv);
      memory->check(flag, "ARKStepGetEstLocalErrors");
      return error;
    }



    const Eigen::VectorXd &
    ImplicitExtrapolation::end_rate() const
    {
      return memory->end_rate;
    }



    Eigen::VectorXd
    ImplicitExtrapolation::damp(const Eigen::VectorXd &perturbation) const
    {
      return memory->newton_matrix.solve(perturbation);
    }
  } // namespace Wear
} // namespace Tribody
