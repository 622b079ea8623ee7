// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_elasticity_bushing_elasticity_h
#define tribody_elasticity_bushing_elasticity_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Eigen/Core>

#include <tribody/algebra/mesh_algebra.h>
#include <tribody/base/ranks.h>
#include <tribody/elasticity/plane_state.h>
#include <tribody/elasticity/rim_support.h>
#include <tribody/elasticity/surface_compliance.h>
#include <tribody/surface/bore_nodes.h>
#include <tribody/surface/bore_surface.h>

#include <memory>

namespace dealii
{
  template <int dim, int spacedim>
  class Mapping;
} // namespace dealii

namespace Tribody
{
  class LinearSolver;

  namespace Elasticity
  {
    /**
     * The linear elasticity of one bushing, held at its rim by a RimSupport and
     * loaded by nodal forces in its bore,
     * @f[ \int_\Omega \sigma(u) : \varepsilon(v)\,dx
     *     + \int_{rim} v \cdot (k_n\,n n^T + k_t\,t t^T)\,u\,ds
     *     = \sum_i f_i \cdot v(x_i) \quad \forall v, @f]
     * or with u = 0 at a clamped rim, or free but for keys and nodal forces at
     * the rim if it lies in a housing, per length along the axis. The domain is
     * the image of the mesh under a mapping, so that a worn bushing needs no
     * other mesh. Displacements are small.
     *
     * Use: construct once per mesh, reinit() per geometry, then
     * normal_compliance() for the contact and solve() for output. The stiffness
     * is assembled once per geometry and factorised for what is asked for. For
     * 180 by 6 quadratic cells all this takes 0.1 s.
     *
     * If the mesh is distributed, its ranks share cells and equations, which
     * are then solved by MultigridSolver; all of them must call every function
     * together. The bore nodes and the compliance are known to all of them.
     */
    class BushingElasticity
    {
    public:
      /// @param degree of the elements, 1 to 3.
      BushingElasticity(const dealii::Triangulation<2, 2> &triangulation,
                        const unsigned int                 degree,
                        const Material                    &material,
                        const PlaneState                   plane_state,
                        const RimSupport                  &support = {});

      ~BushingElasticity();

      /// Assemble the stiffness on the image of the mesh under @p mapping.
      void
      reinit(const dealii::Mapping<2, 2> &mapping);

      /// Let Young's modulus be @p factor times that of the material, from the
      /// next reinit() on.
      void
      scale_modulus(const double factor);

      /**
       * The displacement of every bore node along its normal under a unit
       * force along the normal of another one: @f$ C_{ij} = n_i \cdot u_j(x_i)
       * @f$ [m per N/m], symmetric and positive definite, what the contact
       * needs to know about the bushing.
       *
       * @param normals unit vectors, one column for each bore node.
       * @param symmetry of mesh and geometry; with cells that are all alike,
       *   one column per node of a cell is solved for. Without, all columns are
       *   the inverse of what a Cholesky factor leaves of the stiffness at the
       *   bore, see CholeskyFactor; or solved for if the mesh is
       *   distributed, to MultigridSolver::tolerance.
       * @param communicator of ranks that hold the same bushing, on a serial
       *   mesh, and share the columns. All of them get the result, which does
       *   not depend on their number.
       * @throws ExcRun if the stiffness is singular.
       */
      Eigen::MatrixXd
      normal_compliance(const Eigen::Matrix2Xd &normals,
                        const RingSymmetry      symmetry = RingSymmetry::none,
                        const MPI_Comm &communicator     = MPI_COMM_SELF) const;

      /**
       * The same of a ring in a housing at all nodes where it can be touched:
       * those of the bore, whose forces and displacements are counted along the
       * normals, followed by those of the rim, where they are counted against
       * the normals. Displacements are seen from the circle that fits the
       * deformed rim best,
       * @f[ \sum_k w_k \nu_k\,(\nu_k \cdot u_k) = 0 @f]
       * over its nodes with weights w and normals @f$\nu@f$. What forces lack
       * to equilibrium is distributed over the rim like @f$ w_k \nu_k @f$, and
       * displaces the ring besides by a thousandth of its sum over the shear
       * modulus, so that the matrix is positive definite.
       */
      Eigen::MatrixXd
      bore_and_rim_compliance(const Eigen::Matrix2Xd &bore_normals,
                              const MPI_Comm         &communicator) const;

      /// Displacement [m] under forces at the nodes of bore and rim [N/m], one
      /// column each. @param rim_forces of a ring in a housing, or nothing; the
      /// displacement is then seen as in bore_and_rim_compliance().
      MeshVector
      solve(const Eigen::Matrix2Xd &nodal_forces,
            const Eigen::Matrix2Xd &rim_forces = {}) const;

      /**
       * The displacement of every bore node along its normal if the bushing
       * gets warmer, as the rim lets it [m].
       * @param mapping that of the last reinit(), or one as near to it as the
       *   stiffness may lag.
       * @param temperatures on the same mesh, which is serial.
       * @param rise over the temperature at which the bushing has its shape,
       *   over these degrees of freedom [K].
       * @param expansion alpha [1/K].
       */
      Eigen::VectorXd
      thermal_displacement(const dealii::Mapping<2, 2>    &mapping,
                           const Eigen::Matrix2Xd         &normals,
                           const dealii::DoFHandler<2, 2> &temperatures,
                           const dealii::Vector<double>   &rise,
                           const double                    expansion) const;

      /// Add a displacement of the whole bushing by @p step [m].
      void
      move_rigidly(MeshVector &displacement, const Eigen::Vector2d &step) const;

      /// Of the displacements; follows no geometry, since that is in the
      /// mapping.
      const dealii::DoFHandler<2, 2> &
      get_dof_handler() const
      {
        return dof_handler;
      }

      /// The nodes that the pin may touch, as manufactured.
      const BoreNodes &
      bore_nodes() const
      {
        return nodes;
      }

      /// Where the housing may touch the ring; none without a housing.
      const BoreNodes &
      rim_nodes() const
      {
        return rim;
      }

      /// The curve through the rim_nodes(); its normals point out of the ring.
      const BoreSurface &
      rim_surface() const
      {
        return rim_curve;
      }

      /// The stiffness [Pa], with the rows and columns of a clamped rim
      /// replaced by diagonal entries.
      const dealii::TrilinosWrappers::SparseMatrix &
      system_matrix() const
      {
        return stiffness;
      }

      /// The law of the material in the plane.
      const PlaneHooke &
      hooke() const
      {
        return law;
      }

    private:
      /// For single right-hand sides, made ready when first needed.
      const LinearSolver &
      linear_solver() const;

      Eigen::Vector2d
      mean_rim_displacement(const MeshVector &displacement) const;

      /// @f$ w_k \nu_k @f$, one row each, so that the sum with @f$\nu_k@f$ is
      /// the unit matrix.
      Eigen::MatrixX2d
      rim_averages() const;

      /// Of the compliance, those in @p range.
      Eigen::MatrixXd
      compliance_columns(const Eigen::Matrix2Xd &normals,
                         const Ranks::Range      range) const;

      /// Whether this rank owns the degrees of freedom of a bore node.
      bool
      owns(const Eigen::Index node) const;

      /// Where a rank keeps a degree of freedom among those it owns.
      Eigen::Index
      local(const dealii::types::global_dof_index dof) const;

      Material                               material;
      PlaneState                             plane_state;
      PlaneHooke                             law;
      RimSupport                             support;
      dealii::FESystem<2>                    fe;
      dealii::DoFHandler<2, 2>               dof_handler;
      dealii::AffineConstraints<double>      constraints;
      BoreNodes                              nodes;
      BoreNodes                              rim;
      BoreSurface                            rim_curve;
      dealii::TrilinosWrappers::SparseMatrix stiffness;
      bool                                   is_assembled = false;
      mutable std::unique_ptr<LinearSolver>  solver;
    };
  } // namespace Elasticity
} // namespace Tribody

#endif
