#include <deal.II/dofs/dof_handler.h>

#include <tribody/base/direct_solver.h>
#include <tribody/base/mesh_algebra.h>
#include <tribody/base/multigrid_solver.h>

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
