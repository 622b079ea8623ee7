// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/interruption.h>

#include <csignal>

namespace Tribody
{
  namespace
  {
    // The one thing that a signal handler may write to.
    volatile std::sig_atomic_t interrupted = 0;

    extern "C" void
    remember_signal(const int signal)
    {
      interrupted = 1;
      std::signal(signal, SIG_DFL);
    }
  } // namespace



  void
  watch_for_interruption()
  {
    interrupted = 0;
    std::signal(SIGINT, remember_signal);
    std::signal(SIGTERM, remember_signal);
  }



  bool
  was_interrupted()
  {
    return interrupted != 0;
  }
} // namespace Tribody
