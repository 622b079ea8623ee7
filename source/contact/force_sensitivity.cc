#include <Eigen/LU>

#include <tribody/contact/dense_products.h>
#include <tribody/contact/force_sensitivity.h>
#include <tribody/contact/pin_gap.h>

namespace Tribody
{
  namespace Contact
  {
    ForceSensitivity::ForceSensitivity(const Eigen::Matrix2Xd &positions,
                                       const Eigen::MatrixXd  &compliance,
                                       const double            pin_radius)
      : positions(positions)
      , compliance(compliance)
      , pin_radius(pin_radius)
    {}



    void
    ForceSensitivity::add_to(Eigen::MatrixXd       &sum,
                             const ContactSolution &solution,
                             const double           factor)
    {
      const ActiveSet &active = solution.active_set;
      if (!active.empty())
        sum(active, active) -= factor * compute(solution);
    }



    Eigen::MatrixXd
    ForceSensitivity::compute(const ContactSolution &solution)
    {
      const ActiveSet   &active = solution.active_set;
      const Eigen::Index n      = active.size();
      if (n == 0)
        return {};
      active_compliance.update(compliance, active, /*small changes = */ true);

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

      const Eigen::MatrixX2d y         = active_compliance.solve(directions);
      const Eigen::Matrix2d  stiffness = directions.transpose() * y;
      const Eigen::Matrix2d  balance =
        n == 1 ? invert_pin_stiffness(stiffness, n)
                : Eigen::Matrix2d((stiffness + geometric).inverse());
      Eigen::MatrixXd sensitivity = active_compliance.compute_inverse();
      add_product(-y * balance, y.transpose(), sensitivity);
      return sensitivity;
    }
  } // namespace Contact
} // namespace Tribody
