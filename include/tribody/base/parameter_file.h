// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_parameter_file_h
#define tribody_base_parameter_file_h

#include <array>
#include <map>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  /**
   * The assignments of a deal.II parameter file, each with the place where it
   * was made.
   *
   * ParameterHandler::parse_input() needs all entries declared before it reads
   * the file, and forgets the lines afterwards. Here the names of a file's
   * bodies and joints decide what is declared, and a physical check made later
   * still has to say in which line the value stands. So the file's syntax
   * (set, subsection, end, include, comments, continuation by a backslash) is
   * read here; meaning, defaults and documentation stay with ParameterHandler.
   */
  class ParameterFile
  {
  public:
    /**
     * Read @p file_name; include files are looked for relative to the file
     * that includes them.
     *
     * @param overrides assignments "A/B=value" which win over the file.
     * @throws ExcInput naming file and line; also for what is no regular file,
     *   is too long, or includes too many others.
     */
    ParameterFile(const std::string              &file_name,
                  const std::vector<std::string> &overrides = {});

    /// Of the subsections that are named in a list of the file: from their
    /// kind, "Body" of "Body crank", to that list, "Bodies".
    using NamedLists = std::map<std::string, std::string>;

    /**
     * Hand every assignment to @p prm, in which everything must be declared.
     * @param lists that are named in the message about a subsection whose name
     *   stands in none.
     * @throws ExcInput for an undeclared name (with the nearest valid ones)
     *   or a value that does not fit.
     */
    void
    apply(dealii::ParameterHandler &prm, const NamedLists &lists = {}) const;

    /**
     * The last value given to the parameter @p path ("A/B/name"), or
     * @p default_value.
     */
    std::string
    value(const std::string &path, const std::string &default_value) const;

    /// Whether the parameter @p path was given a value.
    bool
    is_set(const std::string &path) const
    {
      return find(path) != nullptr;
    }

    /**
     * Where @p path was set last: "file.prm:12" or "--set". For a subsection,
     * where its first value is set; for what was set nowhere, the file with
     * "(default value)" behind it.
     */
    std::string
    location(const std::string &path) const;

    /// The file that the parameter @p path names, relative to the file in which
    /// it does so, or to the current directory if that is the command line.
    std::string
    file_named_by(const std::string &path) const;

    /// Of all parameters that are set in @p subsection, once each, as seen from
    /// there: "B/name" for "A/B/name".
    std::vector<std::string>
    paths_in(const std::string &subsection) const;

    /// A copy in which no parameter of @p subsection is set that @p paths name,
    /// seen from there.
    ParameterFile
    without(const std::string              &subsection,
            const std::vector<std::string> &paths) const;

    /// A copy in which these parameters of @p subsection are set outside of it
    /// instead, as the last ones: "B/name" for "A/B/name".
    ParameterFile
    with_raised(const std::string              &subsection,
                const std::vector<std::string> &paths) const;

    /// The assignments to these parameters of @p subsection as a parameter
    /// file has them.
    /// @param file_entries parameters that name files; these get full paths.
    std::string
    print(const std::string              &subsection,
          const std::vector<std::string> &paths,
          const std::vector<std::string> &file_entries = {}) const;

  private:
    struct Assignment
    {
      std::vector<std::string> subsections;
      std::string              name;
      std::string              value;
      std::string              location;
    };

    /// @param place where it is included, for messages.
    void
    read(const std::string &file_name,
         const unsigned int depth,
         const std::string &place);

    void
    read_line(const std::string &line,
              const std::string &location,
              const std::size_t  depth_at_start,
              const unsigned int depth);

    void
    add_override(const std::string &text);

    static std::string
    joined(const std::vector<std::string> &subsections);

    static std::string
    path_of(const Assignment &assignment);

    const Assignment *
    find(const std::string &path) const;

    // The path as seen from the subsection; empty if it is not in there.
    static std::string
    path_within(const std::string &subsection, const Assignment &assignment);

    // Without those to these paths within the subsection, and these.
    std::array<std::vector<Assignment>, 2>
    split(const std::string              &subsection,
          const std::vector<std::string> &paths) const;

    void
    index_assignments();

    std::string              file_name;
    std::vector<Assignment>  assignments;
    std::vector<std::string> open_subsections;
    unsigned int             n_files = 0;
    std::size_t              n_bytes = 0;
    // Places in the list of assignments: the last one that sets a parameter,
    // and the first one in a subsection.
    std::map<std::string, std::size_t> last_of_path, first_of_subsection;
  };

  /// From anywhere; @p file_name itself if the current directory is gone.
  std::string
  full_path(const std::string &file_name);

  /**
   * The entries of @p candidates nearest to @p word in edit distance, as
   * "'a' or 'b'"; empty if none is near.
   */
  std::string
  nearest_names(const std::string              &word,
                const std::vector<std::string> &candidates);
} // namespace Tribody

#endif
