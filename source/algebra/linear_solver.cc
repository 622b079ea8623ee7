// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/dofs/dof_handler.h>

#include <tribody/algebra/direct_solver.h>
#include <tribody/algebra/mesh_algebra.h>
#include <tribody/algebra/multigrid_solver.h>

namespace Tribody
{
  std::unique_ptr<LinearSolver>
  make_linear_solver(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                     const dealii::DoFHandler<2, 2>               &dof_handler,
                     const SlowModes                               slow_modes)
  {
    if (is_distributed(dof_handler.get_triangulation()))
      return std::make_unique<MultigridSolver>(matrix, dof_handler, slow_modes);
    return std::make_unique<DirectSolver>(matrix);
  }
} // namespace Tribody
