// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/ranks.h>
#include <tribody/output/output_directory.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <unistd.h>

namespace Tribody
{
  namespace Output
  {
    namespace fs = std::filesystem;

    namespace
    {
      // Only a run writes it, so it tells our results from anything else that a
      // user keeps in a directory.
      constexpr const char *mark      = ".tribody";
      constexpr const char *mark_text = "A run of Tribody writes here.\n";

      /// Where results go that cannot be moved beside their directory.
      constexpr const char *inner_aside = "earlier.";

      /// What is kept free on the disk for the summary [bytes].
      constexpr long reserve = 65536;

      [[noreturn]] void
      refuse(const std::string &path, const std::string &problem)
      {
        throw ExcInput("The output directory '" + path + "' " + problem +
                       " Choose another one with --output.");
      }



      /// Words for what a system call said, without the names that C++ adds.
      std::string
      words_of(const std::system_error &error)
      {
        return error.code().message();
      }



      /// Without "." and a slash at the end; where it leads if it is a link.
      /// @throws std::filesystem::filesystem_error
      fs::path
      follow(const std::string &path)
      {
        // Not lexically_normal(): "link/.." is where the link leads.
        fs::path plain(path);
        while ((!plain.has_filename() || plain.filename() == ".") &&
               plain.has_parent_path() && plain.parent_path() != plain)
          plain = plain.parent_path();
        // A circle of links is an error of this call.
        (void)fs::exists(plain);
        while (fs::is_symlink(fs::symlink_status(plain)))
          plain = plain.parent_path() / fs::read_symlink(plain);
        return plain;
      }



      /// Results of a run, without those of earlier ones.
      std::vector<fs::path>
      contents(const fs::path &directory)
      {
        std::vector<fs::path> result;
        if (fs::exists(directory))
          for (const fs::directory_entry &entry :
               fs::directory_iterator(directory))
            if (const std::string name = entry.path().filename().string();
                name != mark && name.rfind(inner_aside, 0) != 0)
              result.push_back(entry.path());
        return result;
      }



      /// The directory and those around it that are still to be made, the
      /// outermost first.
      std::vector<fs::path>
      find_missing(const fs::path &directory)
      {
        std::vector<fs::path> missing;
        for (fs::path p = directory; !p.empty() && !fs::exists(p);
             p          = p.parent_path())
          missing.insert(missing.begin(), p);
        return missing;
      }



      /// @throws ExcInput if @p directory cannot be made or written to.
      void
      check_place(const std::string &path, const fs::path &directory)
      {
        const std::vector<fs::path> missing = find_missing(directory);
        for (const fs::path &p : missing)
          if (fs::is_symlink(fs::symlink_status(p)))
            refuse(path,
                   "cannot be made: '" + p.string() +
                     "' is a link that leads nowhere.");
        fs::path there =
          missing.empty() ? directory : missing.front().parent_path();
        if (there.empty())
          there = ".";
        if (!fs::is_directory(there))
          refuse(path,
                 there == directory
                   ? "is a file."
                   : "cannot be made: '" + there.string() + "' is a file.");
        if (access(there.c_str(), W_OK | X_OK) != 0)
          refuse(path,
                 "cannot be written: '" + there.string() +
                   "': " + std::generic_category().message(errno) + ".");
      }



      /// @throws ExcInput if a run must not write to @p path.
      void
      check(const std::string &path)
      {
        AssertThrow(!path.empty(),
                    ExcInput("The output directory has no name."));
        const fs::path directory = follow(path);
        check_place(path, directory);
        if (!fs::exists(directory))
          return;
        const bool has_mark = fs::exists(directory / mark);
        if (!has_mark && !fs::is_empty(directory))
          refuse(path, "contains files that no run of Tribody has written.");
        if (fs::equivalent(directory, fs::current_path()))
          refuse(path, "is the current one, which cannot be moved aside.");
        if (has_mark && DirectoryLock::is_locked((directory / mark).string()))
          throw ExcInput("Another run is writing to the output directory '" +
                         path + "'. Choose another one with --output.");
      }



      /// The first of the names "<stem>1", "<stem>2", ... that is free.
      fs::path
      free_name(const fs::path &stem)
      {
        unsigned int number = 1;
        const auto   name   = [&]() {
          return fs::path(stem.string() + std::to_string(number));
        };
        while (fs::exists(fs::symlink_status(name())))
          ++number;
        return name();
      }
    } // namespace



    OutputDirectory::OutputDirectory(const std::string &path,
                                     const MPI_Comm    &communicator)
      : directory(path)
      , communicator(communicator)
    {
      Ranks::run_together(communicator, [&]() {
        if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0)
          return;
        try
          {
            check(path);
          }
        catch (const std::system_error &error)
          {
            throw ExcInput("Cannot look at the output directory '" + path +
                           "': " + words_of(error) + ".");
          }
      });
    }



    OutputDirectory::~OutputDirectory()
    {
      if (is_created || !lock.is_on((real / mark).string()))
        return;
      // Only what is empty goes.
      std::error_code error;
      std::for_each(made.rbegin(), made.rend(), [&error](const fs::path &p) {
        fs::remove(p, error);
      });
    }



    void
    OutputDirectory::take()
    {
      Ranks::run_together(communicator, [&]() {
        if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
          take_on_this_rank();
      });
    }



    void
    OutputDirectory::take_on_this_rank()
    {
      try
        {
          real = follow(directory);
          made = find_missing(real);
          fs::create_directories(real);
          if (!fs::exists(real / mark))
            made.push_back(real / mark);
          if (!lock.take((real / mark).string()))
            {
              made.clear();
              throw ExcInput(
                "Another run is writing to the output directory '" + directory +
                "'. Choose another one with --output.");
            }
        }
      catch (const std::system_error &error)
        {
          throw ExcInput("Cannot make or lock the output directory '" +
                         directory + "': " + words_of(error) + ".");
        }
    }



    std::string
    OutputDirectory::create()
    {
      if (!lock.is_taken())
        take_on_this_rank();
      try
        {
          check_is_ours();
          const std::string aside = move_results_aside();
          lock.write(mark_text, reserve);
          is_created = true;
          return aside.empty() ? ""
                               : "Earlier results moved to '" + aside + "'.";
        }
      catch (const std::system_error &error)
        {
          throw ExcRun("Cannot make the output directory '" + directory +
                       "': " + words_of(error) + ".");
        }
    }



    std::string
    OutputDirectory::move_results_aside()
    {
      const std::vector<fs::path> results = contents(real);
      if (results.empty())
        return "";

      const fs::path  beside = free_name(real.string() + ".");
      std::error_code error;
      fs::rename(real, beside, error);
      if (!error)
        {
          // Who is faster here has the directory.
          AssertThrow(fs::create_directory(real) &&
                        lock.take((real / mark).string()),
                      ExcInput("Another run has taken the output directory '" +
                               directory + "'; earlier results are in '" +
                               beside.string() + "'."));
          return beside.string();
        }
      const fs::path inside = free_name(real / inner_aside);
      fs::create_directory(inside);
      for (const fs::path &result : results)
        fs::rename(result, inside / result.filename());
      return inside.string();
    }



    void
    OutputDirectory::check_is_ours() const
    {
      AssertThrow(
        !lock.is_taken() || lock.is_on((fs::path(directory) / mark).string()),
        ExcRun("The output directory '" + directory +
               "' has been removed or replaced since the run began."));
    }



    std::string
    OutputDirectory::file(const std::string &name) const
    {
      check_is_ours();
      const std::string path = (fs::path(directory) / name).string();
      files.insert(path);
      return path;
    }



    std::string
    OutputDirectory::joint_file(const std::string &joint,
                                const std::string &name) const
    {
      check_is_ours();
      const fs::path  joint_directory = fs::path(directory) / joint;
      std::error_code error;
      fs::create_directories(joint_directory, error);
      AssertThrow(!error,
                  ExcRun("Cannot make the directory '" +
                         joint_directory.string() + "': " + error.message() +
                         "."));
      return file((fs::path(joint) / name).string());
    }



    void
    OutputDirectory::release_reserve() const
    {
      if (!lock.is_taken())
        return;
      try
        {
          lock.write(mark_text, 0);
        }
      catch (const std::system_error &)
        {
          // It is there to help; what does not help is said by what follows.
        }
    }



    void
    OutputDirectory::check_complete() const
    {
      // Other ranks may see the disk later.
      if (!lock.is_taken())
        return;
      check_is_ours();
      for (const std::string &path : files)
        {
          std::error_code error;
          AssertThrow(fs::is_regular_file(path, error),
                      ExcRun("The results are not complete: '" + path +
                             "' has been removed since it was written."));
        }
    }



    std::string
    numbered_name(const std::string &stem,
                  const unsigned int number,
                  const std::string &extension)
    {
      return stem + "_" + dealii::Utilities::int_to_string(number, 4) + "." +
             extension;
    }
  } // namespace Output
} // namespace Tribody
