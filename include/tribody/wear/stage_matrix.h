// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_wear_stage_matrix_h
#define tribody_wear_stage_matrix_h

#include <Eigen/LU>

#include <vector>

namespace Tribody
{
  namespace Wear
  {
    /**
     * The matrix @f$ I - \gamma\,dW/dy @f$ of a stage of implicit wear, ready
     * to solve with. Nodes that nothing ever touches do not wear: their rows
     * and columns are those of I, and only the others are factorised.
     */
    class StageMatrix
    {
    public:
      /// @param derivative dW/dy [1 per cycle]. A node with a zero on its
      ///   diagonal does not wear: its row is zero, and what is solved for is
      ///   zero there, so that its column does not matter.
      /// @param gamma [cycles].
      void
      compute(const Eigen::MatrixXd &derivative, const double gamma);

      /// The inverse of the matrix times @p right_hand_side.
      Eigen::VectorXd
      solve(const Eigen::VectorXd &right_hand_side) const;

    private:
      std::vector<Eigen::Index>            worn_nodes;
      Eigen::PartialPivLU<Eigen::MatrixXd> factor;
    };
  } // namespace Wear
} // namespace Tribody

#endif
