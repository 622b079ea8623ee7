#ifndef tribody_coupling_cycle_jump_h
#define tribody_coupling_cycle_jump_h

#include <Eigen/Core>

#include <tribody/coupling/run_state.h>
#include <tribody/coupling/stop_conditions.h>
#include <tribody/wear/constant_extrapolation.h>
#include <tribody/wear/implicit_extrapolation.h>

#include <list>
#include <memory>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * Carries the wear of one cycle over many: one step of @f$ dh/dN = W(h)
     * @f$ for all bushings together, under the duty cycle that RunState holds.
     */
    class CycleJump
    {
    public:
      CycleJump(std::list<WearingBushing> &bushings,
                const StopConditions      &stop_conditions);

      virtual ~CycleJump() = default;

      /**
       * Let the bushings wear, at most up to @p end [cycles].
       * @param state duty cycle and contacts at its number of cycles; cycles
       *   and totals are moved on.
       * @return index of the stop condition that was reached, or -1.
       */
      virtual int
      advance(RunState &state, const double end) = 0;

      /**
       * Estimate of the error of the last step in bushing @p b [m], one value
       * per bore node, now that @p rate_after is known: the wear rate at its
       * end [m per cycle], under the duty cycle that belongs to the new shape.
       */
      virtual Eigen::VectorXd
      estimate_error(const std::size_t      b,
                     const Eigen::VectorXd &rate_after) const = 0;

      virtual unsigned int
      n_rate_evaluations() const = 0;

    protected:
      std::list<WearingBushing> &bushings;
      const StopConditions      &stop_conditions;
    };

    /**
     * The paper's constant extrapolation: Wear::ConstantExtrapolation with the
     * rates that RunState holds.
     */
    class ConstantJump : public CycleJump
    {
    public:
      /// @param cycles_per_step A_E; 0: a safe part of the stable length.
      ConstantJump(std::list<WearingBushing> &bushings,
                   const StopConditions      &stop_conditions,
                   const double               cycles_per_step);

      int
      advance(RunState &state, const double end) override;

      Eigen::VectorXd
      estimate_error(const std::size_t      b,
                     const Eigen::VectorXd &rate_after) const override;

      unsigned int
      n_rate_evaluations() const override
      {
        return 0;
      }

    private:
      void
      update_stable_step(RunState &state);

      double cycles_per_step;
      /// Compliance builds that the stable length belongs to.
      unsigned int                 stable_step_builds = 0;
      double                       last_step          = 0.;
      std::vector<Eigen::VectorXd> rates_before;
    };

    /// Implicit steps of Wear::ImplicitExtrapolation.
    class ImplicitJump : public CycleJump
    {
    public:
      /// @param tolerance relative error of the depth that a step may make.
      ImplicitJump(std::list<WearingBushing> &bushings,
                   const StopConditions      &stop_conditions,
                   const double               tolerance);

      int
      advance(RunState &state, const double end) override;

      Eigen::VectorXd
      estimate_error(const std::size_t      b,
                     const Eigen::VectorXd &rate_after) const override;

      unsigned int
      n_rate_evaluations() const override
      {
        return n_evaluations;
      }

    private:
      Wear::WearEquation
      make_equation();

      Eigen::VectorXd
      compute_rate(const Eigen::VectorXd &y);

      Eigen::MatrixXd
      compute_jacobian() const;

      /// Depths of all bushings, then the volume removed from each.
      Eigen::VectorXd
      pack(const RunState &state) const;

      std::vector<Eigen::VectorXd>
      depths_in(const Eigen::VectorXd &y) const;

      Wear::ImplicitSettings      settings;
      Wear::ImplicitExtrapolation integrator;
      const Multibody::DutyCycle *duty_cycle = nullptr;
      /// The last state whose rate was computed, and its contacts.
      Eigen::VectorXd           last_y;
      std::vector<CycleContact> contacts;
      unsigned int              n_evaluations = 0;
      double                    last_step     = 0.;
      Eigen::VectorXd           last_error;
    };
  } // namespace Coupling
} // namespace Tribody

#endif
