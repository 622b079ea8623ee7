// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_exceptions_h
#define tribody_base_exceptions_h

#include <deal.II/base/exceptions.h>

#include <string>

/**
 * Tribody: wear of revolute joints in planar mechanisms.
 */
namespace Tribody
{
  /**
   * What the user gave us cannot be used: a parameter, a file, the command
   * line. The message says what is wrong, with which value, where, and what
   * would be right. main() answers with exit status 2.
   */
  DeclException1(ExcInput, std::string, << arg1);

  /**
   * One parameter has a value that cannot be used. Modules throw it with the
   * parameter's path ("Joint crank_pin/Pin radius"); whoever read the file
   * adds the line and turns it into ExcInput.
   */
  class ExcParameter : public dealii::ExceptionBase
  {
  public:
    /**
     * @param path subsections and name, separated by slashes.
     * @param problem the value that was found and what would be valid.
     */
    ExcParameter(const std::string &path, const std::string &problem)
      : path(path)
      , problem(problem)
    {}

    ~ExcParameter() noexcept override = default;

    /// Path and problem in one line; the caller knows the place in the file.
    void
    print_info(std::ostream &out) const override
    {
      out << path << ": " << problem << std::endl;
    }

    /// Subsections and name of the parameter, separated by slashes.
    std::string path;
    /// The value that was found and what would be valid.
    std::string problem;
  };

  /**
   * The run had to stop: a solver, a mesh or the disk failed. The message
   * names joint, time or cycle, and the parameter that may help. main()
   * answers with exit status 1.
   */
  DeclException1(ExcRun, std::string, << arg1);

  /// What @p exception has to say to the user, without deal.II's frame around
  /// it.
  std::string
  message_of(const dealii::ExceptionBase &exception);
} // namespace Tribody

#endif
