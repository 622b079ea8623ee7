#include <Eigen/LU>

#include <tribody/contact/active_compliance.h>

#include <cmath>

namespace Tribody
{
  namespace Contact
  {
    void
    ActiveCompliance::update(const Eigen::MatrixXd &compliance,
                             const ActiveSet       &nodes)
    {
      if (nodes == active_set)
        return;
      active_set = nodes;
      factor.compute(compliance(nodes, nodes));
    }



    Eigen::Matrix2d
    invert_pin_stiffness(const Eigen::Matrix2d &stiffness,
                         const Eigen::Index     n_active)
    {
      // The stiffness of one node is k m m^T.
      if (n_active == 1)
        return stiffness / std::pow(stiffness.trace(), 2);
      return stiffness.inverse();
    }
  } // namespace Contact
} // namespace Tribody
