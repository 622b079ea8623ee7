#ifndef tribody_coupling_implicit_jump_h
#define tribody_coupling_implicit_jump_h

#include <tribody/coupling/cycle_jump.h>
#include <tribody/wear/implicit_extrapolation.h>

#include <list>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * Implicit steps of Wear::ImplicitExtrapolation. Its state y is the
     * cross-section area [m^2] that every bore node has lost since the step
     * began, and the depth follows from it: so the volume that the bushings
     * lose is what Archard's law has removed, however long the step.
     *
     * The error of the depth counts as
     * @f[ \frac{1}{h_\text{max}} \sqrt{\frac{\int e^2\,ds}{\ell}}, \qquad
     *     \ell = \frac{\int h\,ds}{h_\text{max}}, @f]
     * its root mean square over the worn arc, relative to the largest depth.
     * This is also the norm in which the equation of wear is contractive (its
     * Jacobian is symmetric in it and nowhere positive): what one step leaves,
     * later ones do not enlarge.
     */
    class ImplicitJump : public CycleJump
    {
    public:
      /// @param tolerance relative error of the depth that a step may make.
      ImplicitJump(std::list<WearingBushing> &bushings,
                   const StopConditions      &stop_conditions,
                   const double               tolerance);

      int
      advance(RunState &state, const double end) override;

      std::vector<StepError>
      estimate_error(const std::vector<CycleContact> &contacts_after) override;

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

      /// What an error of y counts.
      void
      compute_weights();

      std::vector<Eigen::VectorXd>
      depths_after(const Eigen::VectorXd &y) const;

      /// The part of @p y that belongs to bushing @p b.
      Eigen::VectorXd
      part(const Eigen::VectorXd &y, const std::size_t b) const;

      double tolerance;
      /// Of each bushing in y; then the number of entries.
      std::vector<Eigen::Index>   first_entry;
      Wear::ImplicitExtrapolation integrator;
      const Multibody::DutyCycle *duty_cycle = nullptr;
      /// The last state whose rate was computed, and its contacts.
      Eigen::VectorXd           last_y;
      std::vector<CycleContact> contacts;
      unsigned int              n_evaluations = 0;
      double                    last_step     = 0.;
      /// Bound of the next step [cycles] from what changes between steps.
      double          max_step = 0.;
      Eigen::VectorXd weights;
      /// Derivative of the area with respect to the depth, and the largest
      /// depth and the worn arc of each bushing, at the start of the step [m].
      std::vector<Eigen::VectorXd> area_derivatives;
      std::vector<double>          largest_depths;
      std::vector<double>          worn_arcs;
    };
  } // namespace Coupling
} // namespace Tribody

#endif
