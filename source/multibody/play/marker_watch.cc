// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/QR>

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/solver_report.h>
#include <tribody/multibody/elements/find_marker.h>
#include <tribody/multibody/play/marker_watch.h>
#include <tribody/multibody/system/constraint_gaps.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/multibody/system/static_equilibrium.h>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Directions that the constraints leave free at q, as columns, with
      // angles times the mechanism's size.
      Eigen::MatrixXd
      find_free_directions(const EquationsOfMotion &equations,
                           const Eigen::VectorXd   &q)
      {
        // Of the largest pivot.
        constexpr double                            singular = 1e-9;
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(
          compute_scaled_jacobian(equations, q).transpose());
        decomposition.setThreshold(singular);
        const Eigen::MatrixXd basis = decomposition.householderQ();
        return basis.rightCols(q.size() - decomposition.rank());
      }



      // Bodies that the constraints leave free where the mechanism is
      // assembled, or a twentieth of its size beside: a slider at its dead
      // centre stands still. For messages.
      std::string
      name_free_bodies(const EquationsOfMotion &equations)
      {
        const Mechanism &mechanism = equations.mechanism();
        // More say no more, and take a large dense matrix.
        constexpr unsigned int most_coordinates = 300, most_names = 10;
        // Of directions of length one.
        constexpr double noticeable = 1e-6;
        if (mechanism.n_coordinates() > most_coordinates)
          return "";
        Eigen::VectorXd q    = assemble_configuration(equations, 0.);
        Eigen::MatrixXd free = find_free_directions(equations, q);
        Eigen::VectorXd step = 0.05 * free.rowwise().sum() * mechanism.size();
        for (Eigen::Index i = 2; i < step.size(); i += 3)
          step(i) /= mechanism.size();
        q += step;
        if (solve_positions(
              equations, 0., ConstraintOffsets(mechanism.n_constraints()), q)
              .converged)
          {
            const Eigen::MatrixXd aside = find_free_directions(equations, q);
            free.conservativeResize(Eigen::NoChange,
                                    free.cols() + aside.cols());
            free.rightCols(aside.cols()) = aside;
          }
        const auto  &bodies = mechanism.parameters().bodies;
        std::string  names;
        unsigned int n = 0;
        for (std::size_t b = 0; b < bodies.size(); ++b)
          if (free.middleRows<3>(3 * b).norm() > noticeable &&
              ++n <= most_names)
            names += (names.empty() ? "'" : ", '") + bodies[b].name + "'";
        return ", in which " + names + (n > most_names ? " and more" : "") +
               (n == 1 ? " moves" : " move");
      }
    } // namespace



    MarkerWatch::MarkerWatch(const EquationsOfMotion &closed,
                             const IdealMotion        motion)
      : closed(closed)
      , motion(motion)
    {
      const std::string          path       = "Watched markers";
      const Mechanism           &mechanism  = closed.mechanism();
      const MechanismParameters &parameters = mechanism.parameters();
      for (const WatchedMarkerParameters &watched : parameters.watched_markers)
        {
          const Marker marker = find_marker(path,
                                            watched.name,
                                            parameters.ground,
                                            parameters.bodies);
          AssertThrow(marker.body != ground_body,
                      ExcParameter(path,
                                   "'" + watched.name +
                                     "' does not move; watch a marker of a "
                                     "body"));
          markers.emplace_back(watched.name, marker);
        }
      const int n_free = mechanism.n_degrees_of_freedom();
      if (markers.empty() || motion == IdealMotion::at_rest || n_free <= 0)
        return;
      throw ExcParameter(
        path,
        "are compared with the motion that drivers prescribe to the mechanism "
        "with ideal joints, but " +
          std::to_string(n_free) +
          (n_free == 1 ? " degree of freedom is" : " degrees of freedom are") +
          " left there" + name_free_bodies(closed) +
          ". Add as many drivers, or use 'Dynamics/Analysis = static "
          "equilibrium', where forces prescribe it");
    }



    Eigen::VectorXd
    MarkerWatch::find_ideal(const double t, const Eigen::VectorXd &q) const
    {
      const ConstraintOffsets none(closed.mechanism().n_constraints());
      Eigen::VectorXd         ideal  = q;
      SolverReport            report = solve_positions(closed, t, none, ideal);
      if (report.converged && motion == IdealMotion::at_rest &&
          closed.mechanism().n_degrees_of_freedom() > 0)
        {
          const StaticEquilibrium rest =
            solve_static_equilibrium(closed, t, ideal);
          ideal  = rest.q;
          report = rest.report;
        }
      AssertThrow(report.converged,
                  ExcRun(
                    "With ideal joints, which watched markers are "
                    "compared with, the mechanism has no position at time " +
                    significant_digits(t, 6) + " s: " + report.message));
      return ideal;
    }



    std::vector<WatchedPath>
    MarkerWatch::compare(const Eigen::VectorXd &times,
                         const Eigen::MatrixXd &coordinates) const
    {
      std::vector<WatchedPath> paths;
      if (markers.empty())
        return paths;
      Eigen::MatrixXd ideal(coordinates.rows(), coordinates.cols());
      for (Eigen::Index s = 0; s < times.size(); ++s)
        ideal.col(s) = find_ideal(times(s), coordinates.col(s));
      for (const auto &[name, marker] : markers)
        paths.push_back(compare_paths(name, marker, coordinates, ideal));
      return paths;
    }
  } // namespace Multibody
} // namespace Tribody
