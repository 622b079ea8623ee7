#include <tribody/contact/active_compliance.h>

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
  } // namespace Contact
} // namespace Tribody
