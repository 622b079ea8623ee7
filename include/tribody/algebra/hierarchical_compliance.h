// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_algebra_hierarchical_compliance_h
#define tribody_algebra_hierarchical_compliance_h

#include <Eigen/Cholesky>

#include <vector>

namespace Tribody
{
  /**
   * The compliance C of a surface, prepared so that its part C_A on any set
   * of m nodes is inverted fast: with the factor of a matrix of a hundred or
   * two rows, and some hundred m operations per right-hand side. This is
   * recursive skeletonisation (@cite ho2012) for sets of nodes that change.
   *
   * The nodes, numbered around the bore, are halved again and again into
   * arcs. The unknowns u of an arc are the forces on its nodes or, if it has
   * halves, the forces t_1 and t_2 that stand for those on either half. For
   * the nodes f outside, a few of these unknowns, the arc's skeleton s, do
   * what all of them do, if they take over the others' share:
   * @f[ C_{fu} \approx C_{fs} P^T, \quad t = P^T u, @f]
   * P being one on the skeleton. With w, what the forces outside do at the
   * skeleton, and K, the compliance of the unknowns, they yield by
   * @f[ K u + P w = d, \qquad
   *     K = \begin{pmatrix} F_1 & C_{s_1 s_2} \\
   *                         C_{s_2 s_1} & F_2 \end{pmatrix}, @f]
   * or @f$ K = C_{uu} @f$ if the unknowns are nodal forces. Without u that is
   * @f[ F t + w = G^T d, \quad u = H d + G t, \qquad
   *     F = (P^T K^{-1} P)^{-1}, \quad G = K^{-1} P F, \quad
   *     H = K^{-1} - G P^T K^{-1}: @f]
   * to its surroundings the arc is a few forces t with the compliance F,
   * whose places yield by @f$ G^T d @f$; these are its rows of d in the arc
   * that it is half of.
   *
   * F, G and H belong to whole arcs and are prepared once. A set of nodes is
   * cut into whole arcs, as large as they come, and loose nodes; what remains
   * to be factorised is K of these.
   */
  class HierarchicalCompliance
  {
  public:
    /**
     * @param compliance C, symmetric and positive definite. Must outlive this
     *   object.
     * @param accuracy of what forces do outside of their arc: pivots smaller
     *   than the largest by this factor are left out.
     */
    explicit HierarchicalCompliance(const Eigen::MatrixXd &compliance,
                                    const double           accuracy = 1e-12);

    /// An arc of which all nodes are asked for.
    struct WholeArc
    {
      /// Place of the arc in the tree.
      std::size_t number;
      /// Of its first node in what is asked for.
      Eigen::Index first_row;
    };

    /// C_A, ready to solve with: K of the arcs' skeletons, indexed 1, and the
    /// loose nodes, indexed 2.
    struct Restriction
    {
      /// Arcs of which all nodes are asked for, as large as they come.
      std::vector<WholeArc> whole_arcs;
      /// Places, in what is asked for, of the nodes that no whole arc has.
      std::vector<Eigen::Index> loose_rows;
      /// The arcs and nodes of K_11, and its factor; none at first.
      std::vector<std::size_t> factorised_arcs;
      /// Nodes that stand for factorised_arcs, arc after arc: the unknowns of
      /// K_11.
      std::vector<Eigen::Index> skeletons;
      /// L_11, of K_11.
      Eigen::LLT<Eigen::MatrixXd> skeleton_factor{Eigen::MatrixXd(0, 0)};
      /// Of K_22 - Z^T Z with Z = L_11^{-1} K_12.
      Eigen::MatrixXd Z;
      /// Cholesky factor of K_22 - Z^T Z.
      Eigen::LLT<Eigen::MatrixXd> loose_factor;
    };

    /**
     * Change @p restriction to @p nodes. The factor of K_11 is kept as long
     * as the same whole arcs are asked for.
     * @return whether there is something to solve with: not if C_A is not
     *   positive definite to the accuracy.
     */
    bool
    restrict_to(const std::vector<Eigen::Index> &nodes,
                Restriction                     &restriction) const;

    /// @f$ C_A^{-1} @f$ times @p right_hand_sides, to the accuracy times the
    /// condition of C_A.
    Eigen::MatrixXd
    solve(const Restriction                       &restriction,
          const Eigen::Ref<const Eigen::MatrixXd> &right_hand_sides) const;

  private:
    /// Arc 0 has all nodes, and no skeleton. The halves of arc a are arcs
    /// 2 a + 1 and 2 a + 2.
    struct Arc
    {
      /// Nodes [begin, end).
      Eigen::Index begin, end;
      /// Whether F, G and H are there: not if K is not positive definite.
      bool is_prepared = false;
      /// Where the unknowns act, and which of these nodes are the skeleton.
      std::vector<Eigen::Index> nodes;
      std::vector<Eigen::Index> skeleton;
      /// F, G, G^T and H.
      Eigen::MatrixXd skeleton_compliance;
      Eigen::MatrixXd shares;
      Eigen::MatrixXd shares_transposed;
      Eigen::MatrixXd inner_stiffness;
    };

    bool
    is_leaf(const std::size_t a) const
    {
      return 2 * a + 1 >= arcs.size();
    }

    void
    prepare(const double accuracy, const std::size_t a);

    /// Cut the nodes number @p first to @p last, which lie in arc @p a.
    void
    cut(const std::vector<Eigen::Index> &nodes,
        const Eigen::Index               first,
        const Eigen::Index               last,
        const std::size_t                a,
        Restriction                     &restriction) const;

    /// G^T d of arc @p a, the nodes of which are to yield by the rows of
    /// @p right_hand_sides from @p first_row on. Keeps d of all arcs in it.
    Eigen::MatrixXd
    gather(const std::size_t                        a,
           const Eigen::Ref<const Eigen::MatrixXd> &right_hand_sides,
           const Eigen::Index                       first_row,
           std::vector<Eigen::MatrixXd>            &yielding) const;

    /// The rows of @p forces from @p first_row on, which belong to the
    /// skeleton forces of arc @p a.
    void
    distribute(const std::size_t                        a,
               const Eigen::Ref<const Eigen::MatrixXd> &skeleton_forces,
               const std::vector<Eigen::MatrixXd>      &yielding,
               const Eigen::Index                       first_row,
               Eigen::MatrixXd                         &forces) const;

    const Eigen::MatrixXd &compliance;
    std::vector<Arc>       arcs;
  };
} // namespace Tribody

#endif
