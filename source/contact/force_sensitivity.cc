#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <tribody/contact/active_compliance.h>
#include <tribody/contact/force_sensitivity.h>
#include <tribody/contact/pin_gap.h>

namespace Tribody
{
  namespace Contact
  {
    void
    add_force_sensitivity(const ContactSolution  &solution,
                          const Eigen::Matrix2Xd &positions,
                          const Eigen::MatrixXd  &compliance,
                          const double            pin_radius,
                          const double            factor,
                          Eigen::MatrixXd        &sum)
    {
      const ActiveSet   &active = solution.active_set;
      const Eigen::Index n      = active.size();
      if (n == 0)
        return;

      const PinGap     pin(positions, solution.pin_centre, pin_radius);
      Eigen::MatrixX2d directions(n, 2);
      Eigen::Matrix2d  geometric = Eigen::Matrix2d::Zero();
      for (Eigen::Index k = 0; k < n; ++k)
        {
          const Eigen::Index    i = active[k];
          const Eigen::Vector2d m = pin.directions.col(i);
          directions.row(k)       = m.transpose();
          geometric -= solution.nodal_force[i] / pin.distances[i] *
                       (Eigen::Matrix2d::Identity() - m * m.transpose());
        }

      const Eigen::LLT<Eigen::MatrixXd> factored(compliance(active, active));
      const Eigen::MatrixX2d            y         = factored.solve(directions);
      const Eigen::Matrix2d             stiffness = directions.transpose() * y;
      const Eigen::Matrix2d             inverse =
        n == 1 ? invert_pin_stiffness(stiffness, n)
                           : Eigen::Matrix2d((stiffness + geometric).inverse());
      const Eigen::MatrixXd sensitivity =
        y * inverse * y.transpose() -
        factored.solve(Eigen::MatrixXd::Identity(n, n));
      sum(active, active) += factor * sensitivity;
    }
  } // namespace Contact
} // namespace Tribody
