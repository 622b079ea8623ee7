// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/foreign_exceptions.h>
#include <tribody/base/in_quotes.h>

#include <filesystem>
#include <new>

namespace Tribody
{
  std::string
  describe_foreign(const std::exception &exception)
  {
    if (dynamic_cast<const std::bad_alloc *>(&exception) != nullptr)
      return "there is not enough memory. Fewer cells ('Mesh'), samples "
             "('Dynamics') or bodies need less.";
    const auto *of_file =
      dynamic_cast<const std::filesystem::filesystem_error *>(&exception);
    if (of_file != nullptr)
      return in_quotes(of_file->path1().string()) + ": " +
             of_file->code().message() + ".";
    return exception.what();
  }
} // namespace Tribody
