// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_geometry_worn_configuration_h
#define tribody_geometry_worn_configuration_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q_eulerian.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Eigen/Core>

#include <tribody/algebra/mesh_algebra.h>
#include <tribody/surface/bore_nodes.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace Tribody
{
  class LinearSolver;

  namespace Geometry
  {
    /**
     * The shape of a worn bushing: the as-manufactured mesh, moved by a
     * displacement w that removes the wear depth h from the bore,
     * @f[ \nabla\cdot(K \nabla w) = 0, \qquad K = e_r e_r^T / r, \qquad
     *     w(x_i) = h_i\,x_i/|x_i| \text{ in the bore}, \qquad
     *     w = 0 \text{ at the rim}, @f]
     * and offered as a mapping of the mesh. Diffusion along rays alone makes w
     * linear in r on each of them: for a rim at the radius b, the wall of
     * thickness t = b - a is compressed evenly to t - h. Cells stay as they
     * should up to the whole wall, however narrow the worn arc; a harmonic w
     * turns them inside out where h varies over less than the wall
     * (doc/decisions.md, "The mesh of a worn bushing"). w is always rebuilt
     * from the total depth, so nothing drifts. This displacement has nothing to
     * do with the elastic one.
     *
     * MappingQEulerian moves straight-sided cells. To keep bore and rim round,
     * its vector holds the curvature as well as the wear: it is the position
     * on the manifold, minus that in the straight-sided cell, plus w. It also
     * keeps pointers to vector and DoFHandler, which therefore live here,
     * in one object that is neither copied nor moved.
     *
     * If the mesh is distributed, all of its ranks must call every function
     * together, but for removed_area(); the bore nodes are known to all.
     */
    class WornConfiguration
    {
    public:
      /**
       * No wear yet.
       * @param degree of the mapping, 1 to 3; that of the elements used on it.
       * @param bushing_name for messages.
       */
      WornConfiguration(const dealii::Triangulation<2, 2> &triangulation,
                        const unsigned int                 degree,
                        const std::string                 &bushing_name);

      ~WornConfiguration();

      WornConfiguration(const WornConfiguration &) = delete;
      WornConfiguration &
      operator=(const WornConfiguration &) = delete;

      /**
       * Take the shape that belongs to the total wear depth [m] at the bore
       * nodes, counted radially.
       *
       * @throws ExcInvertedMesh if a cell would be turned inside out at one of
       * its quadrature points or nodes; the shape is then what it was before.
       */
      void
      update(const Eigen::VectorXd &wear_depth);

      /// Onto the worn bushing. Valid as long as this object; follows update().
      const dealii::Mapping<2, 2> &
      mapping() const
      {
        return *worn_mapping;
      }

      /// The bore nodes as manufactured.
      const BoreNodes &
      bore_nodes() const
      {
        return nodes;
      }

      /// Positions of the bore nodes on the worn mapping [m], one column each.
      Eigen::Matrix2Xd
      worn_positions() const;

      /// Area that wear has removed [m^2], added up cell by cell: the
      /// difference of two areas would drown little wear in rounding.
      double
      removed_area() const
      {
        return lost_area;
      }

      /// Area of the worn ring [m^2], by quadrature over its cells.
      double
      area() const;

      /// How much of its size the mesh keeps where it is compressed most: the
      /// smallest ratio [-] of the mapping's Jacobian to that of the
      /// straight-sided cell, at quadrature points and nodes; 1 - h/t.
      double
      min_jacobian_ratio() const
      {
        return smallest_ratio(mesh_displacement).value;
      }

      /// The displacement w [m] by wear alone, for output.
      const MeshVector &
      wear_displacement() const
      {
        return wear;
      }

      /// Of mesh and wear displacement.
      const dealii::DoFHandler<2, 2> &
      get_dof_handler() const
      {
        return dof_handler;
      }

    private:
      struct JacobianRatio
      {
        double           value = std::numeric_limits<double>::max();
        dealii::Point<2> cell_centre;
      };

      /// In the cells of this rank, and in those of all ranks.
      JacobianRatio
      smallest_own_ratio(const MeshVector &displacement) const;

      JacobianRatio
      smallest_ratio(const MeshVector &displacement) const;

      /// Area that each quadrature point in the cells of this rank stands for
      /// [m^2].
      std::vector<double>
      area_elements() const;

      double
      compute_removed_area() const;

      void
      setup_extension();

      MeshVector
      compute_extension(const Eigen::VectorXd &wear_depth) const;

      void
      check_cells(const MeshVector &displacement,
                  const double      max_wear_depth) const;

      std::string                            name;
      dealii::FESystem<2>                    fe;
      dealii::DoFHandler<2, 2>               dof_handler;
      dealii::AffineConstraints<double>      hanging_nodes;
      dealii::AffineConstraints<double>      fixed_boundary;
      BoreNodes                              nodes;
      dealii::TrilinosWrappers::SparseMatrix extension;
      dealii::TrilinosWrappers::SparseMatrix constrained_extension;
      std::unique_ptr<LinearSolver>          solver;

      /// Manifold minus straight-sided cells.
      MeshVector curvature;
      MeshVector wear;
      /// What the mapping adds to the straight-sided cells: curvature + wear.
      MeshVector mesh_displacement;
      std::unique_ptr<dealii::MappingQEulerian<2, MeshVector>> worn_mapping;
      std::vector<double> unworn_area_elements;
      double              lost_area = 0.;
    };
  } // namespace Geometry
} // namespace Tribody

#endif
