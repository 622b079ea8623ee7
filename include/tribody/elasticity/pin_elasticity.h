// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_elasticity_pin_elasticity_h
#define tribody_elasticity_pin_elasticity_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Eigen/Core>

#include <tribody/elasticity/plane_state.h>
#include <tribody/elasticity/surface_compliance.h>
#include <tribody/surface/bore_nodes.h>

#include <array>
#include <memory>

namespace dealii
{
  template <int dim, int spacedim>
  class Mapping;
}

namespace Tribody
{
  class DirectSolver;

  namespace Elasticity
  {
    /**
     * The linear elasticity of a pin, loaded by nodal forces on its surface.
     * Its body holds it by a force that is spread evenly over the cross section
     * A, and what it moves as a whole is not counted: the pin's centre e of the
     * contact problem is the mean place of its cross section. With the rigid
     * fields r (two translations, one rotation),
     * @f[ \int_A \sigma(u) : \varepsilon(v)\,dx
     *     = \sum_i f_i \cdot v(x_i) - \sum_r \mu_r \int_A r \cdot v\,dx, \qquad
     *     \int_A r \cdot u\,dx = 0 \quad \forall r, @f]
     * @f$\mu_r@f$ balancing the forces. How the body holds the pin concerns e
     * only, as long as it does so evenly around: what is not the n = 1 harmonic
     * of the normal displacement is independent of it.
     *
     * Its surface has BoundaryIds::pin_surface, all other boundaries are free.
     */
    class PinElasticity
    {
    public:
      /// @param degree of the elements, 1 to 3.
      PinElasticity(const dealii::Triangulation<2, 2> &triangulation,
                    const unsigned int                 degree,
                    const Material                    &material,
                    const PlaneState                   plane_state);

      ~PinElasticity();

      /// Assemble the stiffness on the image of the mesh under @p mapping and
      /// factorise it.
      void
      reinit(const dealii::Mapping<2, 2> &mapping);

      /**
       * As BushingElasticity::normal_compliance(): how far each surface node
       * is pressed in along its normal by a unit force on another one [m per
       * N/m]. Symmetric and positive semi-definite: forces that press like a
       * cosine hardly do more than move the pin.
       *
       * @param normals unit vectors, outward or inward, one for each node; the
       *   radii for Tribody::make_turned_interpolation().
       */
      Eigen::MatrixXd
      normal_compliance(const Eigen::Matrix2Xd &normals,
                        const RingSymmetry symmetry = RingSymmetry::none) const;

      /// The nodes on the pin's surface, in the pin's own frame.
      const BoreNodes &
      surface_nodes() const
      {
        return nodes;
      }

    private:
      void
      integrate_rigid_fields(const dealii::Mapping<2, 2> &mapping);

      PlaneHooke                        law;
      dealii::FESystem<2>               fe;
      dealii::DoFHandler<2, 2>          dof_handler;
      dealii::AffineConstraints<double> constraints;
      BoreNodes                         nodes;
      /// Zero in the solution before the motion as a whole is taken out.
      std::array<dealii::types::global_dof_index, 3> held_dofs;
      dealii::TrilinosWrappers::SparseMatrix         stiffness;
      std::unique_ptr<DirectSolver>                  solver;

      /// The three rigid fields r at the degrees of freedom, and their
      /// integrals against each basis function.
      Eigen::MatrixX3d rigid_fields;
      Eigen::MatrixX3d rigid_integrals;
    };
  } // namespace Elasticity
} // namespace Tribody

#endif
