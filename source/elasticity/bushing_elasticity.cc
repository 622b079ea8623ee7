// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/function.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include <Eigen/LU>

#include <tribody/algebra/cholesky_factor.h>
#include <tribody/algebra/linear_solver.h>
#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/stiffness.h>
#include <tribody/elasticity/surface_compliance.h>
#include <tribody/surface/boundary_ids.h>

#include <algorithm>
#include <vector>

namespace Tribody
{
  namespace Elasticity
  {
    namespace
    {
      /// @p stiffness with the displacement along the given direction and
      /// across it in the places of x and y of each node.
      Eigen::SparseMatrix<double>
      turn_to_normals(const dealii::TrilinosWrappers::SparseMatrix &stiffness,
                      const std::vector<int>                       &x_dofs,
                      const std::vector<int>                       &y_dofs,
                      const Eigen::Matrix2Xd                       &normals)
      {
        std::vector<Eigen::Triplet<double>> entries;
        std::vector<bool>                   turned(stiffness.m(), false);
        for (Eigen::Index i = 0; i < normals.cols(); ++i)
          {
            const int x = x_dofs[i], y = y_dofs[i];
            entries.emplace_back(x, x, normals(0, i));
            entries.emplace_back(y, x, normals(1, i));
            entries.emplace_back(x, y, -normals(1, i));
            entries.emplace_back(y, y, normals(0, i));
            turned[x] = turned[y] = true;
          }
        for (unsigned int i = 0; i < turned.size(); ++i)
          if (!turned[i])
            entries.emplace_back(i, i, 1.);
        Eigen::SparseMatrix<double> turn(stiffness.m(), stiffness.m());
        turn.setFromTriplets(entries.begin(), entries.end());

        const Eigen::SparseMatrix<double> turned_columns =
          to_eigen(stiffness) * turn;
        return turn.transpose() * turned_columns;
      }
    } // namespace



    BushingElasticity::BushingElasticity(
      const dealii::Triangulation<2, 2> &triangulation,
      const unsigned int                 degree,
      const Material                    &material,
      const PlaneState                   plane_state,
      const RimSupport                  &support)
      : material(material)
      , plane_state(plane_state)
      , law(material, plane_state)
      , support(support)
      , fe(dealii::FE_Q<2>(degree), 2)
      , dof_handler(triangulation)
    {
      dof_handler.distribute_dofs(fe);
      nodes = make_bore_nodes(dof_handler);
      if (support.is_housing())
        {
          rim       = make_bore_nodes(dof_handler, BoundaryIds::rim);
          rim_curve = make_bore_surface(rim.positions, degree);
        }

      constraints.reinit(relevant_dofs(dof_handler));
      dealii::DoFTools::make_hanging_node_constraints(dof_handler, constraints);
      if (support.is_clamped())
        dealii::DoFTools::make_zero_boundary_constraints(dof_handler,
                                                         BoundaryIds::rim,
                                                         constraints);
      constraints.close();
      reinit_matrix(dof_handler,
                    constraints,
                    /*keep_constrained_dofs = */ false,
                    stiffness);
    }



    BushingElasticity::~BushingElasticity() = default;



    void
    BushingElasticity::reinit(const dealii::Mapping<2, 2> &mapping)
    {
      solver.reset();
      assemble_stiffness(mapping, dof_handler, constraints, law, stiffness);
      if (support.is_housing())
        assemble_keys(rim, law.mu, stiffness);
      else if (!support.is_clamped())
        assemble_foundation(
          mapping, dof_handler, constraints, support, stiffness);
      is_assembled = true;
    }



    void
    BushingElasticity::scale_modulus(const double factor)
    {
      Material scaled = material;
      scaled.youngs_modulus *= factor;
      law = PlaneHooke(scaled, plane_state);
    }



    const LinearSolver &
    BushingElasticity::linear_solver() const
    {
      Assert(is_assembled, dealii::ExcNotInitialized());
      if (solver == nullptr)
        solver =
          make_linear_solver(stiffness, dof_handler, SlowModes::rigid_motions);
      return *solver;
    }



    bool
    BushingElasticity::owns(const Eigen::Index node) const
    {
      return dof_handler.locally_owned_dofs().is_element(nodes.x_dofs[node]);
    }



    Eigen::Index
    BushingElasticity::local(const dealii::types::global_dof_index dof) const
    {
      return dof_handler.locally_owned_dofs().index_within_set(dof);
    }



    Eigen::MatrixXd
    BushingElasticity::normal_compliance(const Eigen::Matrix2Xd &normals,
                                         const RingSymmetry      symmetry,
                                         const MPI_Comm &communicator) const
    {
      // More would save little: what multigrid does, it does column by column.
      constexpr Eigen::Index columns_at_once = 32;

      Assert(is_assembled, dealii::ExcNotInitialized());
      const Eigen::Index n = nodes.n_nodes();
      AssertDimension(normals.cols(), n);
      if (symmetry == RingSymmetry::cells_alike)
        return symmetric_part(repeat_around(
                                compliance_columns(normals, {0, nodes.degree})),
                              "bushing");

      if (is_distributed(dof_handler.get_triangulation()))
        {
          Eigen::MatrixXd compliance(n, n);
          for (Eigen::Index j = 0; j < n; j += columns_at_once)
            {
              const Ranks::Range range{j, std::min(j + columns_at_once, n)};
              compliance.middleCols(j, range.end - j) =
                compliance_columns(normals, range);
            }
          return symmetric_part(compliance, "bushing");
        }

      // The normal displacement of a bore node takes the place of x. Hanging
      // nodes are never bore nodes.
      const std::vector<int> x_dofs(nodes.x_dofs.begin(), nodes.x_dofs.end());
      const std::vector<int> y_dofs(nodes.y_dofs.begin(), nodes.y_dofs.end());
      const CholeskyFactor   factor(
        turn_to_normals(stiffness, x_dofs, y_dofs, normals), x_dofs);
      return factor.compute_inverse_block(communicator);
    }



    Eigen::MatrixXd
    BushingElasticity::bore_and_rim_compliance(
      const Eigen::Matrix2Xd &bore_normals,
      const MPI_Comm         &communicator) const
    {
      Assert(is_assembled, dealii::ExcNotInitialized());
      AssertDimension(bore_normals.cols(), nodes.n_nodes());
      std::vector<int> x_dofs(nodes.x_dofs.begin(), nodes.x_dofs.end());
      std::vector<int> y_dofs(nodes.y_dofs.begin(), nodes.y_dofs.end());
      x_dofs.insert(x_dofs.end(), rim.x_dofs.begin(), rim.x_dofs.end());
      y_dofs.insert(y_dofs.end(), rim.y_dofs.begin(), rim.y_dofs.end());
      Eigen::Matrix2Xd directions(2, x_dofs.size());
      directions << bore_normals, -rim_curve.normals;
      const CholeskyFactor factor(
        turn_to_normals(stiffness, x_dofs, y_dofs, directions), x_dofs);
      Eigen::MatrixXd compliance = factor.compute_inverse_block(communicator);

      // (I - T Z^T) C (I - Z T^T) + little T T^T / mu, T being the
      // displacements of a rigid body and Z what finds it from the rim's
      // displacements.
      constexpr double       little = 1e-3;
      const Eigen::MatrixX2d T      = directions.transpose();
      const Eigen::MatrixX2d V =
        -compliance.rightCols(rim.n_nodes()) * rim_averages();
      const Eigen::Matrix2d K =
        -rim_averages().transpose() * V.bottomRows(rim.n_nodes());
      const Eigen::MatrixX2d W =
        V - 0.5 * T * (K + Eigen::Matrix2d::Identity() * (little / law.mu));
      compliance -= T * W.transpose() + W * T.transpose();
      return compliance;
    }



    Eigen::MatrixX2d
    BushingElasticity::rim_averages() const
    {
      const Eigen::MatrixX2d weighted =
        rim_curve.weights.asDiagonal() * rim_curve.normals.transpose();
      return weighted * (rim_curve.normals * weighted).inverse();
    }



    Eigen::MatrixXd
    BushingElasticity::compliance_columns(const Eigen::Matrix2Xd &normals,
                                          const Ranks::Range      range) const
    {
      const Eigen::Index n_columns = range.end - range.begin;
      Eigen::MatrixXd    forces =
        Eigen::MatrixXd::Zero(dof_handler.n_locally_owned_dofs(), n_columns);
      for (Eigen::Index j = range.begin; j < range.end; ++j)
        if (owns(j))
          {
            forces(local(nodes.x_dofs[j]), j - range.begin) = normals(0, j);
            forces(local(nodes.y_dofs[j]), j - range.begin) = normals(1, j);
          }
      const Eigen::MatrixXd displacements = linear_solver().solve(forces);
      Eigen::MatrixXd       columns =
        Eigen::MatrixXd::Zero(nodes.n_nodes(), n_columns);
      for (Eigen::Index i = 0; i < nodes.n_nodes(); ++i)
        if (owns(i))
          columns.row(i) =
            normals(0, i) * displacements.row(local(nodes.x_dofs[i])) +
            normals(1, i) * displacements.row(local(nodes.y_dofs[i]));
      Ranks::sum(columns, dof_handler.get_communicator());
      return columns;
    }



    Eigen::Vector2d
    BushingElasticity::mean_rim_displacement(
      const MeshVector &displacement) const
    {
      Eigen::VectorXd along_normals(rim.n_nodes());
      for (Eigen::Index k = 0; k < rim.n_nodes(); ++k)
        along_normals[k] =
          rim_curve.normals(0, k) * displacement[rim.x_dofs[k]] +
          rim_curve.normals(1, k) * displacement[rim.y_dofs[k]];
      return rim_averages().transpose() * along_normals;
    }



    Eigen::VectorXd
    BushingElasticity::thermal_displacement(
      const dealii::Mapping<2, 2>    &mapping,
      const Eigen::Matrix2Xd         &normals,
      const dealii::DoFHandler<2, 2> &temperatures,
      const dealii::Vector<double>   &rise,
      const double                    expansion) const
    {
      const dealii::Vector<double> forces = compute_thermal_forces(
        mapping, dof_handler, constraints, law, temperatures, rise, expansion);
      const Eigen::VectorXd displacement = linear_solver().solve(
        Eigen::Map<const Eigen::VectorXd>(forces.begin(), forces.size()));
      Eigen::VectorXd along_normals(nodes.n_nodes());
      for (Eigen::Index i = 0; i < nodes.n_nodes(); ++i)
        along_normals[i] = normals(0, i) * displacement[nodes.x_dofs[i]] +
                           normals(1, i) * displacement[nodes.y_dofs[i]];
      return along_normals;
    }



    void
    BushingElasticity::move_rigidly(MeshVector            &displacement,
                                    const Eigen::Vector2d &step) const
    {
      MeshVector translation = make_mesh_vector(dof_handler);
      dealii::VectorTools::interpolate(dof_handler,
                                       dealii::Functions::ConstantFunction<2>(
                                         std::vector<double>{step[0], step[1]}),
                                       translation);
      displacement += translation;
    }



    MeshVector
    BushingElasticity::solve(const Eigen::Matrix2Xd &nodal_forces,
                             const Eigen::Matrix2Xd &rim_forces) const
    {
      AssertDimension(nodal_forces.cols(), nodes.n_nodes());
      Eigen::VectorXd forces =
        Eigen::VectorXd::Zero(dof_handler.n_locally_owned_dofs());
      for (Eigen::Index i = 0; i < nodes.n_nodes(); ++i)
        if (owns(i))
          {
            forces[local(nodes.x_dofs[i])] = nodal_forces(0, i);
            forces[local(nodes.y_dofs[i])] = nodal_forces(1, i);
          }
      for (Eigen::Index k = 0; k < rim_forces.cols(); ++k)
        {
          forces[local(rim.x_dofs[k])] = rim_forces(0, k);
          forces[local(rim.y_dofs[k])] = rim_forces(1, k);
        }
      const Eigen::VectorXd solution     = linear_solver().solve(forces);
      MeshVector            displacement = make_mesh_vector(dof_handler);
      std::copy(solution.begin(), solution.end(), displacement.begin());
      constraints.distribute(displacement);
      if (support.is_housing())
        move_rigidly(displacement, -mean_rim_displacement(displacement));
      displacement.update_ghost_values();
      return displacement;
    }
  } // namespace Elasticity
} // namespace Tribody
