// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <support/uncondensed_contact.h>

#include <tribody/algebra/direct_solver.h>
#include <tribody/contact/pin_gap.h>
#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/surface/bore_surface.h>

#include <algorithm>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      using Contact::PinGap;
      using dealii::types::global_dof_index;

      /**
       * The bordered system: first all displacements, then the two components
       * of the pin's step, then the forces of all bore nodes.
       */
      class BorderedSystem
      {
      public:
        BorderedSystem(const Elasticity::BushingElasticity &elasticity,
                       const BoreSurface                   &surface)
          : stiffness(elasticity.system_matrix())
          , nodes(elasticity.bore_nodes())
          , normals(surface.normals)
          , n_dofs(stiffness.m())
        {
          const global_dof_index n = n_dofs + 2 + nodes.n_nodes();

          dealii::DynamicSparsityPattern sparsity(n, n);
          for (const auto &entry : stiffness)
            sparsity.add(entry.row(), entry.column());
          for (unsigned int c = 0; c < 2; ++c)
            for (unsigned int d = 0; d < 2; ++d)
              sparsity.add(n_dofs + c, n_dofs + d);
          for (Eigen::Index i = 0; i < nodes.n_nodes(); ++i)
            {
              sparsity.add(force_index(i), force_index(i));
              for (unsigned int c = 0; c < 2; ++c)
                for (const auto other : {dof(i, c), n_dofs + c})
                  {
                    sparsity.add(force_index(i), other);
                    sparsity.add(other, force_index(i));
                  }
            }
          matrix.reinit(dealii::complete_index_set(n), sparsity, MPI_COMM_SELF);
        }

        /// Solve one linearisation about @p pin and the nodal @p forces.
        dealii::Vector<double>
        solve(const PinGap            &pin,
              const Eigen::VectorXd   &forces,
              const std::vector<bool> &active,
              const Eigen::Vector2d   &force_per_length)
        {
          matrix = 0.;
          for (const auto &entry : stiffness)
            matrix.add(entry.row(), entry.column(), entry.value());
          dealii::Vector<double> right_hand_side(matrix.m());
          for (unsigned int c = 0; c < 2; ++c)
            right_hand_side[n_dofs + c] = force_per_length[c];

          for (Eigen::Index i = 0; i < nodes.n_nodes(); ++i)
            {
              const Eigen::Vector2d m = pin.directions.col(i);
              const Eigen::Matrix2d second_derivative =
                -forces[i] / pin.distances[i] *
                (Eigen::Matrix2d::Identity() - m * m.transpose());
              for (unsigned int c = 0; c < 2; ++c)
                {
                  matrix.add(dof(i, c), force_index(i), -normals(c, i));
                  matrix.add(n_dofs + c, force_index(i), m[c]);
                  for (unsigned int d = 0; d < 2; ++d)
                    matrix.add(n_dofs + c, n_dofs + d, second_derivative(c, d));
                  if (active[i])
                    {
                      matrix.add(force_index(i), dof(i, c), normals(c, i));
                      matrix.add(force_index(i), n_dofs + c, -m[c]);
                    }
                }
              if (active[i])
                right_hand_side[force_index(i)] = -pin.gap[i];
              else
                matrix.add(force_index(i), force_index(i), 1.);
            }
          matrix.compress(dealii::VectorOperation::add);
          return DirectSolver(matrix).solve(right_hand_side);
        }

        Eigen::Vector2d
        pin_step(const dealii::Vector<double> &solution) const
        {
          return {solution[n_dofs], solution[n_dofs + 1]};
        }

        Eigen::VectorXd
        nodal_forces(const dealii::Vector<double> &solution) const
        {
          return Eigen::Map<const Eigen::VectorXd>(solution.begin() + n_dofs +
                                                     2,
                                                   nodes.n_nodes());
        }

        Eigen::VectorXd
        normal_displacements(const dealii::Vector<double> &solution) const
        {
          Eigen::VectorXd displacements(nodes.n_nodes());
          for (Eigen::Index i = 0; i < nodes.n_nodes(); ++i)
            displacements[i] = normals(0, i) * solution[dof(i, 0)] +
                               normals(1, i) * solution[dof(i, 1)];
          return displacements;
        }

      private:
        global_dof_index
        dof(const Eigen::Index node, const unsigned int component) const
        {
          return component == 0 ? nodes.x_dofs[node] : nodes.y_dofs[node];
        }

        global_dof_index
        force_index(const Eigen::Index node) const
        {
          return n_dofs + 2 + node;
        }

        const dealii::TrilinosWrappers::SparseMatrix &stiffness;
        const BoreNodes                              &nodes;
        const Eigen::Matrix2Xd                       &normals;
        const global_dof_index                        n_dofs;
        dealii::TrilinosWrappers::SparseMatrix        matrix;
      };

      /// Releases what pulls, catches what is penetrated; true if the set
      /// changed.
      bool
      update_active_set(const Contact::ContactSolution &solution,
                        std::vector<bool>              &active)
      {
        const double tolerance = 1e-12 * solution.gap.cwiseAbs().maxCoeff();
        bool         changed   = false;
        for (std::size_t i = 0; i < active.size(); ++i)
          {
            const bool next = active[i] ? solution.nodal_force[i] > 0.
                                        : solution.gap[i] < -tolerance;
            changed         = changed || (next != active[i]);
            active[i]       = next;
          }
        return changed;
      }
    } // namespace



    Contact::ContactSolution
    solve_uncondensed_contact(const Elasticity::BushingElasticity &elasticity,
                              const BoreSurface                   &surface,
                              const double                         pin_radius,
                              const Eigen::Vector2d &force_per_length)
    {
      // The contact may shrink by as little as a node at each end per
      // iteration.
      const unsigned int max_iterations = 50 + surface.n_nodes() / 2;
      // What the condition of the whole stiffness leaves of a step.
      constexpr double   tolerance = 1e-10;
      const Eigen::Index n         = surface.n_nodes();

      BorderedSystem           system(elasticity, surface);
      Contact::ContactSolution result;
      result.nodal_force = Eigen::VectorXd::Zero(n);
      std::vector<bool> active(n);
      for (Eigen::Index i = 0; i < n; ++i)
        active[i] = surface.normals.col(i).dot(force_per_length) >=
                    0.5 * force_per_length.norm();

      PinGap pin(surface.positions, result.pin_centre, pin_radius);
      while (!result.report.converged &&
             result.report.n_iterations < max_iterations)
        {
          ++result.report.n_iterations;
          const auto solution =
            system.solve(pin, result.nodal_force, active, force_per_length);
          const Eigen::Vector2d step = system.pin_step(solution);
          result.pin_centre += step;
          result.nodal_force = system.nodal_forces(solution);
          pin        = PinGap(surface.positions, result.pin_centre, pin_radius);
          result.gap = pin.gap + system.normal_displacements(solution);
          result.report.residual  = step.norm() / result.pin_centre.norm();
          result.report.converged = !update_active_set(result, active) &&
                                    result.report.residual < tolerance;
        }
      if (!result.report.converged)
        result.report.message = "no convergence";

      for (Eigen::Index i = 0; i < n; ++i)
        if (active[i])
          result.active_set.push_back(i);
      result.pressure   = result.nodal_force.cwiseQuotient(surface.weights);
      result.force      = pin.directions * result.nodal_force;
      result.half_angle = Contact::contact_half_angle(result, surface);
      return result;
    }
  } // namespace Coupling
} // namespace Tribody
