// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_implicit_jump_h
#define tribody_stepping_implicit_jump_h

#include <Eigen/Core>

#include <tribody/stepping/cycle_jump.h>
#include <tribody/wear/implicit_extrapolation.h>
#include <tribody/wear/stage_matrix.h>

#include <deque>
#include <optional>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * Implicit steps of Wear::ImplicitExtrapolation. Its state y is the
     * cross-section area [m^2] that every wearing node has lost since the step
     * began, and the depth follows from it: so the volume that bushings and
     * pins lose is what the wear law has removed, however long the step.
     *
     * A stage @f$ y = a + \gamma W(y) @f$ is the contact problem of all samples
     * of the cycle together, with the wear as one more way in which the bore
     * gives way. It is solved as such by the primal-dual active set method:
     * the nodes in contact are given in each sample, forces and wear follow
     * from linear equations (up to the curvature of the exact gap), and from
     * the forces and gaps the nodes that should be in contact. If their number
     * of errors does not fall, they are changed one by one
     * (@cite portugal1994). Contact problems that are solved for a given wear
     * would be ill-posed where the bore is stiff: forces over displacements
     * that the wear decides.
     *
     * The error of the depth counts as
     * @f[ \frac{1}{h_\text{max}} \sqrt{\frac{\int e^2\,ds}{\ell}}, \qquad
     *     \ell = \frac{\int h\,ds}{h_\text{max}}, @f]
     * its root mean square over the worn arc of a surface, relative to its
     * largest depth. For a bushing whose pin does not wear, this is also the
     * norm in which the equation of wear is contractive (its Jacobian is
     * symmetric in it and nowhere positive): what one step leaves, later ones
     * do not enlarge. With both surfaces the equation is contractive in
     * @f$ \sum_i y_i^2/(k_i D_i) @f$, each surface with its own coefficient k;
     * measured in it the surface that wears less would set the steps for both.
     * If k depends on the pressure no such norm is known.
     */
    class ImplicitJump : public CycleJump
    {
    public:
      /// @param tolerance relative error of the depth that a step may make.
      ImplicitJump(const std::deque<WearingBushing> &bushings,
                   const StopConditions             &stop_conditions,
                   const double                      tolerance);

      WearStep
      advance(RunState &state, const double end) override;

      std::vector<StepError>
      estimate_error(RunState &state, const double cycles_kept) override;

    private:
      Wear::WearEquation
      make_equation();

      std::optional<Eigen::VectorXd>
      solve_stage(const double           cycles,
                  const Eigen::VectorXd &a,
                  const double           gamma,
                  const Eigen::VectorXd &guess);

      /// One step of the contacts after the wear @p y at @p cycles from
      /// #contacts, with the nodes held that those name.
      std::vector<CycleContact>
      hold_nodes(const double cycles, const Eigen::VectorXd &y) const;

      /// Over all samples, held though they should not be, or the other way
      /// round.
      std::size_t
      count_wrong_nodes() const;

      /// Go on to the nodes that should be held, or change one of them in each
      /// sample.
      void
      change_nodes(const bool one_by_one);

      /// dW/dy with the nodes held that #contacts name.
      Eigen::MatrixXd
      compute_jacobian() const;

      /// What an error of y counts.
      void
      compute_weights(const std::vector<CycleContact> &contacts);

      /// Begin the iterations with @p begin, or with what is better.
      void
      take_contacts(const std::vector<CycleContact> &begin);

      Eigen::VectorXd
      rate_of(const std::vector<CycleContact> &contacts) const;

      std::vector<Eigen::VectorXd>
      depths_after(const Eigen::VectorXd &y) const;

      /// The part of @p y that belongs to bushing @p j.
      Eigen::VectorXd
      part(const Eigen::VectorXd &y, const std::size_t j) const;

      double tolerance;
      /// Of each bushing in y; then the number of entries.
      std::vector<Eigen::Index> first_entry;

      // Of the step under way, or of the last one until its error is known.
      Wear::ImplicitExtrapolation integrator;
      const RunState             *run = nullptr;
      /// Of the last iteration.
      std::vector<CycleContact> contacts;
      Wear::StageMatrix         stage_matrix;
      unsigned int              n_evaluations = 0;
      Eigen::VectorXd           weights;
      /// Of each surface of each bushing at the start of the step [m].
      std::vector<std::vector<double>> largest_depths;
    };
  } // namespace Coupling
} // namespace Tribody

#endif
