// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_algebra_linear_solver_h
#define tribody_algebra_linear_solver_h

#include <Eigen/Core>

#include <memory>

namespace dealii
{
  template <int dim, int spacedim>
  class DoFHandler;

  namespace TrilinosWrappers
  {
    class SparseMatrix;
  }
} // namespace dealii

namespace Tribody
{
  /**
   * A sparse matrix, made ready once to be solved for blocks of right-hand
   * sides. Of all vectors a rank holds the rows that it owns; all ranks of the
   * matrix must call together.
   */
  class LinearSolver
  {
  public:
    virtual ~LinearSolver() = default;

    /// The solutions for the columns of @p right_hand_sides.
    virtual Eigen::MatrixXd
    solve(const Eigen::Ref<const Eigen::MatrixXd> &right_hand_sides) const = 0;
  };

  /// Fields of a vector-valued equation that cost it little energy, which
  /// coarse levels of a multigrid method must represent.
  enum class SlowModes
  {
    /// One for each component.
    constants,
    /// Constants, and the rotation about the origin.
    rigid_motions
  };

  /**
   * The solver for a symmetric and positive definite @p matrix over the degrees
   * of freedom of @p dof_handler: DirectSolver if every rank holds the whole
   * mesh, MultigridSolver if the ranks share it. The matrix must outlive it.
   */
  std::unique_ptr<LinearSolver>
  make_linear_solver(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                     const dealii::DoFHandler<2, 2>               &dof_handler,
                     const SlowModes                               slow_modes);
} // namespace Tribody

#endif
