// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/data_out_base.h>
#include <deal.II/grid/reference_cell.h>

#include <tribody/base/whole_file.h>
#include <tribody/output/mechanism_vtu.h>

namespace Tribody
{
  namespace Output
  {
    namespace
    {
      using Patch = dealii::DataOutBase::Patch<1, 2>;

      // A patch for each pair of neighbouring points.
      void
      add_patches(const MechanismLine &line, std::vector<Patch> &patches)
      {
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
          {
            Patch patch;
            patch.patch_index = patches.size();
            // Not set by default; without it, the file has no cells.
            patch.reference_cell = dealii::ReferenceCells::Line;
            patch.data.reinit(5, 2);
            for (const unsigned int k : {0, 1})
              {
                const Eigen::Vector2d &point = line.points[i + k];
                patch.vertices[k]            = {point.x(), point.y()};
                patch.data(0, k)             = static_cast<float>(line.part);
                patch.data(1, k)             = line.body;
                patch.data(2, k)             = line.joint;
                patch.data(3, k)             = line.force.x();
                patch.data(4, k)             = line.force.y();
              }
            patches.push_back(patch);
          }
      }
    } // namespace



    void
    write_mechanism_vtu(const std::string                &file_name,
                        const std::vector<MechanismLine> &lines)
    {
      std::vector<Patch> patches;
      for (const MechanismLine &line : lines)
        add_patches(line, patches);

      // Small files: their number is what takes time.
      dealii::DataOutBase::VtkFlags flags;
      flags.compression_level =
        dealii::DataOutBase::VtkFlags::ZlibCompressionLevel::best_speed;

      write_whole_file(file_name, [&](std::ostream &file) {
        dealii::DataOutBase::write_vtu(
          patches,
          {"part", "body", "joint", "force", "force"},
          {{3,
            4,
            "force",
            dealii::DataComponentInterpretation::component_is_part_of_vector}},
          flags,
          file);
      });
    }
  } // namespace Output
} // namespace Tribody
