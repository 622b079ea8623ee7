// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/parameter_handler.h>

#include <tribody/case/given_tables.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // Call @p visit with the subsection of each entry that has a table,
      // "Force gas", and the entry.
      template <typename Mechanism, typename Visitor>
      void
      for_each_table(Mechanism &mechanism, const Visitor &visit)
      {
        const auto visit_all = [&visit](const std::string &kind,
                                        auto              &entries) {
          for (auto &entry : entries)
            if (entry.table.is_given())
              visit(kind + " " + entry.name, entry);
        };
        visit_all("Force", mechanism.forces);
        visit_all("Torque", mechanism.torques);
        visit_all("Driver", mechanism.drivers);
      }
    } // namespace



    void
    read_tables(const ParameterFile            &file,
                Multibody::MechanismParameters &mechanism)
    {
      for_each_table(mechanism,
                     [&file](const std::string &subsection, auto &entry) {
                       entry.table.file =
                         file.file_named_by(subsection + "/Table");
                       entry.read_table();
                     });
    }



    void
    set_full_paths_of_tables(const ParameterFile                  &file,
                             const Multibody::MechanismParameters &mechanism,
                             dealii::ParameterHandler             &prm)
    {
      for_each_table(
        mechanism, [&](const std::string &subsection, const auto & /*entry*/) {
          std::error_code             error;
          const std::filesystem::path full =
            std::filesystem::absolute(file.file_named_by(subsection + "/Table"),
                                      error);
          if (error)
            return;
          prm.enter_subsection(subsection);
          prm.set("Table", full.lexically_normal().string());
          prm.leave_subsection();
        });
    }
  } // namespace Coupling
} // namespace Tribody
