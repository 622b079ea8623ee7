// SPDX-License-Identifier: LGPL-2.1-or-later

#include <arkode/arkode_arkstep.h>
#include <boost/math/tools/toms748_solve.hpp>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_nonlinearsolver.h>

#include <tribody/base/exceptions.h>
#include <tribody/sundials/callbacks.h>
#include <tribody/sundials/vector_view.h>
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
        release();
      }

      Memory(const Memory &) = delete;
      Memory &
      operator=(const Memory &) = delete;

      void
      create(const double start_cycles);

      void
      release();

      /// Solve the stage that ARKODE is at; its correction of the prediction.
      int
      solve_stage(Eigen::Map<Eigen::VectorXd> correction);

      /// The largest of the events; negative before any has happened.
      double
      largest_event() const;

      /// One step, not beyond @p end, and what it proposes for the next one.
      void
      take_step(const double end);

      /// The last step once more, @p n_cycles long. @return the largest event.
      double
      retake_step(const double n_cycles);

      /**
       * Move the end of the step along the line from its beginning to where the
       * largest event, which is @p value, becomes zero. Stages are solved to a
       * small part of the tolerance only, which differs with where their
       * iterations begin: below that no length of the step is the right one.
       * For the little that is missing a line is as good as the step.
       */
      void
      move_end_to_event(const double value);

      /// Throw what a callback threw, or translate a return code.
      void
      check(const int flag, const std::string &function);

      WearEquation       equation;
      double             tolerance;
      std::exception_ptr exception;

      double          cycles = 0.;
      Eigen::VectorXd y;
      Eigen::VectorXd weights;

      /// Where the last step began.
      double          step_start = 0.;
      Eigen::VectorXd y_start;
      /// Given at the beginning of the step, and found by the last stage.
      Eigen::VectorXd     start_rate;
      Eigen::VectorXd     end_rate;
      ExtrapolationMemory lasting;

      SUNContext         context      = nullptr;
      void              *arkode       = nullptr;
      N_Vector           view         = nullptr; ///< of y
      SUNNonlinearSolver stage_solver = nullptr;
    };



    namespace
    {
      // ARKODE asks for it at the beginning of a step only.
      template <typename Memory>
      int
      rate_callback(realtype, N_Vector, N_Vector rate, void *data)
      {
        Sundials::view(rate) = static_cast<Memory *>(data)->start_rate;
        return 0;
      }



      // ARKODE's norm is a mean over the entries.
      template <typename Memory>
      int
      weight_callback(N_Vector, N_Vector weights, void *data)
      {
        const Memory &memory = *static_cast<Memory *>(data);
        const double  n      = memory.weights.size();
        Sundials::view(weights) =
          memory.weights.cwiseMax(1e-30) * (std::sqrt(n) / memory.tolerance);
        return 0;
      }



      SUNNonlinearSolver_Type
      solver_type(SUNNonlinearSolver)
      {
        return SUNNONLINEARSOLVER_ROOTFIND;
      }



      // The residual that ARKODE offers is not needed.
      int
      ignore_residual(SUNNonlinearSolver, SUNNonlinSolSysFn)
      {
        return SUN_NLS_SUCCESS;
      }



      template <typename Memory>
      int
      solve_callback(SUNNonlinearSolver solver,
                     N_Vector,
                     N_Vector correction,
                     N_Vector,
                     realtype,
                     booleantype,
                     void *)
      {
        Memory   &memory = *static_cast<Memory *>(solver->content);
        const int status = Sundials::guarded(memory.exception, [&]() {
          return memory.solve_stage(Sundials::view(correction));
        });
        return memory.exception ? SUN_NLS_EXT_FAIL : status;
      }



      // From one step to the next; ARKODE's default.
      constexpr double max_growth = 20.;

      // What an event may be off by where it ends the integration.
      constexpr double event_tolerance = 1e-10;
      // Steps that are taken to find it; exact ones need half as many.
      constexpr boost::uintmax_t max_retakes = 20;
    } // namespace



    int
    ImplicitExtrapolation::Memory::solve_stage(
      Eigen::Map<Eigen::VectorXd> correction)
    {
      // y = prediction + correction, correction = data + gamma W(y).
      double   stage_cycles = 0., gamma = 0.;
      N_Vector prediction = nullptr, data = nullptr, ignored = nullptr;
      void    *user_data = nullptr;
      check(ARKStepGetNonlinearSystemData(arkode,
                                          &stage_cycles,
                                          &prediction,
                                          &ignored,
                                          &ignored,
                                          &gamma,
                                          &data,
                                          &user_data),
            "ARKStepGetNonlinearSystemData");
      const Eigen::VectorXd a =
        Sundials::view(prediction) + Sundials::view(data);
      Eigen::VectorXd guess = y_start;
      if (lasting.slope.size() > 0)
        guess += (stage_cycles - step_start) * lasting.slope;

      const auto solution = equation.solve_stage(stage_cycles, a, gamma, guess);
      if (!solution.has_value())
        return SUN_NLS_CONV_RECVR;
      correction    = *solution - Sundials::view(prediction);
      end_rate      = (*solution - a) / gamma;
      lasting.slope = (*solution - y_start) / (stage_cycles - step_start);
      return SUN_NLS_SUCCESS;
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
                   "). A larger 'Wear/Tolerance' or a finer mesh may help" +
                   (cycles < 1. ? ", if the wear of a single cycle is small: "
                                  "look at 'Wear coefficient' and its factors."
                                : "."));
    }



    void
    ImplicitExtrapolation::Memory::create(const double start_cycles)
    {
      check(SUNContext_Create(nullptr, &context), "SUNContext_Create");
      view   = N_VMake_Serial(y.size(), y.data(), context);
      arkode = ARKStepCreate(
        nullptr, rate_callback<Memory>, start_cycles, view, context);
      stage_solver = SUNNonlinSolNewEmpty(context);
      AssertThrow(arkode != nullptr && stage_solver != nullptr,
                  ExcRun("SUNDIALS could not allocate its memory."));
      stage_solver->content       = this;
      stage_solver->ops->gettype  = solver_type;
      stage_solver->ops->setsysfn = ignore_residual;
      stage_solver->ops->solve    = solve_callback<Memory>;

      check(ARKStepSetErrHandlerFn(arkode,
                                   Sundials::silent_error_handler,
                                   nullptr),
            "ARKStepSetErrHandlerFn");
      check(ARKStepSetUserData(arkode, this), "ARKStepSetUserData");
      check(ARKStepWFtolerances(arkode, weight_callback<Memory>),
            "ARKStepWFtolerances");
      check(ARKStepSetTableNum(arkode,
                               ARKODE_ESDIRK32I5L2SA_5_2_3,
                               ARKODE_ERK_NONE),
            "ARKStepSetTableNum");
      // Every step is the first one of its equation: no history for a
      // controller that looks further back.
      check(ARKStepSetAdaptivityMethod(arkode, ARK_ADAPT_I, 1, 0, nullptr),
            "ARKStepSetAdaptivityMethod");
      check(ARKStepSetNonlinearSolver(arkode, stage_solver),
            "ARKStepSetNonlinearSolver");
      // The slope at a solved stage follows from the stage: no evaluation, and
      // no amplification of what its solution left.
      check(ARKStepSetDeduceImplicitRhs(arkode, SUNTRUE),
            "ARKStepSetDeduceImplicitRhs");
    }



    void
    ImplicitExtrapolation::Memory::release()
    {
      ARKStepFree(&arkode);
      SUNNonlinSolFreeEmpty(stage_solver);
      N_VDestroy(view);
      SUNContext_Free(&context);
      stage_solver = nullptr;
      view         = nullptr;
    }



    ImplicitExtrapolation::ImplicitExtrapolation(const WearEquation &equation,
                                                 const double        tolerance)
      : memory(std::make_unique<Memory>(equation, tolerance))
    {}



    ImplicitExtrapolation::~ImplicitExtrapolation() = default;



    void
    ImplicitExtrapolation::start(const double           cycles,
                                 const Eigen::VectorXd &y,
                                 const Eigen::VectorXd &rate,
                                 const Eigen::VectorXd &weights,
                                 const double           max_step)
    {
      Memory &m    = *memory;
      m.cycles     = cycles;
      m.y          = y;
      m.weights    = weights;
      m.step_start = cycles;
      m.y_start    = y;
      m.start_rate = rate;
      // Made anew, so that nothing lasts but lasting_memory() tells.
      m.release();
      m.create(cycles);
      double    &proposal = m.lasting.proposal;
      const bool is_first = proposal == 0.;
      if (const double change = rate.cwiseProduct(weights).norm();
          proposal == 0. && change > 0.)
        proposal = 1. / change;
      if (max_step > 0. && max_step < proposal)
        proposal = max_step;
      m.check(ARKStepSetInitStep(m.arkode, proposal), "ARKStepSetInitStep");
      // For ARKODE each step is the first one, after which it may grow without
      // measure.
      if (!is_first)
        m.check(ARKStepSetMaxFirstGrowth(m.arkode, max_growth),
                "ARKStepSetMaxFirstGrowth");
    }



    double
    ImplicitExtrapolation::Memory::largest_event() const
    {
      return equation.n_events > 0 ? equation.events(y).maxCoeff() : -1.;
    }



    void
    ImplicitExtrapolation::Memory::take_step(const double end)
    {
      check(ARKStepSetStopTime(arkode, end), "ARKStepSetStopTime");
      check(ARKStepEvolve(arkode, end, view, &cycles, ARK_ONE_STEP),
            "ARKStepEvolve");
      double last_step = 0., next_step = 0.;
      check(ARKStepGetLastStep(arkode, &last_step), "ARKStepGetLastStep");
      check(ARKStepGetCurrentStep(arkode, &next_step), "ARKStepGetCurrentStep");
      // A step that was cut short to end where it had to says little about the
      // next one.
      double &proposal = lasting.proposal;
      proposal         = last_step < proposal && cycles == end
                           ? std::max(proposal, next_step)
                           : next_step;
    }



    double
    ImplicitExtrapolation::Memory::retake_step(const double n_cycles)
    {
      y      = y_start;
      cycles = step_start;
      check(ARKStepReset(arkode, cycles, view), "ARKStepReset");
      check(ARKStepSetInitStep(arkode, n_cycles), "ARKStepSetInitStep");
      take_step(step_start + n_cycles);
      return largest_event();
    }



    void
    ImplicitExtrapolation::Memory::move_end_to_event(const double value)
    {
      const Eigen::VectorXd change   = y - y_start;
      const double          n_cycles = cycles - step_start;
      double                event    = value;
      const auto            move_to  = [&](const double part) {
        y            = y_start + part * change;
        cycles       = step_start + part * n_cycles;
        return event = largest_event();
      };
      const double begin          = value < 0. ? 1. : 0.;
      const double event_at_begin = value < 0. ? value : move_to(0.);
      double       end            = 1.;
      double       event_at_end   = value;
      while (event_at_end < 0. && end < 8.)
        event_at_end = move_to(end *= 2.);
      AssertThrow(event_at_end >= 0.,
                  ExcRun("The integration of wear finds no end at " +
                         std::to_string(step_start) +
                         " cycles: a limit that a long step passes is not "
                         "passed in shorter ones. A smaller 'Wear/Tolerance' "
                         "may help."));
      boost::uintmax_t max_evaluations = 100;
      boost::math::tools::toms748_solve(
        move_to,
        begin,
        end,
        event_at_begin,
        event_at_end,
        [&](const double, const double) {
          return std::abs(event) < event_tolerance;
        },
        max_evaluations);
    }



    bool
    ImplicitExtrapolation::step(const double end)
    {
      Memory &m = *memory;
      // ARKODE would ask for the rate at the end of the step before.
      if (m.cycles != m.step_start)
        start(m.cycles,
              Eigen::VectorXd(m.y),
              Eigen::VectorXd(m.end_rate),
              Eigen::VectorXd(m.weights));
      const double before = m.largest_event();
      m.take_step(end);
      double value = m.largest_event();
      if (value < 0. || before >= 0.)
        return value >= 0.;

      // The step itself is taken again, as long as it may be: what ARKODE
      // interpolates within a step is less accurate than its end.
      const double     whole_step = m.cycles - m.step_start;
      double           best       = value;
      double           cycles     = m.cycles;
      Eigen::VectorXd  y          = m.y;
      boost::uintmax_t max_steps  = max_retakes;
      boost::math::tools::toms748_solve(
        [&](const double n_cycles) {
          value = m.retake_step(n_cycles);
          if (std::abs(value) < std::abs(best))
            {
              best   = value;
              cycles = m.cycles;
              y      = m.y;
            }
          return value;
        },
        0.,
        whole_step,
        before,
        value,
        [&](const double, const double) {
          return std::abs(value) < event_tolerance;
        },
        max_steps);
      m.cycles = cycles;
      m.y      = y;
      if (std::abs(best) >= event_tolerance)
        m.move_end_to_event(best);
      return true;
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



    const ExtrapolationMemory &
    ImplicitExtrapolation::lasting_memory() const
    {
      return memory->lasting;
    }



    void
    ImplicitExtrapolation::restore(const ExtrapolationMemory &lasting)
    {
      memory->lasting = lasting;
    }
  } // namespace Wear
} // namespace Tribody
