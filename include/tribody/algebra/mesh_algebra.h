// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_algebra_mesh_algebra_h
#define tribody_algebra_mesh_algebra_h

#include <deal.II/base/index_set.h>
#include <deal.II/lac/la_parallel_vector.h>

namespace dealii
{
  template <typename Number>
  class AffineConstraints;
  template <int dim, int spacedim>
  class DoFHandler;
  template <int dim, int spacedim>
  class Triangulation;

  namespace TrilinosWrappers
  {
    class SparseMatrix;
  }
} // namespace dealii

namespace Tribody
{
  /**
   * A field over the degrees of freedom of a mesh. A rank owns its share of
   * the entries, and if the mesh is distributed it holds copies of those at
   * the edge of its share; on a serial mesh it owns all of them.
   */
  using MeshVector = dealii::LinearAlgebra::distributed::Vector<double>;

  /// Whether the ranks share the cells of this mesh: whether it is a
  /// parallel::distributed::Triangulation.
  bool
  is_distributed(const dealii::Triangulation<2, 2> &triangulation);

  /// The degrees of freedom on the cells that this rank owns, and on those
  /// next to them.
  dealii::IndexSet
  relevant_dofs(const dealii::DoFHandler<2, 2> &dof_handler);

  /// A field that is zero.
  MeshVector
  make_mesh_vector(const dealii::DoFHandler<2, 2> &dof_handler);

  /// Give @p matrix the rows that this rank owns and the entries that
  /// DoFTools::make_sparsity_pattern() finds with the same arguments.
  void
  reinit_matrix(const dealii::DoFHandler<2, 2>          &dof_handler,
                const dealii::AffineConstraints<double> &constraints,
                const bool                               keep_constrained_dofs,
                dealii::TrilinosWrappers::SparseMatrix  &matrix);
} // namespace Tribody

#endif
