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
  template <typename Number>
  class Vector;
  template <int dim, int spacedim>
  class Mapping;
} // namespace dealii

namespace Tribody
{
  namespace Output
  {
    /// A temperature [K] over the degrees of freedom of a scalar element on the
    /// same mesh; or none.
    struct TemperatureField
    {
      /// The null pointer where nobody knows it.
      const dealii::DoFHandler<2, 2> *dof_handler = nullptr;
      /// Likewise.
      const dealii::Vector<double> *values = nullptr;
    };

    /**
     * What is known of one bushing at one moment, for a picture. All vectors
     * belong to the given DoFHandler.
     */
    struct BushingFields
    {
      /// Onto the worn bushing.
      const dealii::Mapping<2, 2> &worn_mapping;
      /// Of both displacements.
      const dealii::DoFHandler<2, 2> &dof_handler;
      /// Nodes of the bore, to which contact_pressure and wear_depth belong.
      const BoreNodes &bore_nodes;
      /// Computes stresses from the displacement while the file is written.
      const dealii::DataPostprocessor<2> &stresses;
      /// Elastic displacement [m] in the sample shown.
      const MeshVector &displacement;
      /// By how much wear has moved the mesh [m].
      const MeshVector &wear_displacement;
      /// Contact pressure at the bore nodes in the sample shown [Pa].
      const Eigen::VectorXd &contact_pressure;
      /// Wear depth at the bore nodes [m].
      const Eigen::VectorXd &wear_depth;
      /// Nodes of the rim of a ring in a housing; else empty.
      const BoreNodes &rim_nodes;
      /// Pressure on the rim_nodes [Pa]; empty without a housing.
      const Eigen::VectorXd &rim_pressure;
      /// Of the bushing.
      TemperatureField temperature = {};
    };

    /**
     * Write a VTU file for ParaView: the bushing on its worn geometry [m] with
     * displacement and wear_displacement (vectors), the stresses of the
     * postprocessor, temperature where it is known, and contact_pressure and
     * wear_depth, which live on the bore (contact_pressure of a ring in a
     * housing on the rim, too) and are zero at all nodes inside. The ranks of a
     * distributed mesh write one file together.
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
