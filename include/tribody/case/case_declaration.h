// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_case_case_declaration_h
#define tribody_case_case_declaration_h

#include <tribody/base/parameter_file.h>
#include <tribody/base/parameters.h>
#include <tribody/case/case_parameters.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Coupling
  {
    /// More cycles are not counted.
    constexpr unsigned int max_n_cycles = 999999999;

    /// A list whose names have a subsection each, "Body crank".
    struct NameList
    {
      /// Of the parameter, "Bodies".
      std::string list;
      /// What the subsections begin with, "Body".
      std::string kind;
      /// Of the parameter.
      std::string documentation;
      /// At first those that --print-parameters shows.
      std::vector<std::string> names;
      /// What they may look like.
      NameKind name_kind = NameKind::thing;
    };

    /// The lists that decide which subsections exist.
    std::vector<NameList>
    make_name_lists();

    /// With the names that @p file has. @throws ExcInput.
    std::vector<NameList>
    read_name_lists(const ParameterFile &file);

    /// The names in the list of @p kind.
    const std::vector<std::string> &
    names_of_kind(const std::vector<NameList> &lists, const std::string &kind);

    /// For messages.
    ParameterFile::NamedLists
    lists_of_kinds(const std::vector<NameList> &lists);

    /// All entries of a case with these @p lists. The handler keeps references
    /// into @p parameters and @p lists.
    void
    declare(dealii::ParameterHandler &prm,
            CaseParameters           &parameters,
            std::vector<NameList>    &lists);

    /// As a parameter file, in the order of declaration.
    std::string
    print(dealii::ParameterHandler &prm);
  } // namespace Coupling
} // namespace Tribody

#endif
