// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_output_bushing_vtu_h
#define tribody_output_bushing_vtu_h

#include <Eigen/Core>

#include <tribody/algebra/mesh_algebra.h>
#include <tribody/surface/bore_nodes.h>

#include <string>

namespace dealii
{
  template <int dim>
  class DataPostprocessor;
  template <int dim, int spacedim>
  class Mapping;
} // namespace dealii

namespace Tribody
{
  namespace Output
  {
    /**
     * What is known of one bushing at one moment, for a picture. All vectors
     * belong to the given DoFHandler.
     */
    struct BushingFields
    {
      const dealii::Mapping<2, 2>        &worn_mapping;
      const dealii::DoFHandler<2, 2>     &dof_handler;
      const BoreNodes                    &bore_nodes;
      const dealii::DataPostprocessor<2> &stresses;
      /// Elastic displacement [m] in the sample shown.
      const MeshVector &displacement;
      /// By how much wear has moved the mesh [m].
      const MeshVector &wear_displacement;
      /// At the bore nodes: contact pressure [Pa] in the sample shown and wear
      /// depth [m].
      const Eigen::VectorXd &contact_pressure;
      const Eigen::VectorXd &wear_depth;
      /// Of a ring in a housing: the nodes of its rim and the pressure there
      /// [Pa]; else both empty.
      const BoreNodes       &rim_nodes;
      const Eigen::VectorXd &rim_pressure;
    };

    /**
     * Write a VTU file for ParaView: the bushing on its worn geometry [m] with
     * displacement and wear_displacement (vectors), the stresses of the
     * postprocessor, and contact_pressure and wear_depth, which live on the
     * bore (contact_pressure of a ring in a housing on the rim, too) and are
     * zero at all nodes inside. The ranks of a distributed mesh write one file
     * together.
     *
     * @throws ExcRun if the file cannot be written.
     */
    void
    write_bushing_vtu(const std::string   &file_name,
                      const BushingFields &fields);

    /// Write a PVD file: @p times_and_names lists time [cycles] and VTU file.
    void
    write_pvd(
      const std::string                                 &file_name,
      const std::vector<std::pair<double, std::string>> &times_and_names);
  } // namespace Output
} // namespace Tribody

#endif
