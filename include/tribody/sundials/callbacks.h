// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_sundials_callbacks_h
#define tribody_sundials_callbacks_h

#include <exception>

namespace Tribody
{
  namespace Sundials
  {
    /**
     * For callbacks of SUNDIALS: exceptions must not pass through C. Anything
     * that @p function throws is kept in @p exception, for the caller of
     * SUNDIALS to throw again.
     * @return what @p function returns, or -1 after an exception: give up.
     */
    template <typename Function>
    int
    guarded(std::exception_ptr &exception, const Function &function)
    {
      try
        {
          return function();
        }
      catch (...)
        {
          exception = std::current_exception();
          return -1;
        }
    }

    /// We report errors ourselves, once, with what to do about them.
    inline void
    silent_error_handler(int, const char *, const char *, char *, void *)
    {}
  } // namespace Sundials
} // namespace Tribody

#endif
