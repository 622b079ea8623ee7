#include <deal.II/base/data_out_base.h>

#include <tribody/base/exceptions.h>
#include <tribody/output/mechanism_vtu.h>

#include <fstream>

namespace Tribody
{
  namespace Output
  {
    namespace
    {
      using Patch = dealii::DataOutBase::Patch<1, 2>;

      // One cell per pair of neighbouring points.
      Patch
      make_patch(const MechanismLine &line, const unsigned int index)
      {
        const unsigned int n_points = line.points.size();
        Patch              patch;
        patch.patch_index          = index;
        patch.n_subdivisions       = n_points - 1;
        patch.points_are_available = true;
        patch.data.reinit(7, n_points);
        for (unsigned int i = 0; i < n_points; ++i)
          {
            patch.data(0, i) = static_cast<float>(line.part);
            patch.data(1, i) = line.body;
            patch.data(2, i) = line.joint;
            patch.data(3, i) = line.force.x();
            patch.data(4, i) = line.force.y();
            patch.data(5, i) = line.points[i].x();
            patch.data(6, i) = line.points[i].y();
          }
        return patch;
      }
    } // namespace



    void
    write_mechanism_vtu(const std::string                &file_name,
                        const std::vector<MechanismLine> &lines)
    {
      std::vector<Patch> patches;
      for (const MechanismLine &line : lines)
        patches.push_back(make_patch(line, patches.size()));

      std::ofstream file(file_name);
      dealii::DataOutBase::write_vtu(
        patches,
        {"part", "body", "joint", "force", "force"},
        {{3,
          4,
          "force",
          dealii::DataComponentInterpretation::component_is_part_of_vector}},
        dealii::DataOutBase::VtkFlags(),
        file);
      AssertThrow(file, ExcRun("Cannot write '" + file_name + "'."));
    }
  } // namespace Output
} // namespace Tribody
