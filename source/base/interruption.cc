// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/interruption.h>

#include <csignal>
#include <cstring>
#include <optional>
#include <unistd.h>

namespace Tribody
{
  namespace
  {
    constexpr int watched[] = {SIGINT, SIGTERM, SIGHUP, SIGUSR1};

    constexpr char what_happens[] =
      "Stopping after this step, to write what is reached; again to stop at "
      "once.\n";

    // As the program is called: libraries set handlers of their own later.
    const bool hangup_is_ignored = []() {
      struct sigaction before = {};
      sigaction(SIGHUP, nullptr, &before);
      return before.sa_handler == SIG_IGN;
    }();

    // What a signal handler may write to.
    volatile std::sig_atomic_t interrupting = 0;
    volatile std::sig_atomic_t says_so      = 0;

    std::optional<std::chrono::steady_clock::time_point> time_limit;

    extern "C" void
    remember_signal(const int signal)
    {
      if (interrupting != 0)
        {
          // The second one, whichever it is, ends the program.
          std::signal(signal, SIG_DFL);
          std::raise(signal);
          return;
        }
      interrupting = signal;
      // If nobody reads it, nothing is lost.
      if (says_so != 0 &&
          write(STDERR_FILENO, what_happens, std::strlen(what_happens)) < 0)
        return;
    }
  } // namespace



  std::string
  name_of_signal(const int signal)
  {
    switch (signal)
      {
        case SIGINT:
          return "SIGINT";
        case SIGTERM:
          return "SIGTERM";
        case SIGHUP:
          return "SIGHUP";
        case SIGUSR1:
          return "SIGUSR1";
        default:
          return "signal " + std::to_string(signal);
      }
  }



  void
  watch_for_interruption(const bool says)
  {
    interrupting = 0;
    says_so      = says ? 1 : 0;
    std::signal(SIGPIPE, SIG_IGN);
    // A file beyond 'ulimit -f' is an error of the one who writes it.
    std::signal(SIGXFSZ, SIG_IGN);
    for (const int signal : watched)
      {
        // nohup asks for it. Shells ignore SIGINT for what a script has put in
        // the background, though, and Ctrl-C is to stop all of that.
        if (signal == SIGHUP && hangup_is_ignored)
          {
            std::signal(signal, SIG_IGN);
            continue;
          }
        struct sigaction action = {};
        action.sa_handler       = remember_signal;
        action.sa_flags         = SA_RESTART;
        sigaction(signal, &action, nullptr);
      }
  }



  int
  interrupting_signal()
  {
    return interrupting;
  }



  void
  stop_if_interrupted()
  {
    if (interrupting != 0)
      throw ExcInterrupted(interrupting);
    if (time_limit && std::chrono::steady_clock::now() > *time_limit)
      throw ExcTimeLimit();
  }



  TimeLimit::TimeLimit(const std::chrono::duration<double> given)
  {
    using Clock = std::chrono::steady_clock;
    time_limit =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(given);
  }



  TimeLimit::~TimeLimit()
  {
    time_limit.reset();
  }
} // namespace Tribody
