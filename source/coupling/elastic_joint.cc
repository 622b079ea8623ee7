#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/vector.h>

#include <tribody/coupling/elastic_joint.h>
#include <tribody/elasticity/pin_elasticity.h>
#include <tribody/elasticity/pressure_models.h>
#include <tribody/elasticity/ring_mesh.h>
#include <tribody/elasticity/stress_postprocessor.h>
#include <tribody/output/bushing_vtu.h>
#include <tribody/surface/turned_interpolation.h>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // A mesh must exist before the members that live on it are constructed.
      dealii::Triangulation<2>
      make_mesh(const BushingParameters          &parameters,
                const Multibody::JointParameters &joint)
      {
        dealii::Triangulation<2> triangulation;
        Elasticity::make_ring_mesh(parameters.mesh,
                                   joint.bushing_radius,
                                   parameters.outer_radius,
                                   triangulation);
        return triangulation;
      }



      Elasticity::PlaneState
      plane_state(const std::string &name)
      {
        return name == "plane stress" ? Elasticity::PlaneState::stress
                                      : Elasticity::PlaneState::strain;
      }
    } // namespace



    ElasticJoint::ElasticJoint(const BushingParameters          &parameters,
                               const Multibody::JointParameters &joint,
                               const double compliance_update)
      : pressure_model(parameters.pressure_model)
      , outer_radius(parameters.outer_radius)
      , allowed_change(compliance_update *
                       (parameters.outer_radius - joint.bushing_radius))
      , triangulation(make_mesh(parameters, joint))
      , geometry(triangulation, parameters.element_degree, parameters.name)
      , elasticity(triangulation,
                   parameters.element_degree,
                   joint.bushing_material,
                   plane_state(parameters.plane_state))
      , depth(Eigen::VectorXd::Zero(geometry.bore_nodes().n_nodes()))
      , surface(make_bore_surface(geometry.bore_nodes().positions,
                                  geometry.bore_nodes().degree))
    {
      if (parameters.pin_is_elastic(joint))
        setup_pin(parameters, joint);
      if (pressure_model == "infinite plate")
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
      dealii::Triangulation<2> mesh;
      Elasticity::make_pin_mesh(parameters.mesh,
                                parameters.pin_hole_radius,
                                joint.pin_radius,
                                mesh);
      Elasticity::PinElasticity pin(mesh,
                                    parameters.element_degree,
                                    joint.pin_material,
                                    plane_state(parameters.plane_state));
      pin.reinit(dealii::MappingQ<2>(parameters.element_degree));
      pin_surface = make_bore_surface(pin.surface_nodes().positions,
                                      parameters.element_degree);
      pin_compliance =
        pin.normal_compliance(pin.surface_nodes().radial_directions(),
                              Elasticity::RingSymmetry::cells_alike);
    }



    void
    ElasticJoint::update(const Wear::WearProfile &profile)
    {
      geometry.update(profile.depth);
      depth   = profile.depth;
      surface = profile.surface();
      if ((depth - depth_at_compliance).lpNorm<Eigen::Infinity>() >
          allowed_change)
        update_compliance();
    }



    void
    ElasticJoint::update_compliance()
    {
      elasticity.reinit(geometry.mapping());
      joint_compliance = bushing_compliance();
      if (has_elastic_pin())
        {
          const Eigen::MatrixXd P =
            make_turned_interpolation(surface, pin_surface, /*angle = */ 0.);
          joint_compliance += P.transpose() * pin_compliance * P;
        }
      depth_at_compliance = depth;
      ++n_builds;
    }



    Eigen::MatrixXd
    ElasticJoint::bushing_compliance() const
    {
      if (pressure_model == "infinite plate")
        return plate_compliance;
      if (pressure_model == "Winkler layer")
        return Elasticity::winkler_compliance(surface,
                                              elasticity.hooke(),
                                              outer_radius);
      return elasticity.normal_compliance(
        surface.normals,
        depth.isZero(0.) ? Elasticity::RingSymmetry::cells_alike
                         : Elasticity::RingSymmetry::none);
    }



    void
    ElasticJoint::write_vtu(const std::string              &file_name,
                            const Contact::ContactSolution &contact) const
    {
      const Eigen::Matrix2Xd nodal_forces =
        surface.normals * contact.nodal_force.asDiagonal();
      const dealii::Vector<double> displacement =
        elasticity.solve(nodal_forces);
      const Elasticity::StressPostprocessor stresses(elasticity.hooke());

      Output::write_bushing_vtu(file_name,
                                {geometry.mapping(),
                                 elasticity.get_dof_handler(),
                                 elasticity.bore_nodes(),
                                 stresses,
                                 displacement,
                                 geometry.wear_displacement(),
                                 contact.pressure,
                                 depth});
    }
  } // namespace Coupling
} // namespace Tribody
