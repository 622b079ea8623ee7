#ifndef tribody_coupling_wearing_bushing_h
#define tribody_coupling_wearing_bushing_h

#include <deal.II/grid/tria.h>

#include <Eigen/Core>

#include <tribody/contact/contact_solution.h>
#include <tribody/coupling/bushing_parameters.h>
#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/geometry/worn_configuration.h>
#include <tribody/multibody/joint_parameters.h>
#include <tribody/surface/bore_surface.h>
#include <tribody/surface/clearance_profile.h>
#include <tribody/wear/wear_profile.h>

#include <string>

namespace Tribody
{
  namespace Multibody
  {
    struct JointDutyCycle;
  }

  namespace Coupling
  {
    /// What one duty cycle does to a bushing. A plain value; fields have one
    /// entry per bore node.
    struct CycleContact
    {
      /// Cross-section area that the cycle removes at each node [m^2].
      Eigen::VectorXd removed_area;
      /// Wear depth per cycle [m].
      Eigen::VectorXd wear_rate;
      /// Largest pressure of the cycle at each node [Pa].
      Eigen::VectorXd peak_pressure;
      /// The contact in the sample with the largest normal force.
      Contact::ContactSolution at_peak_force;
      /// Largest pressure of the cycle [Pa], read as Contact::peak_pressure().
      double       max_pressure = 0.;
      unsigned int n_solves     = 0;
    };

    /**
     * The bushing of one joint: an elastic ring whose bore wears. Its state is
     * the wear profile; mesh, worn geometry and compliance follow from it.
     *
     * Two operations make up the chain: compute_cycle_contact() turns joint
     * forces and sliding into pressure and wear per cycle, wear_by() turns wear
     * into new geometry.
     */
    class WearingBushing
    {
    public:
      /**
       * @param compliance_update change of the profile, as a fraction of the
       *   wall, after which the compliance is computed anew [-].
       */
      WearingBushing(const BushingParameters          &parameters,
                     const Multibody::JointParameters &joint,
                     const double                      compliance_update);

      const std::string &
      name() const
      {
        return parameters.name;
      }

      /**
       * Solve the contact in every sample of @p cycle and add up Archard's law
       * over it.
       * @throws ExcRun if a contact problem does not converge; names joint,
       *   phase and force.
       */
      CycleContact
      compute_cycle_contact(const Multibody::JointDutyCycle &cycle) const;

      /**
       * Let the bore wear by @p depth_increment [m], one value per bore node.
       * @throws ExcRun if the worn geometry cannot be meshed.
       */
      void
      wear_by(const Eigen::VectorXd &depth_increment);

      const Wear::WearProfile &
      profile() const
      {
        return wear_profile;
      }

      /// Angles of the bore nodes [rad].
      const Eigen::VectorXd &
      node_angles() const
      {
        return geometry.bore_nodes().angles;
      }

      /// Clearance between pin and worn bore, c + h, over the angle (eq. 28).
      ClearanceProfile
      clearance_profile() const;

      /// What wear has removed, measured on the mesh [m^3].
      double
      worn_volume() const;

      /// Cycles per explicit wear step up to which it is stable, with
      /// @p sliding_per_cycle [m].
      double
      max_stable_step(const double sliding_per_cycle) const;

      /// Write fields of @p contact.at_peak_force to a VTU file.
      void
      write_vtu(const std::string  &file_name,
                const CycleContact &contact) const;

      unsigned int
      n_compliance_builds() const
      {
        return n_builds;
      }

      const BushingParameters &
      bushing_parameters() const
      {
        return parameters;
      }

      const Multibody::JointParameters &
      joint_parameters() const
      {
        return joint;
      }

    private:
      void
      update_compliance();

      BushingParameters             parameters;
      Multibody::JointParameters    joint;
      double                        compliance_update;
      dealii::Triangulation<2>      triangulation;
      Geometry::WornConfiguration   geometry;
      Elasticity::BushingElasticity elasticity;
      Wear::WearProfile             wear_profile;

      BoreSurface     surface;
      Eigen::MatrixXd compliance;
      Eigen::VectorXd depth_at_compliance;
      double          unworn_area;
      unsigned int    n_builds = 0;
    };
  } // namespace Coupling
} // namespace Tribody

#endif
