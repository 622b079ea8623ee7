// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <boost/serialization/utility.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/foreign_exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/interruption.h>
#include <tribody/base/ranks.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <iostream>
#include <thread>
#include <utility>

namespace Tribody
{
  namespace Ranks
  {
    namespace
    {
      /// How long a rank that failed waits for the others to fail too [s].
      constexpr double patience = 5.;



      unsigned int
      n_ranks(const MPI_Comm &communicator)
      {
        return dealii::Utilities::MPI::n_mpi_processes(communicator);
      }



      unsigned int
      this_rank(const MPI_Comm &communicator)
      {
        return dealii::Utilities::MPI::this_mpi_process(communicator);
      }



      std::string
      describe(const std::exception_ptr &failure)
      {
        try
          {
            std::rethrow_exception(failure);
          }
        catch (const dealii::ExceptionBase &exception)
          {
            return message_of(exception);
          }
        catch (const std::exception &exception)
          {
            return describe_foreign(exception);
          }
      }



      // What ranks tell each other of a failure.
      constexpr int about_run = 0, about_input = -1;

      /// One of these, or the signal that has interrupted the work.
      int
      kind_of(const std::exception_ptr &failure)
      {
        try
          {
            std::rethrow_exception(failure);
          }
        catch (const ExcInput &)
          {
            return about_input;
          }
        catch (const ExcInterrupted &interruption)
          {
            return interruption.signal;
          }
        catch (...)
          {
            return about_run;
          }
      }



      /// What to write to the screen: a text that nobody foresaw may be long or
      /// command the terminal.
      std::string
      to_show(const std::string &message)
      {
        constexpr std::size_t max_length = 1000;
        return printable(message.size() <= max_length
                           ? message
                           : message.substr(0, max_length) + " ...");
      }



      /// The first item of @p rank.
      Eigen::Index
      first_item(const unsigned int rank,
                 const Eigen::Index n_items,
                 const MPI_Comm    &communicator)
      {
        return n_items * rank / n_ranks(communicator);
      }
    } // namespace



    Range
    share(const Eigen::Index n_items, const MPI_Comm &communicator)
    {
      const unsigned int rank = this_rank(communicator);
      return {first_item(rank, n_items, communicator),
              first_item(rank + 1, n_items, communicator)};
    }



    unsigned int
    owner(const Eigen::Index i,
          const Eigen::Index n_items,
          const MPI_Comm    &communicator)
    {
      unsigned int rank = 0;
      while (first_item(rank + 1, n_items, communicator) <= i)
        ++rank;
      return rank;
    }



    void
    run_together(const MPI_Comm              &communicator,
                 const std::function<void()> &work)
    {
      const unsigned int n = n_ranks(communicator);
      if (n == 1)
        {
          work();
          return;
        }

      std::exception_ptr failure;
      try
        {
          work();
        }
      catch (...)
        {
          failure = std::current_exception();
        }
      const unsigned int first_failed =
        dealii::Utilities::MPI::min(failure ? this_rank(communicator) : n,
                                    communicator);
      if (first_failed == n)
        return;

      std::pair<int, std::string> own;
      if (first_failed == this_rank(communicator))
        own = {kind_of(failure), describe(failure)};
      const auto [kind, message] =
        dealii::Utilities::MPI::broadcast(communicator, own, first_failed);
      if (failure)
        std::rethrow_exception(failure);
      if (kind == about_input)
        throw ExcInput(message);
      if (kind == about_run)
        throw ExcRun(message);
      throw ExcInterrupted(kind);
    }



    void
    sum(Eigen::Ref<Eigen::MatrixXd> values, const MPI_Comm &communicator)
    {
      if (n_ranks(communicator) == 1)
        return;
      // Columns need not lie next to each other. MPI does not promise that
      // MPI_Allreduce gives the same bits everywhere.
      Eigen::MatrixXd       total(values.rows(), values.cols());
      const Eigen::MatrixXd own   = values;
      int                   error = MPI_Reduce(own.data(),
                             total.data(),
                             own.size(),
                             MPI_DOUBLE,
                             MPI_SUM,
                             0,
                             communicator);
      AssertThrowMPI(error);
      error =
        MPI_Bcast(total.data(), total.size(), MPI_DOUBLE, 0, communicator);
      AssertThrowMPI(error);
      values = total;
    }



    void
    max(Eigen::Ref<Eigen::VectorXd> values, const MPI_Comm &communicator)
    {
      if (n_ranks(communicator) == 1)
        return;
      const int error = MPI_Allreduce(MPI_IN_PLACE,
                                      values.data(),
                                      values.size(),
                                      MPI_DOUBLE,
                                      MPI_MAX,
                                      communicator);
      AssertThrowMPI(error);
    }



    void
    broadcast(Eigen::Ref<Eigen::VectorXd> values,
              const unsigned int          root,
              const MPI_Comm             &communicator)
    {
      if (n_ranks(communicator) == 1)
        return;
      const int error =
        MPI_Bcast(values.data(), values.size(), MPI_DOUBLE, root, communicator);
      AssertThrowMPI(error);
    }



    int
    fail(const std::string &message,
         const int          status,
         const MPI_Comm    &communicator)
    {
      const unsigned int rank = this_rank(communicator);
      if (rank == 0)
        std::cerr << to_show(message) << std::endl;
      if (n_ranks(communicator) == 1)
        return status;

      MPI_Request request;
      MPI_Ibarrier(communicator, &request);
      const auto start      = std::chrono::steady_clock::now();
      int        all_failed = 0;
      while (true)
        {
          MPI_Test(&request, &all_failed, MPI_STATUS_IGNORE);
          const std::chrono::duration<double> waited =
            std::chrono::steady_clock::now() - start;
          if (all_failed != 0 || waited.count() > patience)
            break;
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
      if (all_failed == 0)
        {
          if (rank != 0)
            std::cerr << "Rank " << rank << " alone: " << to_show(message)
                      << std::endl;
          MPI_Abort(communicator, status);
        }
      return status;
    }
  } // namespace Ranks
} // namespace Tribody
