// SPDX-License-Identifier: LGPL-2.1-or-later

#include <sys/file.h>
#include <sys/stat.h>

#include <tribody/output/directory_lock.h>

#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace Tribody
{
  namespace Output
  {
    namespace
    {
      [[noreturn]] void
      fail(const int error)
      {
        throw std::system_error(error, std::generic_category());
      }



      /// Some file systems of clusters have no locks. A run must not fail for
      /// that.
      bool
      is_without_locks(const int error)
      {
        return error == ENOLCK || error == ENOSYS || error == EOPNOTSUPP;
      }



      /// Whether @p lock, LOCK_EX or LOCK_SH, was to be had.
      bool
      try_lock(const int descriptor, const int lock)
      {
        // One that only looks, see is_locked(), is gone in no time.
        for (unsigned int attempt = 0; attempt < 5; ++attempt)
          {
            if (flock(descriptor, lock | LOCK_NB) == 0 ||
                is_without_locks(errno))
              return true;
            if (errno != EWOULDBLOCK)
              fail(errno);
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
          }
        return false;
      }
    } // namespace



    DirectoryLock::~DirectoryLock()
    {
      release();
    }



    bool
    DirectoryLock::take(const std::string &file_name)
    {
      release();
      descriptor = open(file_name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
      if (descriptor < 0)
        fail(errno);
      // Another run may have moved the directory aside before the lock was had.
      if (try_lock(descriptor, LOCK_EX) && is_on(file_name))
        return true;
      release();
      return false;
    }



    bool
    DirectoryLock::is_on(const std::string &file_name) const
    {
      struct stat ours = {}, there = {};
      return descriptor >= 0 && fstat(descriptor, &ours) == 0 &&
             stat(file_name.c_str(), &there) == 0 &&
             ours.st_dev == there.st_dev && ours.st_ino == there.st_ino;
    }



    void
    DirectoryLock::write(const std::string &text, const long reserve) const
    {
      if (ftruncate(descriptor, 0) != 0 ||
          pwrite(descriptor, text.data(), text.size(), 0) !=
            static_cast<ssize_t>(text.size()))
        fail(errno);
      if (reserve <= 0)
        return;
      int error = 0;
      do
        error = posix_fallocate(descriptor, 0, text.size() + reserve);
      while (error == EINTR);
      // Some file systems have no such thing.
      if (error != 0 && error != EOPNOTSUPP && error != EINVAL)
        fail(error);
    }



    bool
    DirectoryLock::is_locked(const std::string &file_name)
    {
      DirectoryLock looks;
      looks.descriptor = open(file_name.c_str(), O_RDONLY | O_CLOEXEC);
      if (looks.descriptor < 0)
        fail(errno);
      return !try_lock(looks.descriptor, LOCK_SH);
    }



    void
    DirectoryLock::release()
    {
      if (descriptor >= 0)
        close(descriptor);
      descriptor = -1;
    }
  } // namespace Output
} // namespace Tribody
