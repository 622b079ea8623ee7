// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/QR>

#include <tribody/base/solver_report.h>
#include <tribody/multibody/assembly/redundancy.h>
#include <tribody/multibody/system/constraint_gaps.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // An equation of a joint.
      struct JointEquation
      {
        unsigned int joint;
        unsigned int number;
        unsigned int row;
      };



      // The constraints in the order in which they are kept: joints, those with
      // a gap after the others, then what is no ideal joint.
      std::vector<unsigned int>
      order_of_keeping(const Mechanism           &mechanism,
                       const MechanismParameters &simulated)
      {
        std::vector<int> ranks(mechanism.constraints().size(), 2);
        for (unsigned int j = 0; j < mechanism.joints().size(); ++j)
          if (!mechanism.joints()[j].has_gap())
            ranks[mechanism.joints()[j].index] =
              simulated.joints[j].has_gap() ? 1 : 0;
        std::vector<unsigned int> order(ranks.size());
        for (unsigned int c = 0; c < order.size(); ++c)
          order[c] = c;
        std::stable_sort(order.begin(),
                         order.end(),
                         [&](const unsigned int a, const unsigned int b) {
                           return ranks[a] < ranks[b];
                         });
        return order;
      }



      // The rows of Phi_q at q that depend on those kept before them.
      std::vector<unsigned int>
      find_dependent_rows(const EquationsOfMotion   &equations,
                          const MechanismParameters &simulated,
                          const Eigen::VectorXd     &q)
      {
        const Mechanism      &mechanism = equations.mechanism();
        const Eigen::MatrixXd jacobian  = compute_scaled_jacobian(equations, q);
        std::vector<unsigned int>                   dependent;
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(
          jacobian.transpose());
        decomposition.setThreshold(1e-3 * singular_threshold);
        if (decomposition.rank() + mechanism.n_left_out() == jacobian.rows())
          return dependent;
        // Orthonormal columns that span the rows kept so far.
        Eigen::MatrixXd basis  = Eigen::MatrixXd::Zero(q.size(), q.size());
        Eigen::Index    n_kept = 0;
        for (const unsigned int c : order_of_keeping(mechanism, simulated))
          {
            const auto &[constraint, first_row] = mechanism.constraints()[c];
            for (unsigned int i = 0; i < constraint->n_equations; ++i)
              {
                if (constraint->is_left_out(i))
                  continue;
                Eigen::VectorXd row =
                  jacobian.row(first_row + i).transpose().stableNormalized();
                const auto kept = basis.leftCols(n_kept);
                row -= kept * (kept.transpose() * row);
                const double rest = row.norm();
                // Twice is enough for rounding.
                row -= kept * (kept.transpose() * row);
                if (rest < singular_threshold)
                  {
                    dependent.push_back(first_row + i);
                    continue;
                  }
                basis.col(n_kept++) = row.normalized();
              }
          }
        return dependent;
      }



      // Empty if one of them belongs to a driver or a rigid pin with clearance,
      // which nothing can replace.
      std::vector<JointEquation>
      find_joint_equations(const Mechanism                 &mechanism,
                           const std::vector<unsigned int> &rows)
      {
        std::vector<JointEquation> result;
        for (unsigned int j = 0; j < mechanism.joints().size(); ++j)
          {
            const JointEntry &joint = mechanism.joints()[j];
            if (joint.has_gap())
              continue;
            const auto &[constraint, first] =
              mechanism.constraints()[joint.index];
            for (unsigned int i = 0; i < constraint->n_equations; ++i)
              if (std::find(rows.begin(), rows.end(), first + i) != rows.end())
                result.push_back({j, i, first + i});
          }
        return result.size() == rows.size() ? result
                                            : std::vector<JointEquation>();
      }



      // A configuration beside q that the constraints allow: the answer does
      // not depend on the direction, as long as it is no special one.
      bool
      move_aside(const EquationsOfMotion &equations,
                 const double             length,
                 Eigen::VectorXd         &q)
      {
        const Mechanism &mechanism = equations.mechanism();
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(
          compute_scaled_jacobian(equations, q).transpose());
        decomposition.setThreshold(singular_threshold);
        const Eigen::MatrixXd basis = decomposition.householderQ();
        const Eigen::MatrixXd free =
          basis.rightCols(q.size() - decomposition.rank());
        if (free.cols() == 0)
          return true;
        Eigen::VectorXd mixed(free.cols());
        for (Eigen::Index i = 0; i < mixed.size(); ++i)
          mixed(i) = std::cos(1. + 2.3 * i);
        Eigen::VectorXd step = length / mixed.norm() * (free * mixed);
        for (Eigen::Index i = 2; i < step.size(); i += 3)
          step(i) /= mechanism.size();
        q += step;
        return solve_positions(equations,
                               0.,
                               ConstraintOffsets(mechanism.n_constraints()),
                               q)
          .converged;
      }



      // Whether the equations hold wherever those of reduced do: at a position
      // beside q, too.
      bool
      follow_from_others(const MechanismParameters        &whole,
                         const MechanismParameters        &reduced,
                         const MechanismParameters        &simulated,
                         const std::vector<JointEquation> &equations,
                         const Eigen::VectorXd            &q)
      {
        const auto without_drivers = [](MechanismParameters parameters) {
          parameters.drivers.clear();
          return parameters;
        };
        const Mechanism         all(without_drivers(whole));
        const Mechanism         kept(without_drivers(reduced));
        const EquationsOfMotion equations_of_all(all, nominal_clearances(all));
        const EquationsOfMotion equations_kept(kept, nominal_clearances(kept));
        Eigen::VectorXd         aside = q;
        bool                    moved = false;
        for (double length = 0.1 * all.size();
             !moved && length > 1e-3 * all.size();
             length /= 4)
          {
            aside = q;
            moved = move_aside(equations_kept, length, aside);
          }
        if (!moved)
          return false;
        // Pins with gaps may be as far off as these let them.
        double gaps = 0.;
        for (const JointParameters &joint : simulated.joints)
          gaps += joint.has_gap() ? joint.clearance() : 0.;
        Eigen::VectorXd phi(all.n_constraints());
        equations_of_all.assemble_constraints(0., aside, phi);
        phi = phi.cwiseProduct(compute_constraint_scales(all)).eval();
        return std::all_of(equations.begin(),
                           equations.end(),
                           [&](const JointEquation &equation) {
                             const double limit =
                               1e-8 * all.size() +
                               (simulated.joints[equation.joint].has_gap()
                                  ? gaps
                                  : 0.);
                             return std::abs(phi(equation.row)) < limit;
                           });
      }
    } // namespace



    MechanismParameters
    leave_out_redundant_constraints(const MechanismParameters &parameters,
                                    const MechanismParameters &simulated)
    {
      const Mechanism         mechanism(parameters);
      const EquationsOfMotion equations(mechanism,
                                        nominal_clearances(mechanism));
      const Mechanism         closed(with_ideal_joints(parameters));
      const Eigen::VectorXd   q =
        assemble_configuration(EquationsOfMotion(closed, {}), 0.);
      const std::vector<JointEquation> dependent =
        find_joint_equations(mechanism,
                             find_dependent_rows(equations, simulated, q));
      if (dependent.empty())
        return parameters;
      MechanismParameters reduced = parameters;
      for (const JointEquation &equation : dependent)
        reduced.joints[equation.joint].left_out[equation.number] = true;
      return follow_from_others(parameters, reduced, simulated, dependent, q)
               ? reduced
               : parameters;
    }



    std::string
    describe_left_out(const Mechanism &mechanism)
    {
      std::string names;
      for (const auto &[constraint, row] : mechanism.constraints())
        for (unsigned int i = 0; i < constraint->n_equations; ++i)
          if (constraint->is_left_out(i))
            {
              names += (names.empty() ? "" : ", ") + constraint->description;
              break;
            }
      if (names.empty())
        return "";
      const unsigned int n = mechanism.n_left_out();
      return "has left out " + std::to_string(n) +
             (n == 1 ? " constraint that follows"
                     : " constraints that follow") +
             " from those of other joints (" + names +
             "): the motion is the same, but how these joints share the forces "
             "is not determined, and they are given as if all were carried by "
             "the others";
    }
  } // namespace Multibody
} // namespace Tribody
