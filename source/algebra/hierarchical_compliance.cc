// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/QR>

#include <tribody/algebra/dense_products.h>
#include <tribody/algebra/hierarchical_compliance.h>

#include <algorithm>
#include <numeric>

namespace Tribody
{
  namespace
  {
    using Eigen::Index;

    /// Leaves have half of this number of nodes or more, twice what their
    /// skeletons need; twice as many took longer.
    constexpr Index max_leaf_size = 64;

    /// Outside of [@p begin, @p end).
    std::vector<Index>
    nodes_outside(const Index begin, const Index end, const Index n_nodes)
    {
      std::vector<Index> nodes(n_nodes - (end - begin));
      std::iota(nodes.begin(), nodes.begin() + begin, 0);
      std::iota(nodes.begin() + begin, nodes.end(), end);
      return nodes;
    }

    /// Columns of a matrix from which all others follow.
    struct ColumnChoice
    {
      std::vector<Index> columns;
      /// P: the matrix is about its chosen columns times P^T.
      Eigen::MatrixXd interpolation;
    };

    /// By a QR factorisation with pivots (interpolative decomposition).
    ColumnChoice
    choose_columns(const Eigen::MatrixXd &matrix, const double accuracy)
    {
      const Index n = matrix.cols();
      if (n == 0)
        return {{}, Eigen::MatrixXd(0, 0)};
      Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
      qr.setThreshold(accuracy);
      const Index     k   = qr.rank();
      const auto     &R   = qr.matrixR();
      Eigen::MatrixXd P   = Eigen::MatrixXd::Identity(n, k);
      P.bottomRows(n - k) = R.topLeftCorner(k, k)
                              .triangularView<Eigen::Upper>()
                              .solve(R.topRightCorner(k, n - k))
                              .transpose();
      const auto &order = qr.colsPermutation().indices();
      return {{order.data(), order.data() + k}, qr.colsPermutation() * P};
    }

    void
    append(const std::vector<Index> &more, std::vector<Index> &nodes)
    {
      nodes.insert(nodes.end(), more.begin(), more.end());
    }

    /// Returns whether @p matrix is positive definite.
    bool
    invert(const Eigen::MatrixXd &matrix, Eigen::MatrixXd &inverse)
    {
      const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
      inverse =
        factor.solve(Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
      return factor.info() == Eigen::Success;
    }
  } // namespace



  HierarchicalCompliance::HierarchicalCompliance(
    const Eigen::MatrixXd &compliance,
    const double           accuracy)
    : compliance(compliance)
  {
    const Index n_nodes  = compliance.rows();
    std::size_t n_leaves = 1;
    while (n_nodes > max_leaf_size * static_cast<Index>(n_leaves))
      n_leaves *= 2;
    arcs.resize(2 * n_leaves - 1);
    arcs[0].begin = 0;
    arcs[0].end   = n_nodes;
    for (std::size_t a = 1; a < arcs.size(); ++a)
      {
        const Arc  &whole    = arcs[(a - 1) / 2];
        const Index middle   = (whole.begin + whole.end) / 2;
        const bool  is_first = a % 2 == 1;
        arcs[a].begin        = is_first ? whole.begin : middle;
        arcs[a].end          = is_first ? middle : whole.end;
      }
    // Halves before the arcs that they make up.
    for (std::size_t a = arcs.size() - 1; a > 0; --a)
      prepare(accuracy, a);
  }



  void
  HierarchicalCompliance::prepare(const double accuracy, const std::size_t a)
  {
    Arc            &arc = arcs[a];
    Eigen::MatrixXd K;
    if (is_leaf(a))
      {
        for (Index i = arc.begin; i < arc.end; ++i)
          arc.nodes.push_back(i);
        K = compliance(arc.nodes, arc.nodes);
      }
    else
      {
        const Arc &first = arcs[2 * a + 1], &second = arcs[2 * a + 2];
        if (!first.is_prepared || !second.is_prepared)
          return;
        arc.nodes = first.skeleton;
        append(second.skeleton, arc.nodes);
        K                         = compliance(arc.nodes, arc.nodes);
        const Index k             = first.skeleton.size();
        K.topLeftCorner(k, k)     = first.skeleton_compliance;
        const Index l             = second.skeleton.size();
        K.bottomRightCorner(l, l) = second.skeleton_compliance;
      }

    const ColumnChoice choice = choose_columns(
      compliance(nodes_outside(arc.begin, arc.end, compliance.rows()),
                 arc.nodes),
      accuracy);
    for (const Index i : choice.columns)
      arc.skeleton.push_back(arc.nodes[i]);

    const Eigen::MatrixXd &P = choice.interpolation;
    Eigen::MatrixXd        inverse_of_K, F;
    arc.is_prepared =
      invert(K, inverse_of_K) && invert(P.transpose() * inverse_of_K * P, F);
    arc.shares            = inverse_of_K * P * F;
    arc.shares_transposed = arc.shares.transpose();
    arc.inner_stiffness =
      inverse_of_K - arc.shares * (P.transpose() * inverse_of_K);
    arc.skeleton_compliance = F;
  }



  bool
  HierarchicalCompliance::restrict_to(const std::vector<Eigen::Index> &nodes,
                                      Restriction &restriction) const
  {
    restriction.whole_arcs.clear();
    restriction.loose_rows.clear();
    cut(nodes, 0, nodes.size(), 0, restriction);

    std::vector<std::size_t> whole_arcs;
    for (const WholeArc &arc : restriction.whole_arcs)
      whole_arcs.push_back(arc.number);
    if (whole_arcs != restriction.factorised_arcs)
      {
        restriction.factorised_arcs = whole_arcs;
        restriction.skeletons.clear();
        for (const std::size_t a : whole_arcs)
          append(arcs[a].skeleton, restriction.skeletons);
        Eigen::MatrixXd K_11 =
          compliance(restriction.skeletons, restriction.skeletons);
        Index first = 0;
        for (const std::size_t a : whole_arcs)
          {
            const Eigen::MatrixXd &F = arcs[a].skeleton_compliance;
            K_11.block(first, first, F.rows(), F.cols()) = F;
            first += F.rows();
          }
        restriction.skeleton_factor.compute(K_11);
      }

    std::vector<Index> loose;
    for (const Index row : restriction.loose_rows)
      loose.push_back(nodes[row]);
    restriction.Z = restriction.skeleton_factor.matrixL().solve(
      compliance(restriction.skeletons, loose));
    restriction.loose_factor.compute(compliance(loose, loose) -
                                     restriction.Z.transpose() * restriction.Z);
    return restriction.skeleton_factor.info() == Eigen::Success &&
           restriction.loose_factor.info() == Eigen::Success;
  }



  void
  HierarchicalCompliance::cut(const std::vector<Eigen::Index> &nodes,
                              const Index                      first,
                              const Index                      last,
                              const std::size_t                a,
                              Restriction &restriction) const
  {
    if (first == last)
      return;
    if (arcs[a].is_prepared && last - first == arcs[a].end - arcs[a].begin)
      restriction.whole_arcs.push_back({a, first});
    else if (is_leaf(a))
      for (Index row = first; row < last; ++row)
        restriction.loose_rows.push_back(row);
    else
      {
        const Index middle = std::lower_bound(nodes.begin() + first,
                                              nodes.begin() + last,
                                              arcs[2 * a + 2].begin) -
                             nodes.begin();
        cut(nodes, first, middle, 2 * a + 1, restriction);
        cut(nodes, middle, last, 2 * a + 2, restriction);
      }
  }



  Eigen::MatrixXd
  HierarchicalCompliance::solve(
    const Restriction                       &restriction,
    const Eigen::Ref<const Eigen::MatrixXd> &right_hand_sides) const
  {
    const std::vector<Index> &loose_rows = restriction.loose_rows;
    const auto               &L_11 = restriction.skeleton_factor.matrixL();
    const Eigen::MatrixXd    &Z    = restriction.Z;

    std::vector<Eigen::MatrixXd> yielding(arcs.size());
    Eigen::MatrixXd              skeleton_forces(restriction.skeletons.size(),
                                    right_hand_sides.cols());
    Index                        row = 0;
    for (const WholeArc &arc : restriction.whole_arcs)
      {
        const Index k = arcs[arc.number].skeleton.size();
        skeleton_forces.middleRows(row, k) =
          gather(arc.number, right_hand_sides, arc.first_row, yielding);
        row += k;
      }

    L_11.solveInPlace(skeleton_forces);
    const Eigen::MatrixXd loose_forces = restriction.loose_factor.solve(
      Eigen::MatrixXd(right_hand_sides(loose_rows, Eigen::all)) -
      Z.transpose() * skeleton_forces);
    skeleton_forces -= Z * loose_forces;
    L_11.transpose().solveInPlace(skeleton_forces);

    Eigen::MatrixXd forces(right_hand_sides.rows(), right_hand_sides.cols());
    row = 0;
    for (const WholeArc &arc : restriction.whole_arcs)
      {
        const Index k = arcs[arc.number].skeleton.size();
        distribute(arc.number,
                   skeleton_forces.middleRows(row, k),
                   yielding,
                   arc.first_row,
                   forces);
        row += k;
      }
    forces(loose_rows, Eigen::all) = loose_forces;
    return forces;
  }



  Eigen::MatrixXd
  HierarchicalCompliance::gather(
    const std::size_t                        a,
    const Eigen::Ref<const Eigen::MatrixXd> &right_hand_sides,
    const Index                              first_row,
    std::vector<Eigen::MatrixXd>            &yielding) const
  {
    const Arc &arc = arcs[a];
    if (is_leaf(a))
      yielding[a] = right_hand_sides.middleRows(first_row, arc.end - arc.begin);
    else
      {
        const Index second_row = first_row + arcs[2 * a + 2].begin - arc.begin;
        yielding[a].resize(arc.nodes.size(), right_hand_sides.cols());
        yielding[a] << gather(2 * a + 1, right_hand_sides, first_row, yielding),
          gather(2 * a + 2, right_hand_sides, second_row, yielding);
      }
    return DenseProducts::multiply(arc.shares_transposed, yielding[a]);
  }



  void
  HierarchicalCompliance::distribute(
    const std::size_t                        a,
    const Eigen::Ref<const Eigen::MatrixXd> &skeleton_forces,
    const std::vector<Eigen::MatrixXd>      &yielding,
    const Index                              first_row,
    Eigen::MatrixXd                         &forces) const
  {
    const Arc      &arc = arcs[a];
    Eigen::MatrixXd unknowns =
      DenseProducts::multiply(arc.inner_stiffness, yielding[a]);
    DenseProducts::add_product(arc.shares, skeleton_forces, unknowns);
    if (is_leaf(a))
      {
        forces.middleRows(first_row, arc.end - arc.begin) = unknowns;
        return;
      }
    const Arc  &first = arcs[2 * a + 1], &second = arcs[2 * a + 2];
    const Index second_row = first_row + second.begin - arc.begin;
    distribute(2 * a + 1,
               unknowns.topRows(first.skeleton.size()),
               yielding,
               first_row,
               forces);
    distribute(2 * a + 2,
               unknowns.bottomRows(second.skeleton.size()),
               yielding,
               second_row,
               forces);
  }
} // namespace Tribody
