// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_ranks_h
#define tribody_base_ranks_h

#include <Eigen/Core>

#include <functional>
#include <mpi.h>
#include <string>

namespace Tribody
{
  /**
   * How ranks share work. All of them hold the whole problem and go through the
   * same steps; some steps are cut into pieces, one for each rank, and what
   * comes out is put together on all of them.
   */
  namespace Ranks
  {
    /// Items from @p begin up to but not including @p end.
    struct Range
    {
      /// First item.
      Eigen::Index begin;
      /// One past the last item; begin if the range is empty.
      Eigen::Index end;
    };

    /// The share of this rank in @p n_items: neighbours stay together, no share
    /// is larger than another one by more than one.
    Range
    share(const Eigen::Index n_items, const MPI_Comm &communicator);

    /// Which rank has item @p i in its share().
    unsigned int
    owner(const Eigen::Index i,
          const Eigen::Index n_items,
          const MPI_Comm    &communicator);

    /**
     * Do @p work, which must not communicate, on every rank. If it fails on
     * one, it fails on all of them, so that none waits for another in vain.
     * @throws whatever it threw here; elsewhere the message of the first one
     *   that failed, as ExcInput or ExcInterrupted if so, else as ExcRun.
     */
    void
    run_together(const MPI_Comm              &communicator,
                 const std::function<void()> &work);

    /// Replace @p values, as many on each rank, by their sum over the ranks,
    /// the same bits on all of them.
    void
    sum(Eigen::Ref<Eigen::MatrixXd> values, const MPI_Comm &communicator);

    /// The same with the largest of each value.
    void
    max(Eigen::Ref<Eigen::VectorXd> values, const MPI_Comm &communicator);

    /// Replace @p values by those of rank @p root, as many on each rank.
    void
    broadcast(Eigen::Ref<Eigen::VectorXd> values,
              const unsigned int          root,
              const MPI_Comm             &communicator);

    /**
     * The end of a program that failed with @p message: print it once if all
     * ranks come here; if one fails alone, print where and end the others.
     * @return @p status.
     */
    int
    fail(const std::string &message,
         const int          status,
         const MPI_Comm    &communicator);
  } // namespace Ranks
} // namespace Tribody

#endif
