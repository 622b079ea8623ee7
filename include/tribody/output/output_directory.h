// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_output_output_directory_h
#define tribody_output_output_directory_h

#include <boost/interprocess/sync/file_lock.hpp>

#include <mpi.h>
#include <string>

namespace Tribody
{
  namespace Output
  {
    /**
     * The directory that one run writes to. Results of different runs never
     * mix: what an earlier run of Tribody left there is moved aside as a whole
     * to "<name>.1", "<name>.2", ..., and a directory with anything else in it
     * is refused. A hidden file, ".tribody", marks the directory of a run; it
     * is locked while the run lasts, so that a second run is refused too.
     */
    class OutputDirectory
    {
    public:
      /**
       * Look, but do not touch: nothing changes on the disk before create().
       * Only the first rank looks, so that no rank that is late takes what the
       * first one has created meanwhile for another run's.
       * @param communicator of the ranks that make it together.
       * @throws ExcInput, on all ranks, if @p path is not empty and not the
       *   output of a run, is being written by another run, or is a file.
       */
      OutputDirectory(const std::string &path, const MPI_Comm &communicator);

      /**
       * Make the directory, moving earlier results aside. For one rank only.
       * @return a message for the user if something was moved, else "".
       * @throws ExcRun if the disk refuses.
       */
      std::string
      create();

      /// Path of the file @p name here.
      std::string
      file(const std::string &name) const;

      /// Path of the file @p name in the directory of @p joint, which is made
      /// if necessary.
      std::string
      joint_file(const std::string &joint, const std::string &name) const;

      /// Of the directory itself, as the user has given it.
      const std::string &
      path() const
      {
        return directory;
      }

    private:
      std::string                    directory;
      boost::interprocess::file_lock lock;
    };

    /// "@p stem_0042.extension" for @p number 42.
    std::string
    numbered_name(const std::string &stem,
                  const unsigned int number,
                  const std::string &extension);
  } // namespace Output
} // namespace Tribody

#endif
