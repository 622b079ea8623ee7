// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_elasticity_stiffness_h
#define tribody_elasticity_stiffness_h

#include <tribody/elasticity/plane_state.h>

namespace dealii
{
  template <typename Number>
  class AffineConstraints;
  template <int dim, int spacedim>
  class DoFHandler;
  template <int dim, int spacedim>
  class Mapping;

  namespace TrilinosWrappers
  {
    class SparseMatrix;
  }
} // namespace dealii

namespace Tribody
{
  namespace Elasticity
  {
    /**
     * Assemble the stiffness @f$ \int \sigma(\varphi_j) : \varepsilon(
     * \varphi_i)\,dx @f$ [Pa] on the image of the mesh under @p mapping. The
     * element of @p dof_handler must be FESystem<2>(FE_Q<2>(p), 2). Rows and
     * columns of the degrees of freedom in @p constraints are replaced by
     * diagonal entries. Each rank goes over the cells that it owns.
     *
     * @param matrix what it held before is lost; its sparsity must be that of
     *   @p dof_handler and @p constraints.
     */
    void
    assemble_stiffness(const dealii::Mapping<2, 2>             &mapping,
                       const dealii::DoFHandler<2, 2>          &dof_handler,
                       const dealii::AffineConstraints<double> &constraints,
                       const PlaneHooke                        &law,
                       dealii::TrilinosWrappers::SparseMatrix  &matrix);
  } // namespace Elasticity
} // namespace Tribody

#endif
