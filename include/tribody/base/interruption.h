// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_interruption_h
#define tribody_base_interruption_h

namespace Tribody
{
  /**
   * Ask for SIGINT (Ctrl-C) and SIGTERM to be remembered instead of ending the
   * program, so that a run can write what it has reached. A second signal ends
   * the program.
   */
  void
  watch_for_interruption();

  /// Whether one of the signals has come.
  bool
  was_interrupted();
} // namespace Tribody

#endif
