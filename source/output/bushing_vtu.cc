// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/ranks.h>
#include <tribody/base/whole_file.h>
#include <tribody/output/bushing_vtu.h>

#include <cerrno>

namespace Tribody
{
  namespace Output
  {
    namespace
    {
      // Two scalar fields on the bore, carried by the two components of the
      // vector-valued element, so that no second numbering is needed.
      MeshVector
      make_bore_field(const BushingFields &fields)
      {
        const BoreNodes &nodes  = fields.bore_nodes;
        MeshVector       values = make_mesh_vector(fields.dof_handler);
        for (Eigen::Index i = 0; i < nodes.n_nodes(); ++i)
          if (values.in_local_range(nodes.x_dofs[i]))
            {
              values[nodes.x_dofs[i]] = fields.contact_pressure[i];
              values[nodes.y_dofs[i]] = fields.wear_depth[i];
            }
        // A ring in a housing is never distributed.
        for (Eigen::Index k = 0; k < fields.rim_pressure.size(); ++k)
          values[fields.rim_nodes.x_dofs[k]] = fields.rim_pressure[k];
        values.update_ghost_values();
        return values;
      }



      // All ranks into one file; the first one gives it its name.
      void
      write_together(const dealii::DataOut<2> &data_out,
                     const std::string        &file_name,
                     const MPI_Comm           &communicator)
      {
        const std::string beside = file_name + ".part";
        std::string       failure;
        errno = 0;
        try
          {
            data_out.write_vtu_in_parallel(beside, communicator);
          }
        catch (const dealii::ExceptionBase &)
          {
            // MPI's words for a full disk are not for users.
            failure = describe_write_error(file_name, errno);
          }
        // It may have failed on some of the ranks only.
        Ranks::run_together(communicator, [&]() {
          AssertThrow(failure.empty(), ExcRun(failure));
        });
        Ranks::run_together(communicator, [&]() {
          if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
            replace_file(file_name, [](const std::string &) {});
        });
      }
    } // namespace



    void
    write_bushing_vtu(const std::string &file_name, const BushingFields &fields)
    {
      using Interpretation =
        dealii::DataComponentInterpretation::DataComponentInterpretation;
      const std::vector<Interpretation> vector_components(
        2, Interpretation::component_is_part_of_vector);
      const std::vector<Interpretation> scalar_components(
        2, Interpretation::component_is_scalar);

      // DataOut keeps a pointer to every vector: this one must outlive it.
      const MeshVector bore_field = make_bore_field(fields);

      dealii::DataOut<2> data_out;
      data_out.attach_dof_handler(fields.dof_handler);
      data_out.add_data_vector(fields.displacement,
                               std::vector<std::string>(2, "displacement"),
                               dealii::DataOut<2>::type_dof_data,
                               vector_components);
      data_out.add_data_vector(fields.wear_displacement,
                               std::vector<std::string>(2, "wear_displacement"),
                               dealii::DataOut<2>::type_dof_data,
                               vector_components);
      data_out.add_data_vector(bore_field,
                               std::vector<std::string>(
                                 {"contact_pressure", "wear_depth"}),
                               dealii::DataOut<2>::type_dof_data,
                               scalar_components);
      data_out.add_data_vector(fields.displacement, fields.stresses);
      if (fields.temperature.values != nullptr)
        data_out.add_data_vector(*fields.temperature.dof_handler,
                                 *fields.temperature.values,
                                 "temperature");
      data_out.build_patches(fields.worn_mapping,
                             fields.dof_handler.get_fe().degree,
                             dealii::DataOut<2>::curved_inner_cells);

      if (is_distributed(fields.dof_handler.get_triangulation()))
        {
          write_together(data_out,
                         file_name,
                         fields.dof_handler.get_communicator());
          return;
        }
      write_whole_file(file_name, [&data_out](std::ostream &file) {
        data_out.write_vtu(file);
      });
    }



    void
    write_pvd(
      const std::string                                 &file_name,
      const std::vector<std::pair<double, std::string>> &times_and_names)
    {
      write_whole_file(file_name, [&](std::ostream &file) {
        dealii::DataOutBase::write_pvd_record(file, times_and_names);
      });
    }
  } // namespace Output
} // namespace Tribody
