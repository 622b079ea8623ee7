// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/fe/mapping_q.h>

#include <Eigen/Cholesky>

#include <tribody/base/ranks.h>
#include <tribody/bushing/bushing_mesh.h>
#include <tribody/bushing/elastic_joint.h>
#include <tribody/elasticity/pin_elasticity.h>
#include <tribody/elasticity/pressure_models.h>
#include <tribody/elasticity/ring_mesh.h>
#include <tribody/elasticity/stress_postprocessor.h>
#include <tribody/surface/turned_interpolation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // Cells around the bore, if all were as narrow as the narrowest.
      unsigned int
      finest_bore_cells(const BoreNodes &nodes)
      {
        double narrowest = 2. * dealii::numbers::PI;
        for (Eigen::Index i = nodes.degree; i < nodes.n_nodes();
             i += nodes.degree)
          narrowest =
            std::min(narrowest,
                     nodes.angles[i] - nodes.angles[i - nodes.degree]);
        return std::lround(2. * dealii::numbers::PI / narrowest);
      }
    } // namespace



    ElasticJoint::ElasticJoint(const BushingParameters          &parameters,
                               const Multibody::JointParameters &joint,
                               const double    compliance_update,
                               const MPI_Comm &communicator)
      : communicator(communicator)
      , pressure_model(parameters.pressure_model)
      , outer_radius(parameters.outer_radius)
      , cells_are_alike(parameters.cells_are_alike())
      , triangulation(
          make_bushing_mesh(parameters, joint.bushing_radius, communicator))
      , thinnest_wall(
          Elasticity::thinnest_wall(*triangulation, joint.bushing_radius))
      , allowed_change(compliance_update * thinnest_wall)
      , geometry(*triangulation, parameters.element_degree, parameters.name)
      , elasticity(*triangulation,
                   parameters.element_degree,
                   joint.bushing_material,
                   parameters.plane_state,
                   parameters.rim_support)
      , depth(Eigen::VectorXd::Zero(geometry.bore_nodes().n_nodes()))
      , surface(make_bore_surface(geometry.bore_nodes().positions,
                                  geometry.bore_nodes().degree))
    {
      node_walls = Elasticity::wall_thickness(*triangulation,
                                              joint.bushing_radius,
                                              geometry.bore_nodes().angles);
      if (parameters.rim_support.is_housing())
        ring_housing =
          Contact::Housing{elasticity.rim_surface(),
                           outer_radius + parameters.rim_support.housing_gap};
      if (parameters.pin_is_elastic(joint))
        setup_pin(parameters, joint);
      // Of the unworn bore, whatever wears.
      if (pressure_model == PressureModel::infinite_plate)
        plate_compliance =
          Elasticity::infinite_plate_compliance(surface,
                                                elasticity.hooke(),
                                                outer_radius);
      update_compliance();
    }



    void
    ElasticJoint::setup_pin(const BushingParameters          &parameters,
                            const Multibody::JointParameters &joint)
    {
      // As finely as the bore where that is finest.
      Elasticity::RingMeshParameters cells = parameters.mesh;
      cells.n_bore_cells                   = finest_bore_cells(bore_nodes());
      dealii::Triangulation<2> mesh;
      Elasticity::make_pin_mesh(cells,
                                parameters.pin_hole_radius,
                                joint.pin_radius,
                                mesh);
      Elasticity::PinElasticity pin(mesh,
                                    parameters.element_degree,
                                    joint.pin_material,
                                    parameters.plane_state);
      pin.reinit(dealii::MappingQ<2>(parameters.element_degree));
      pin_surface = make_bore_surface(pin.surface_nodes().positions,
                                      parameters.element_degree);
      pin_compliance =
        pin.normal_compliance(pin.surface_nodes().radial_directions(),
                              Elasticity::RingSymmetry::cells_alike);
    }



    void
    ElasticJoint::take_shape(const Wear::WearProfile &profile)
    {
      geometry.update(profile.depth);
      depth   = profile.depth;
      surface = profile.surface();
    }



    void
    ElasticJoint::update(const Wear::WearProfile &profile)
    {
      take_shape(profile);
      if ((depth - depth_at_compliance).lpNorm<Eigen::Infinity>() >
          allowed_change)
        update_compliance();
    }



    void
    ElasticJoint::restore(const Wear::WearProfile &profile,
                          const Eigen::VectorXd   &compliance_depth)
    {
      if (compliance_depth != depth_at_compliance)
        {
          Wear::WearProfile before = profile;
          before.depth             = compliance_depth;
          take_shape(before);
          update_compliance();
        }
      take_shape(profile);
    }



    void
    ElasticJoint::scale_modulus(const double factor)
    {
      if (factor == modulus_factor)
        return;
      modulus_factor = factor;
      elasticity.scale_modulus(factor);
      update_compliance();
    }



    void
    ElasticJoint::update_compliance()
    {
      // Of no depth, until it is complete.
      depth_at_compliance.setConstant(std::numeric_limits<double>::quiet_NaN());
      elasticity.reinit(geometry.mapping());
      Eigen::MatrixXd C = bushing_compliance();
      if (has_elastic_pin())
        {
          const Eigen::MatrixXd P =
            make_turned_interpolation(surface, pin_surface, /*angle = */ 0.);
          const Eigen::Index n = surface.n_nodes();
          C.topLeftCorner(n, n) += P.transpose() * pin_compliance * P;
        }
      joint_compliance    = std::move(C);
      depth_at_compliance = depth;
    }



    Eigen::MatrixXd
    ElasticJoint::bushing_compliance() const
    {
      if (pressure_model == PressureModel::infinite_plate)
        return plate_compliance / modulus_factor;
      if (pressure_model == PressureModel::winkler_layer)
        return Elasticity::winkler_compliance(surface,
                                              elasticity.hooke(),
                                              outer_radius);
      if (ring_housing)
        return elasticity.bore_and_rim_compliance(surface.normals,
                                                  communicator);
      return elasticity.normal_compliance(
        surface.normals,
        cells_are_alike && depth.isZero(0.)
          ? Elasticity::RingSymmetry::cells_alike
          : Elasticity::RingSymmetry::none,
        communicator);
    }



    Eigen::MatrixXd
    ElasticJoint::stiffest_compliance() const
    {
      const Eigen::MatrixXd &C = joint_compliance.matrix();
      if (!ring_housing)
        return C;
      const Eigen::Index    n     = surface.n_nodes();
      const Eigen::Index    n_rim = ring_housing->rim.n_nodes();
      const Eigen::MatrixXd C_rb  = C.bottomLeftCorner(n_rim, n);
      const Eigen::MatrixXd Z =
        Eigen::LLT<Eigen::MatrixXd>(C.bottomRightCorner(n_rim, n_rim))
          .matrixL()
          .solve(C_rb);
      return C.topLeftCorner(n, n) - Z.transpose() * Z;
    }



    void
    ElasticJoint::write_vtu(const std::string              &file_name,
                            const Contact::ContactSolution &contact,
                            const Output::TemperatureField &temperature) const
    {
      const auto write = [&]() {
        const Eigen::Matrix2Xd nodal_forces =
          surface.normals * contact.nodal_force.asDiagonal();
        Eigen::Matrix2Xd rim_forces(2, 0);
        if (ring_housing)
          rim_forces =
            -ring_housing->rim.normals * contact.rim.nodal_force.asDiagonal();
        MeshVector displacement = elasticity.solve(nodal_forces, rim_forces);
        if (ring_housing)
          elasticity.move_rigidly(displacement, contact.rim.ring_place);
        const Elasticity::StressPostprocessor stresses(elasticity.hooke());

        Output::write_bushing_vtu(file_name,
                                  {geometry.mapping(),
                                   elasticity.get_dof_handler(),
                                   elasticity.bore_nodes(),
                                   stresses,
                                   displacement,
                                   geometry.wear_displacement(),
                                   contact.pressure,
                                   depth,
                                   elasticity.rim_nodes(),
                                   contact.rim.pressure,
                                   temperature});
      };
      if (is_distributed(*triangulation))
        return write();
      Ranks::run_together(communicator, [&]() {
        if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
          write();
      });
    }
  } // namespace Coupling
} // namespace Tribody
