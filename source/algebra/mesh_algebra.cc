// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria_base.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <tribody/algebra/mesh_algebra.h>

namespace Tribody
{
  bool
  is_distributed(const dealii::Triangulation<2, 2> &triangulation)
  {
    return dynamic_cast<
             const dealii::parallel::DistributedTriangulationBase<2> *>(
             &triangulation) != nullptr;
  }



  dealii::IndexSet
  relevant_dofs(const dealii::DoFHandler<2, 2> &dof_handler)
  {
    return dealii::DoFTools::extract_locally_relevant_dofs(dof_handler);
  }



  MeshVector
  make_mesh_vector(const dealii::DoFHandler<2, 2> &dof_handler)
  {
    return MeshVector(dof_handler.locally_owned_dofs(),
                      relevant_dofs(dof_handler),
                      dof_handler.get_communicator());
  }



  void
  reinit_matrix(const dealii::DoFHandler<2, 2>          &dof_handler,
                const dealii::AffineConstraints<double> &constraints,
                const bool                               keep_constrained_dofs,
                dealii::TrilinosWrappers::SparseMatrix  &matrix)
  {
    const dealii::IndexSet        &owned    = dof_handler.locally_owned_dofs();
    const dealii::IndexSet         relevant = relevant_dofs(dof_handler);
    const MPI_Comm                 ranks    = dof_handler.get_communicator();
    dealii::DynamicSparsityPattern sparsity(dof_handler.n_dofs(),
                                            dof_handler.n_dofs(),
                                            relevant);
    dealii::DoFTools::make_sparsity_pattern(dof_handler,
                                            sparsity,
                                            constraints,
                                            keep_constrained_dofs);
    if (dealii::Utilities::MPI::n_mpi_processes(ranks) > 1)
      dealii::SparsityTools::distribute_sparsity_pattern(sparsity,
                                                         owned,
                                                         ranks,
                                                         relevant);
    matrix.reinit(owned, sparsity, ranks);
  }
} // namespace Tribody
