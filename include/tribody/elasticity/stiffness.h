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
  template <typename Number>
  class Vector;

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

    /**
     * The forces of a thermal strain @f$\alpha\vartheta I@f$ that is held
     * back (Duhamel and Neumann),
     * @f[ f_i = \int 2(\lambda+\mu)(1 + a)\,\alpha\,\vartheta\,
     *           \nabla\cdot\varphi_i\,dx @f]
     * with the axial ratio a of PlaneHooke: the axial strain is held back, too,
     * in plane strain. In each cell the temperature counts with its projection
     * on the polynomials of one degree less, so that an incompressible
     * material can follow it.
     *
     * @param dof_handler of the displacement, on a serial mesh.
     * @param constraints as in assemble_stiffness(); they are homogeneous.
     * @param temperatures of a scalar element on the same mesh.
     * @param rise over the stress-free temperature, @f$\vartheta@f$ [K].
     * @param expansion alpha [1/K].
     * @return f [N/m], zero where the displacement is constrained.
     */
    dealii::Vector<double>
    compute_thermal_forces(const dealii::Mapping<2, 2>             &mapping,
                           const dealii::DoFHandler<2, 2>          &dof_handler,
                           const dealii::AffineConstraints<double> &constraints,
                           const PlaneHooke                        &law,
                           const dealii::DoFHandler<2, 2> &temperatures,
                           const dealii::Vector<double>   &rise,
                           const double                    expansion);
  } // namespace Elasticity
} // namespace Tribody

#endif
