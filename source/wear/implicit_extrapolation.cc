#include <Eigen/LU>
#include <arkode/arkode_arkstep.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>

#include <tribody/base/exceptions.h>
#include <tribody/wear/implicit_extrapolation.h>

#include <algorithm>
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
      Memory(const WearEquation &equation, const ImplicitSettings &settings)
        : equation(equation)
        , settings(settings)
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

      /// Throw what a callback threw, or translate a return code.
      void
      check(const int flag, const std::string &function);

      WearEquation       equation;
      ImplicitSettings   settings;
      std::exception_ptr exception;

      double          cycles = 0.;
      Eigen::VectorXd y;

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
      rate_callback(realtype, N_Vector y, N_Vector rate, void *data)
      {
        Memory &memory = *static_cast<Memory *>(data);
        return guarded(memory.exception, [&]() {
          view_of(rate) = memory.equation.rate(view_of(y));
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



      // The error of every depth is measured by the largest one.
      template <typename Memory>
      int
      weight_callback(N_Vector y, N_Vector weights, void *data)
      {
        const ImplicitSettings &settings =
          static_cast<Memory *>(data)->settings;
        const Eigen::Index n = settings.n_depths;
        const double       depth =
          std::max(settings.depth_floor, view_of(y).head(n).maxCoeff());
        // ARKODE's norm is a mean over all entries, those that do not count
        // included, while the depth asks for the worst one.
        View w    = view_of(weights);
        w         = Eigen::VectorXd::Constant(w.size(), 1e-30);
        w.head(n) = Eigen::VectorXd::Constant(n,
                                              std::sqrt(double(w.size())) /
                                                (settings.tolerance * depth));
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
          Eigen::MatrixXd matrix = -gamma * memory.equation.jacobian();
          matrix.diagonal().array() += 1.;
          view_of(x) = matrix.partialPivLu().solve(view_of(b));
        });
      }



      void
      silent(int, const char *, const char *, char *, void *)
      {}
    } // namespace



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
      check(ARKStepSetLinearSolver(arkode, linear_solver, nullptr),
            "ARKStepSetLinearSolver");
      // The slope at a solved stage follows from the stage: no evaluation, and
      // no amplification of what Newton left.
      check(ARKStepSetDeduceImplicitRhs(arkode, SUNTRUE),
            "ARKStepSetDeduceImplicitRhs");
      check(ARKStepSetMaxNonlinIters(arkode, 10), "ARKStepSetMaxNonlinIters");
      if (equation.n_events > 0)
        check(ARKStepRootInit(arkode,
                              equation.n_events,
                              event_callback<Memory>),
              "ARKStepRootInit");
    }



    ImplicitExtrapolation::ImplicitExtrapolation(
      const WearEquation     &equation,
      const ImplicitSettings &settings)
      : memory(std::make_unique<Memory>(equation, settings))
    {}



    ImplicitExtrapolation::~ImplicitExtrapolation() = default;



    void
    ImplicitExtrapolation::start(const double cycles, const Eigen::VectorXd &y)
    {
      Memory &m = *memory;
      m.cycles  = cycles;
      if (m.arkode == nullptr)
        {
          m.y = y;
          m.create(cycles);
          return;
        }
      double next_step = 0.;
      m.check(ARKStepGetCurrentStep(m.arkode, &next_step),
              "ARKStepGetCurrentStep");
      m.y = y;
      m.check(ARKStepReset(m.arkode, cycles, m.view), "ARKStepReset");
      m.check(ARKStepSetInitStep(m.arkode, next_step), "ARKStepSetInitStep");
    }



    bool
    ImplicitExtrapolation::step(const double end)
    {
      Memory &m = *memory;
      m.check(ARKStepSetStopTime(m.arkode, end), "ARKStepSetStopTime");
      const int flag =
        ARKStepEvolve(m.arkode, end, m.view, &m.cycles, ARK_ONE_STEP);
      m.check(flag, "ARKStepEvolve");
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
  } // namespace Wear
} // namespace Tribody
