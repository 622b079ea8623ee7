// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/whole_file.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace Tribody
{
  std::string
  describe_write_error(const std::string &file_name, const int error)
  {
    return "Cannot write '" + file_name + "'" +
           (error != 0 ? ": " + std::generic_category().message(error) : "") +
           ".";
  }



  void
  replace_file(const std::string                              &file_name,
               const std::function<void(const std::string &)> &write)
  {
    const std::string beside = file_name + ".part";
    std::error_code   error;
    try
      {
        write(beside);
        std::filesystem::rename(beside, file_name, error);
        AssertThrow(!error,
                    ExcRun(describe_write_error(file_name, error.value())));
      }
    catch (...)
      {
        // Half of a file is of no use, and a full disk needs the space.
        std::filesystem::remove(beside, error);
        throw;
      }
  }



  void
  write_whole_file(const std::string                         &file_name,
                   const std::function<void(std::ostream &)> &write)
  {
    replace_file(file_name, [&](const std::string &beside) {
      // errno is that of the first operation that fails if that one throws.
      std::ofstream file;
      file.exceptions(std::ios::failbit | std::ios::badbit);
      errno = 0;
      try
        {
          file.open(beside);
          write(file);
          file.close();
        }
      catch (const std::ios::failure &)
        {
          throw ExcRun(describe_write_error(file_name, errno));
        }
      catch (const dealii::StandardExceptions::ExcIO &)
        {
          throw ExcRun(describe_write_error(file_name, errno));
        }
    });
  }
} // namespace Tribody
