#ifndef tribody_base_parameters_h
#define tribody_base_parameters_h

#include <deal.II/base/point.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  /**
   * Declaration of single parameters in deal.II's ParameterHandler, bound to
   * a variable in SI units. The variable's value at the time of the call is
   * the default. For use in the add_parameters() function that stands next to
   * each parameter struct; the handler must not outlive the variable.
   */
  namespace Parameters
  {
    /**
     * A physical quantity, read by Units::from_string().
     *
     * @param si_unit the unit of @p value, empty for a pure number.
     * @param shown_unit the unit in which the default is printed; @p si_unit
     *   if empty.
     */
    void
    add_quantity(dealii::ParameterHandler &prm,
                 const std::string &       name,
                 double &                  value,
                 const std::string &       si_unit,
                 const std::string &       documentation,
                 const std::string &       shown_unit = "");

    /// A point or vector: two quantities separated by a comma.
    void
    add_point(dealii::ParameterHandler &prm,
              const std::string &       name,
              dealii::Point<2> &        value,
              const std::string &       si_unit,
              const std::string &       documentation,
              const std::string &       shown_unit = "");

    /// Named points, "O: 0 mm, 0 mm; A: 38.1 mm, 0 mm".
    void
    add_named_points(dealii::ParameterHandler &               prm,
                     const std::string &                      name,
                     std::map<std::string, dealii::Point<2>> &value,
                     const std::string &                      si_unit,
                     const std::string &                      documentation);

    /// Names separated by commas: letters, digits, '_', '-' and '+'.
    void
    add_names(dealii::ParameterHandler &prm,
              const std::string &       name,
              std::vector<std::string> &value,
              const std::string &       documentation);

    /// One of several words.
    void
    add_choice(dealii::ParameterHandler &      prm,
               const std::string &             name,
               std::string &                   value,
               const std::vector<std::string> &choices,
               const std::string &             documentation);

    /// Free text, taken as it is.
    void
    add_text(dealii::ParameterHandler &prm,
             const std::string &       name,
             std::string &             value,
             const std::string &       documentation);

    /// A whole number in [@p minimum, @p maximum].
    void
    add_integer(dealii::ParameterHandler &prm,
                const std::string &       name,
                unsigned int &            value,
                const std::string &       documentation,
                const unsigned int        minimum,
                const unsigned int        maximum);

    /// yes or no.
    void
    add_flag(dealii::ParameterHandler &prm,
             const std::string &       name,
             bool &                    value,
             const std::string &       documentation);
  } // namespace Parameters

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
     * @throws ExcInput naming file and line.
     */
    ParameterFile(const std::string &             file_name,
                  const std::vector<std::string> &overrides = {});

    /**
     * Hand every assignment to @p prm, in which everything must be declared.
     * @throws ExcInput for an undeclared name (with the nearest valid ones)
     *   or a value that does not fit.
     */
    void
    apply(dealii::ParameterHandler &prm) const;

    /**
     * The last value given to the parameter @p path ("A/B/name"), or
     * @p default_value.
     */
    std::string
    value(const std::string &path, const std::string &default_value) const;

    /**
     * Where @p path was set last: "file.prm:12", "--set", or "default value"
     * when it was not.
     */
    std::string
    location(const std::string &path) const;

  private:
    struct Assignment
    {
      std::vector<std::string> subsections;
      std::string              name;
      std::string              value;
      std::string              location;
    };

    void
    read(const std::string &file_name, const unsigned int depth);

    void
    add_override(const std::string &text);

    const Assignment *
    find(const std::string &path) const;

    std::vector<Assignment>  assignments;
    std::vector<std::string> open_subsections;
  };

  /// Split "a, b, c" into trimmed, non-empty names.
  std::vector<std::string>
  split_names(const std::string &text);

  /**
   * The entries of @p candidates nearest to @p word in edit distance, as
   * "'a' or 'b'"; empty if none is near.
   */
  std::string
  nearest_names(const std::string &             word,
                const std::vector<std::string> &candidates);
} // namespace Tribody

#endif
