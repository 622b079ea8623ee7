// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <Eigen/LU>

#include <tribody/algebra/dense_products.h>
#include <tribody/contact/active_compliance.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace Tribody
{
  namespace Contact
  {
    namespace
    {
      /// Following this part of the nodes costs as much as a new inverse.
      constexpr double most_exchanged = 0.3;

      /// From so many nodes on it takes longer to follow them.
      constexpr std::size_t n_hierarchical = 400;
    } // namespace



    void
    ActiveCompliance::update(const ActiveSet &nodes,
                             const bool       expect_small_changes)
    {
      if (nodes == active_set)
        return;

      const bool are_many =
        use == Use::solving && nodes.size() >= n_hierarchical;
      if (are_many && compliance.hierarchy().restrict_to(nodes, restriction))
        {
          active_set = nodes;
          form       = Form::hierarchy;
          return;
        }

      ActiveSet entering, leaving;
      std::set_difference(nodes.begin(),
                          nodes.end(),
                          active_set.begin(),
                          active_set.end(),
                          std::back_inserter(entering));
      std::set_difference(active_set.begin(),
                          active_set.end(),
                          nodes.begin(),
                          nodes.end(),
                          std::back_inserter(leaving));
      const bool is_small_change =
        expect_small_changes && !are_many && form != Form::hierarchy &&
        entering.size() + leaving.size() <= most_exchanged * nodes.size();
      if (!is_small_change)
        {
          active_set = nodes;
          factorise();
          return;
        }

      if (form != Form::inverse)
        invert();
      active_set = nodes;
      exchange(leaving, entering);
      was_changed = true;
    }



    bool
    ActiveCompliance::refresh()
    {
      const bool is_different = form == Form::hierarchy || was_changed;
      if (is_different)
        factorise();
      return is_different;
    }



    void
    ActiveCompliance::factorise()
    {
      factor.compute(compliance.matrix()(active_set, active_set));
      place.resize(compliance.matrix().rows());
      form        = Form::factor;
      was_changed = false;
    }



    void
    ActiveCompliance::invert()
    {
      const Eigen::Index m = active_set.size();
      // With room for every node that may still enter.
      const Eigen::Index n =
        use == Use::inverse
          ? place.size()
          : std::max<Eigen::Index>(m, std::min(place.size(), n_hierarchical));
      if (inverse.rows() < n)
        inverse.resize(n, n);
      inverse.topLeftCorner(m, m) =
        factor.solve(Eigen::MatrixXd::Identity(m, m));
      order = active_set;
      std::fill(place.begin(), place.end(), -1);
      for (Eigen::Index k = 0; k < m; ++k)
        place[order[k]] = k;
      form = Form::inverse;
    }



    void
    ActiveCompliance::move_to_end(const ActiveSet &nodes)
    {
      const Eigen::Index m = order.size();
      auto               X = inverse.topLeftCorner(m, m);
      // From behind, so that none of them is moved twice.
      std::vector<Eigen::Index> places;
      for (const Eigen::Index node : nodes)
        places.push_back(place[node]);
      std::sort(places.begin(), places.end(), std::greater<>());
      Eigen::Index last = m;
      for (const Eigen::Index k : places)
        {
          --last;
          if (k == last)
            continue;
          X.row(k).swap(X.row(last));
          X.col(k).swap(X.col(last));
          std::swap(order[k], order[last]);
          place[order[k]] = k;
        }
    }



    void
    ActiveCompliance::exchange(const ActiveSet &leaving,
                               const ActiveSet &entering)
    {
      const Eigen::MatrixXd &C = compliance.matrix();
      move_to_end(leaving);
      const Eigen::Index n_leaving  = leaving.size();
      const Eigen::Index n_entering = entering.size();
      const Eigen::Index n_kept     = order.size() - leaving.size();
      for (const Eigen::Index node : leaving)
        place[node] = -1;
      order.resize(n_kept);

      // Without those that leave, X is X - Z_K^T Z_K.
      auto                  X = inverse.topLeftCorner(n_kept, n_kept);
      const Eigen::MatrixXd Z_K =
        Eigen::LLT<Eigen::MatrixXd>(
          inverse.block(n_kept, n_kept, n_leaving, n_leaving))
          .matrixL()
          .solve(inverse.block(n_kept, 0, n_leaving, n_kept));
      const Eigen::MatrixXd B = C(order, entering);
      Eigen::MatrixXd       Y = DenseProducts::multiply(X, B);
      Y -= Z_K.transpose() * (Z_K * B);
      const Eigen::LLT<Eigen::MatrixXd> S(C(entering, entering) -
                                          B.transpose() * Y);

      Eigen::MatrixXd Z(n_leaving + n_entering, n_kept);
      Z.topRows(n_leaving)     = Z_K;
      Z.bottomRows(n_entering) = S.matrixL().solve(Y.transpose());
      Eigen::MatrixXd signed_Z = Z.transpose();
      signed_Z.leftCols(n_leaving) *= -1.;
      DenseProducts::add_product(signed_Z, Z, X);

      const Eigen::MatrixXd inverse_of_S =
        S.solve(Eigen::MatrixXd::Identity(n_entering, n_entering));
      inverse.block(n_kept, n_kept, n_entering, n_entering) = inverse_of_S;
      inverse.block(0, n_kept, n_kept, n_entering).noalias() =
        -Y * inverse_of_S;
      inverse.block(n_kept, 0, n_entering, n_kept) =
        inverse.block(0, n_kept, n_kept, n_entering).transpose();
      for (const Eigen::Index node : entering)
        {
          place[node] = order.size();
          order.push_back(node);
        }
    }



    Eigen::MatrixXd
    ActiveCompliance::solve(
      const Eigen::Ref<const Eigen::MatrixXd> &right_hand_sides) const
    {
      if (form == Form::factor)
        return factor.solve(right_hand_sides);
      if (form == Form::hierarchy)
        return compliance.hierarchy().solve(restriction, right_hand_sides);

      const Eigen::Index m = active_set.size();
      Eigen::MatrixXd    ordered(m, right_hand_sides.cols());
      for (Eigen::Index k = 0; k < m; ++k)
        ordered.row(place[active_set[k]]) = right_hand_sides.row(k);
      const Eigen::MatrixXd product =
        DenseProducts::multiply(inverse.topLeftCorner(m, m), ordered);
      for (Eigen::Index k = 0; k < m; ++k)
        ordered.row(k) = product.row(place[active_set[k]]);
      return ordered;
    }



    Eigen::MatrixXd
    ActiveCompliance::compute_inverse()
    {
      Assert(use == Use::inverse, dealii::ExcNotImplemented());
      if (form == Form::factor)
        invert();
      std::vector<Eigen::Index> places;
      for (const Eigen::Index node : active_set)
        places.push_back(place[node]);
      return inverse(places, places);
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
