// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_bushing_elastic_joint_h
#define tribody_bushing_elastic_joint_h

#include <deal.II/grid/tria.h>

#include <Eigen/Core>

#include <tribody/bushing/bushing_parameters.h>
#include <tribody/contact/compliance.h>
#include <tribody/contact/contact_solution.h>
#include <tribody/contact/housing.h>
#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/geometry/worn_configuration.h>
#include <tribody/multibody/joints/joint_parameters.h>
#include <tribody/output/bushing_vtu.h>
#include <tribody/surface/bore_surface.h>
#include <tribody/wear/wear_profile.h>

#include <memory>
#include <mpi.h>
#include <optional>
#include <string>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * How the surfaces of one joint give way to contact forces: the meshed
     * bushing, worn to a given profile, and its normal compliance at the bore
     * nodes. If the pin is elastic, its compliance is added to that of the
     * bore, @f$ C = C_b + P^T C_p P @f$ with P of make_turned_interpolation().
     * A round pin looks the same from all sides, so that P needs no angle.
     * With another pressure model, C_b is that of the closed form. For a free
     * ring in a housing all this is at the nodes of bore and rim, as
     * Contact::Housing wants it.
     */
    class ElasticJoint
    {
    public:
      /**
       * Unworn.
       * @param compliance_update change of the profile, as a fraction of the
       *   wall, after which the compliance is computed anew [-].
       * @param communicator of ranks that hold the same joint and share the
       *   columns of its compliance, or also its mesh: they must construct,
       *   update() and write_vtu() together.
       */
      ElasticJoint(const BushingParameters          &parameters,
                   const Multibody::JointParameters &joint,
                   const double                      compliance_update,
                   const MPI_Comm &communicator = MPI_COMM_SELF);

      /**
       * Take the shape of @p profile, whose nodes must be bore_nodes().
       * @throws ExcRun if the worn geometry cannot be meshed.
       */
      void
      update(const Wear::WearProfile &profile);

      /// Take the shape of @p profile with the compliance for the depth
      /// @p compliance_depth [m], as a run had them that has come to this
      /// shape.
      void
      restore(const Wear::WearProfile &profile,
              const Eigen::VectorXd   &compliance_depth);

      /// The depth that the compliance belongs to [m].
      const Eigen::VectorXd &
      compliance_depth() const
      {
        return depth_at_compliance;
      }

      /// Let Young's modulus of the bushing be @p factor times that of its
      /// material; the compliance is computed anew if it changes.
      void
      scale_modulus(const double factor);

      /**
       * How far each bore node moves along its normal as the bushing gets
       * warmer, worn as it is, with the stiffness of the compliance [m].
       * @param temperatures on the mesh().
       * @param rise over the temperature at which the bushing has its size,
       *   over these degrees of freedom [K].
       * @param expansion linear coefficient [1/K].
       */
      Eigen::VectorXd
      thermal_displacement(const dealii::DoFHandler<2>  &temperatures,
                           const dealii::Vector<double> &rise,
                           const double                  expansion) const
      {
        return elasticity.thermal_displacement(
          geometry.mapping(), surface.normals, temperatures, rise, expansion);
      }

      /// Of the bushing as manufactured.
      const dealii::Triangulation<2> &
      mesh() const
      {
        return *triangulation;
      }

      /// Of the mesh() onto the worn bushing.
      const dealii::Mapping<2> &
      mapping() const
      {
        return geometry.mapping();
      }

      /// As manufactured.
      const BoreNodes &
      bore_nodes() const
      {
        return geometry.bore_nodes();
      }

      /// The worn bore of the last update().
      const BoreSurface &
      bore() const
      {
        return surface;
      }

      /// Normal compliance of bore and pin at the bore nodes [m per N/m],
      /// followed by those of the rim if there is a housing. It follows the
      /// shape with the lag that compliance_update allows.
      const Contact::Compliance &
      compliance() const
      {
        return joint_compliance;
      }

      /// Normal compliance of bore and pin at the bore nodes [m per N/m]; of a
      /// ring in a housing with all of the rim held there, as no contact can be
      /// stiffer.
      Eigen::MatrixXd
      stiffest_compliance() const;

      /// What a free ring lies in.
      const std::optional<Contact::Housing> &
      housing() const
      {
        return ring_housing;
      }

      /// Thickness of the unworn wall where it is thinnest [m].
      double
      wall() const
      {
        return thinnest_wall;
      }

      /// Thickness of the unworn wall at each bore node [m].
      const Eigen::VectorXd &
      walls() const
      {
        return node_walls;
      }

      /// Whether the compliance has a share of the pin.
      bool
      has_elastic_pin() const
      {
        return pin_compliance.size() > 0;
      }

      /// Cross-section area that wear has removed, measured on the mesh [m^2].
      double
      removed_area() const
      {
        return geometry.removed_area();
      }

      /// Write displacement and stresses under @p contact, the wear, and the
      /// @p temperature if it is known, to a VTU file: the first rank does, or
      /// all together if they share the mesh.
      void
      write_vtu(const std::string              &file_name,
                const Contact::ContactSolution &contact,
                const Output::TemperatureField &temperature = {}) const;

    private:
      void
      take_shape(const Wear::WearProfile &profile);

      void
      setup_pin(const BushingParameters          &parameters,
                const Multibody::JointParameters &joint);

      void
      update_compliance();

      Eigen::MatrixXd
      bushing_compliance() const;

      MPI_Comm      communicator;
      PressureModel pressure_model;
      double        outer_radius;
      /// Of the unworn bushing.
      bool                                      cells_are_alike;
      std::unique_ptr<dealii::Triangulation<2>> triangulation;
      /// Of the unworn bushing [m].
      double thinnest_wall;
      /// Change of the depth after which the compliance is computed anew [m].
      double                        allowed_change;
      Geometry::WornConfiguration   geometry;
      Elasticity::BushingElasticity elasticity;
      double                        modulus_factor = 1.;
      /// Of the unworn bushing at each bore node [m].
      Eigen::VectorXd node_walls;

      /// Of the hole in an infinite plate; empty with other pressure models.
      Eigen::MatrixXd plate_compliance;
      /// Of the elastic pin; empty if it is rigid.
      BoreSurface     pin_surface;
      Eigen::MatrixXd pin_compliance;

      Eigen::VectorXd                 depth;
      BoreSurface                     surface;
      std::optional<Contact::Housing> ring_housing;
      /// Of bore and pin, at the nodes that can be touched.
      Contact::Compliance joint_compliance;
      Eigen::VectorXd     depth_at_compliance;
    };
  } // namespace Coupling
} // namespace Tribody

#endif
