// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_output_output_directory_h
#define tribody_output_output_directory_h

#include <tribody/output/directory_lock.h>

#include <filesystem>
#include <mpi.h>
#include <set>
#include <string>
#include <vector>

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
     *
     * A link is followed, also to a directory that is still to be made: results
     * are where it leads, and what was there is moved aside there, beside the
     * directory or, where that cannot be (the disk's own top, somebody else's
     * directory), into "earlier.1", ... in it.
     */
    class OutputDirectory
    {
    public:
      /**
       * Look, but do not touch: nothing changes on the disk before take().
       * Only the first rank looks, so that no rank that is late takes what the
       * first one has created meanwhile for another run's.
       * @param communicator of the ranks that make it together.
       * @throws ExcInput, on all ranks, if @p path is not empty and not the
       *   output of a run, is being written by another run, is a file, or
       *   cannot be made.
       */
      OutputDirectory(const std::string &path, const MPI_Comm &communicator);

      /// What take() has made goes again if nothing was to be written there.
      ~OutputDirectory();

      OutputDirectory(const OutputDirectory &) = delete;
      OutputDirectory &
      operator=(const OutputDirectory &) = delete;

      /**
       * Keep other runs away from here on; what is there stays as it is.
       * @throws ExcInput, on all ranks, if another run is there, or if the
       *   directory cannot be made or locked.
       */
      void
      take();

      /**
       * Make the directory, moving earlier results aside, and take() it if that
       * was not done. For one rank only.
       * @return a message for the user if something was moved, else "".
       * @throws ExcInput as take().
       * @throws ExcRun if the disk refuses.
       */
      std::string
      create();

      /// Path of the file @p name here, which is to be written.
      /// @throws ExcRun if the directory is no longer that of this run.
      std::string
      file(const std::string &name) const;

      /// Path of the file @p name in the directory of @p joint, which is made
      /// if necessary.
      std::string
      joint_file(const std::string &joint, const std::string &name) const;

      /// Let go what create() has reserved on the disk, for a summary that a
      /// full disk would not take.
      void
      release_reserve() const;

      /// See that all files that were to be written are there.
      /// @throws ExcRun with the name of one that is not.
      void
      check_complete() const;

      /// Of the directory itself, as the user has given it.
      const std::string &
      path() const
      {
        return directory;
      }

    private:
      void
      take_on_this_rank();

      /// @return where to; "" if there was nothing.
      std::string
      move_results_aside();

      /// @throws ExcRun if this is not the directory that was taken.
      void
      check_is_ours() const;

      std::string directory;
      MPI_Comm    communicator;
      /// Where take() has found it, behind all links.
      std::filesystem::path real;
      DirectoryLock         lock;
      bool                  is_created = false;
      /// By take(), the outermost first; the last one may be the mark.
      std::vector<std::filesystem::path> made;
      /// Names that were given out.
      mutable std::set<std::string> files;
    };

    /// "@p stem_0042.extension" for @p number 42.
    std::string
    numbered_name(const std::string &stem,
                  const unsigned int number,
                  const std::string &extension);
  } // namespace Output
} // namespace Tribody

#endif
