// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <boost/interprocess/exceptions.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/ranks.h>
#include <tribody/output/output_directory.h>

#include <filesystem>
#include <fstream>

namespace Tribody
{
  namespace Output
  {
    namespace fs = std::filesystem;

    namespace
    {
      // Only a run writes it, so it tells our results from anything else that a
      // user keeps in a directory.
      constexpr const char *mark = ".tribody";

      bool
      has_content(const fs::path &directory)
      {
        return fs::exists(directory) && !fs::is_empty(directory);
      }



      /// @throws ExcInput if a run must not write to @p path.
      void
      check(const std::string &path)
      {
        AssertThrow(!path.empty(),
                    ExcInput("The output directory has no name."));
        AssertThrow(!fs::exists(path) || fs::is_directory(path),
                    ExcInput("The output directory '" + path +
                             "' is a file. Choose another one with --output."));
        AssertThrow(!has_content(path) || fs::exists(fs::path(path) / mark),
                    ExcInput("The output directory '" + path +
                             "' contains files that no run of Tribody has "
                             "written. Choose another one with --output."));
        AssertThrow(
          !fs::exists(path) || !fs::equivalent(path, fs::current_path()),
          ExcInput("The output directory '" + path +
                   "' is the current one, which cannot be moved aside. "
                   "Choose another one with --output."));
        AssertThrow(!has_content(path) || boost::interprocess::file_lock(
                                            (fs::path(path) / mark).c_str())
                                            .try_lock(),
                    ExcInput(
                      "Another run is writing to the output directory '" +
                      path + "'. Choose another one with --output."));
      }
    } // namespace



    OutputDirectory::OutputDirectory(const std::string &path,
                                     const MPI_Comm    &communicator)
      : directory(path)
    {
      Ranks::run_together(communicator, [&]() {
        if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0)
          return;
        try
          {
            check(path);
          }
        catch (const fs::filesystem_error &error)
          {
            AssertThrow(false,
                        ExcInput("Cannot look at the output directory '" +
                                 path + "': " + error.code().message() + "."));
          }
      });
    }



    std::string
    OutputDirectory::create()
    {
      std::string message;
      try
        {
          if (has_content(directory))
            {
              fs::path plain = fs::path(directory).lexically_normal();
              if (!plain.has_filename())
                plain = plain.parent_path();
              unsigned int number = 1;
              while (fs::exists(plain.string() + "." + std::to_string(number)))
                ++number;
              const std::string aside =
                plain.string() + "." + std::to_string(number);
              fs::rename(plain, aside);
              message = "Earlier results moved to '" + aside + "'.";
            }
          fs::create_directories(directory);
          std::ofstream(file(mark)) << "A run of Tribody writes here.\n";
          lock = boost::interprocess::file_lock(file(mark).c_str());
          lock.try_lock();
        }
      catch (const boost::interprocess::interprocess_exception &error)
        {
          AssertThrow(false,
                      ExcRun("Cannot lock the output directory '" + directory +
                             "': " + error.what() + "."));
        }
      catch (const fs::filesystem_error &error)
        {
          AssertThrow(false,
                      ExcRun("Cannot make the output directory '" + directory +
                             "': " + error.code().message() + "."));
        }
      return message;
    }



    std::string
    OutputDirectory::file(const std::string &name) const
    {
      return (fs::path(directory) / name).string();
    }



    std::string
    OutputDirectory::joint_file(const std::string &joint,
                                const std::string &name) const
    {
      const fs::path  joint_directory = fs::path(directory) / joint;
      std::error_code error;
      fs::create_directories(joint_directory, error);
      AssertThrow(!error,
                  ExcRun("Cannot make the directory '" +
                         joint_directory.string() + "': " + error.message() +
                         "."));
      return (joint_directory / name).string();
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
