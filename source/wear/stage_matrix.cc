// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/wear/stage_matrix.h>

namespace Tribody
{
  namespace Wear
  {
    void
    StageMatrix::compute(const Eigen::MatrixXd &derivative, const double gamma)
    {
      worn_nodes.clear();
      for (Eigen::Index i = 0; i < derivative.rows(); ++i)
        if (derivative(i, i) != 0.)
          worn_nodes.push_back(i);
      if (worn_nodes.empty())
        return;
      Eigen::MatrixXd matrix = -gamma * derivative(worn_nodes, worn_nodes);
      matrix.diagonal().array() += 1.;
      factor.compute(matrix);
    }



    Eigen::VectorXd
    StageMatrix::solve(const Eigen::VectorXd &right_hand_side) const
    {
      Eigen::VectorXd solution = right_hand_side;
      if (worn_nodes.empty())
        return solution;
      const Eigen::VectorXd worn = right_hand_side(worn_nodes);
      const Eigen::VectorXd x    = factor.solve(worn);
      solution(worn_nodes)       = x;
      return solution;
    }
  } // namespace Wear
} // namespace Tribody
