#include <Eigen/LU>

#include <tribody/contact/active_compliance.h>
#include <tribody/contact/dense_products.h>

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
      constexpr double largest_change = 0.3;

      Eigen::MatrixXd
      multiply(const ConstBlock &matrix, const Eigen::MatrixXd &few)
      {
        Eigen::MatrixXd product =
          Eigen::MatrixXd::Zero(matrix.rows(), few.cols());
        add_product(matrix, few, product);
        return product;
      }

      /// Add @p sign times @f$ Z^T Z @f$ for a Z of few rows.
      void
      add_square(const double sign, const Eigen::MatrixXd &Z, Block matrix)
      {
        const Eigen::MatrixXd few = sign * Z.transpose();
        add_product(few, Z, matrix);
      }
    } // namespace



    void
    ActiveCompliance::update(const Eigen::MatrixXd &compliance,
                             const ActiveSet       &nodes,
                             const bool             expect_small_changes)
    {
      if (nodes == active_set)
        return;

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
        expect_small_changes &&
        entering.size() + leaving.size() <= largest_change * nodes.size();
      if (!is_small_change)
        {
          active_set = nodes;
          factorise(compliance);
          return;
        }

      if (!has_inverse)
        invert();
      active_set = nodes;
      std::vector<Eigen::Index> leaving_places;
      for (const Eigen::Index node : leaving)
        leaving_places.push_back(place[node]);
      remove(leaving_places);
      append(compliance, entering);
      was_changed = true;
    }



    bool
    ActiveCompliance::refresh(const Eigen::MatrixXd &compliance)
    {
      const bool is_different = was_changed;
      if (is_different)
        factorise(compliance);
      return is_different;
    }



    void
    ActiveCompliance::factorise(const Eigen::MatrixXd &compliance)
    {
      factor.compute(compliance(active_set, active_set));
      place.resize(compliance.rows());
      has_inverse = false;
      was_changed = false;
    }



    void
    ActiveCompliance::invert()
    {
      const Eigen::Index m = active_set.size();
      const Eigen::Index n = place.size();
      // With room for every node that may still enter.
      if (inverse.rows() != n)
        inverse.resize(n, n);
      inverse.topLeftCorner(m, m) =
        factor.solve(Eigen::MatrixXd::Identity(m, m));
      order = active_set;
      std::fill(place.begin(), place.end(), -1);
      for (Eigen::Index k = 0; k < m; ++k)
        place[order[k]] = k;
      has_inverse = true;
    }



    void
    ActiveCompliance::remove(const std::vector<Eigen::Index> &places)
    {
      if (places.empty())
        return;
      // Move what leaves to the end, from behind, so that no place that is
      // still to be read moves.
      std::vector<Eigen::Index> descending = places;
      std::sort(descending.begin(), descending.end(), std::greater<>());
      const Eigen::Index m    = order.size();
      Eigen::Index       last = m;
      for (const Eigen::Index k : descending)
        {
          --last;
          place[order[k]] = -1;
          if (k == last)
            continue;
          auto X = inverse.topLeftCorner(m, m);
          X.row(k).swap(X.row(last));
          X.col(k).swap(X.col(last));
          std::swap(order[k], order[last]);
          place[order[k]] = k;
        }
      const Eigen::Index    n_leaving = places.size();
      const Eigen::MatrixXd X_KR      = inverse.block(last, 0, n_leaving, last);
      const Eigen::MatrixXd Z =
        Eigen::LLT<Eigen::MatrixXd>(
          inverse.block(last, last, n_leaving, n_leaving))
          .matrixL()
          .solve(X_KR);
      add_square(-1., Z, inverse.topLeftCorner(last, last));
      order.resize(last);
    }



    void
    ActiveCompliance::append(const Eigen::MatrixXd &compliance,
                             const ActiveSet       &nodes)
    {
      if (nodes.empty())
        return;
      const Eigen::Index m = order.size();
      const Eigen::Index k = nodes.size();

      auto                              X = inverse.topLeftCorner(m, m);
      const Eigen::MatrixXd             B = compliance(order, nodes);
      const Eigen::MatrixXd             Y = multiply(X, B);
      const Eigen::LLT<Eigen::MatrixXd> S(compliance(nodes, nodes) -
                                          B.transpose() * Y);
      const Eigen::MatrixXd             Z = S.matrixL().solve(Y.transpose());
      add_square(1., Z, X);
      const Eigen::MatrixXd inverse_of_S =
        S.solve(Eigen::MatrixXd::Identity(k, k));
      inverse.block(m, m, k, k)           = inverse_of_S;
      inverse.block(0, m, m, k).noalias() = -Y * inverse_of_S;
      inverse.block(m, 0, k, m) = inverse.block(0, m, m, k).transpose();
      for (const Eigen::Index node : nodes)
        {
          place[node] = order.size();
          order.push_back(node);
        }
    }



    Eigen::MatrixXd
    ActiveCompliance::solve(
      const Eigen::Ref<const Eigen::MatrixXd> &right_hand_sides) const
    {
      if (!has_inverse)
        return factor.solve(right_hand_sides);

      const Eigen::Index m = active_set.size();
      Eigen::MatrixXd    ordered(m, right_hand_sides.cols());
      for (Eigen::Index k = 0; k < m; ++k)
        ordered.row(place[active_set[k]]) = right_hand_sides.row(k);
      const Eigen::MatrixXd product =
        multiply(inverse.topLeftCorner(m, m), ordered);
      for (Eigen::Index k = 0; k < m; ++k)
        ordered.row(k) = product.row(place[active_set[k]]);
      return ordered;
    }



    Eigen::MatrixXd
    ActiveCompliance::compute_inverse()
    {
      if (!has_inverse)
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
