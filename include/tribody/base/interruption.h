// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_interruption_h
#define tribody_base_interruption_h

#include <deal.II/base/exceptions.h>

#include <chrono>
#include <string>

namespace Tribody
{
  /// "SIGINT" for 2.
  std::string
  name_of_signal(const int signal);

  /**
   * A signal has asked the run to stop. It is no ExcRun: nothing has failed
   * that could be tried in another way. main() answers with exit status 128
   * plus the number of the signal, as shells do.
   */
  class ExcInterrupted : public dealii::ExceptionBase
  {
  public:
    /// @param signal its number.
    explicit ExcInterrupted(const int signal)
      : signal(signal)
    {}

    ~ExcInterrupted() noexcept override = default;

    /// "interrupted by SIGINT".
    void
    print_info(std::ostream &out) const override
    {
      out << "interrupted by " << name_of_signal(signal) << std::endl;
    }

    /// Number of the signal.
    int signal;
  };

  /// The time that a TimeLimit gives is over. It is no ExcRun either.
  class ExcTimeLimit : public dealii::ExceptionBase
  {
  public:
    ~ExcTimeLimit() noexcept override = default;

    /// "time limit reached".
    void
    print_info(std::ostream &out) const override
    {
      out << "time limit reached" << std::endl;
    }
  };

  /**
   * As long as it lives, stop_if_interrupted() ends what lasts longer than the
   * time that it gives. There is one at a time, for a program with one rank:
   * others would not notice at the same moment.
   */
  class TimeLimit
  {
  public:
    /// From now on.
    explicit TimeLimit(const std::chrono::duration<double> given);

    ~TimeLimit();

    TimeLimit(const TimeLimit &) = delete;
    TimeLimit &
    operator=(const TimeLimit &) = delete;
  };

  /**
   * Ask for SIGINT (Ctrl-C), SIGTERM, SIGHUP (a closed terminal) and SIGUSR1 to
   * be remembered instead of ending the program, so that a run can write what
   * it has reached; a line on stderr says so. A second signal ends the program.
   * SIGPIPE is ignored: who no longer reads what a run says does not mean to
   * end it; and SIGXFSZ, so that a file that may not grow is an error like a
   * full disk.
   * @param says whether this rank says so.
   */
  void
  watch_for_interruption(const bool says);

  /// The signal that has come; 0 for none.
  int
  interrupting_signal();

  /// @throws ExcInterrupted if a signal has come, ExcTimeLimit if a TimeLimit
  /// is over. For loops that last; where ranks work together it must come to
  /// all of them alike.
  void
  stop_if_interrupted();
} // namespace Tribody

#endif
