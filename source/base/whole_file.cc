// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/whole_file.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
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



  std::string
  read_regular_file(const std::string &file_name,
                    const std::string &kind,
                    const std::string &place,
                    const std::size_t  max_n_bytes)
  {
    const std::string cannot_read =
      place + "Cannot read the " + kind + " " + in_quotes(file_name) + ": ";
    std::error_code                    error;
    const std::filesystem::file_status status =
      std::filesystem::status(file_name, error);
    AssertThrow(std::filesystem::exists(status),
                ExcInput(cannot_read +
                         (error ? error.message() : "it does not exist") +
                         "."));
    AssertThrow(!std::filesystem::is_directory(status),
                ExcInput(place + in_quotes(file_name) +
                         " is a directory, not a " + kind + "."));
    AssertThrow(std::filesystem::is_regular_file(status),
                ExcInput(place + in_quotes(file_name) +
                         " is a device, a pipe or a socket, not a " + kind +
                         "."));

    // Streams do not tell an error from the end.
    const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(
      std::fopen(file_name.c_str(), "rb"), std::fclose);
    std::string text;
    char        buffer[1 << 16];
    std::size_t n = 0;
    while (file != nullptr && text.size() <= max_n_bytes &&
           (n = std::fread(buffer, 1, sizeof(buffer), file.get())) > 0)
      text.append(buffer, n);
    AssertThrow(file != nullptr && std::ferror(file.get()) == 0,
                ExcInput(cannot_read + std::generic_category().message(errno) +
                         "."));
    return text;
  }
} // namespace Tribody
