// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_output_directory_lock_h
#define tribody_output_directory_lock_h

#include <string>

namespace Tribody
{
  namespace Output
  {
    /**
     * A lock on a file, which tells that its directory is in use. It belongs to
     * the file itself, by whatever name or link it is reached, moves with it,
     * and ends with the process. See flock(2). On a file system without locks
     * it is to be had by everyone.
     */
    class DirectoryLock
    {
    public:
      DirectoryLock() = default;
      ~DirectoryLock();

      DirectoryLock(const DirectoryLock &) = delete;
      DirectoryLock &
      operator=(const DirectoryLock &) = delete;

      /**
       * Lock @p file_name, which is made if it is not there, and give up what
       * was locked before.
       * @return whether it was to be had; else another one has it.
       * @throws std::system_error if the file cannot be made or locked.
       */
      bool
      take(const std::string &file_name);

      /// Whether @p file_name is what is locked here.
      bool
      is_on(const std::string &file_name) const;

      /// Whether something is locked here.
      bool
      is_taken() const
      {
        return descriptor >= 0;
      }

      /**
       * Have the locked file say @p text and occupy @p reserve more bytes on
       * the disk.
       * @throws std::system_error if the disk has no such space.
       */
      void
      write(const std::string &text, const long reserve) const;

      /// Whether somebody has a lock on @p file_name.
      /// @throws std::system_error if it cannot be read.
      static bool
      is_locked(const std::string &file_name);

    private:
      void
      release();

      int descriptor = -1;
    };
  } // namespace Output
} // namespace Tribody

#endif
