#ifndef tribody_coupling_wearing_bushing_h
#define tribody_coupling_wearing_bushing_h

#include <Eigen/Core>

#include <tribody/contact/contact_solution.h>
#include <tribody/coupling/bushing_parameters.h>
#include <tribody/coupling/elastic_joint.h>
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
      /// The contact in every sample, and how far the pin slides in it [m].
      std::vector<Contact::ContactSolution> samples;
      Eigen::VectorXd                       sliding_increments;
      /// The worn bore that they belong to.
      BoreSurface surface;
      /// Cross-section area that the cycle removes at each node [m^2].
      Eigen::VectorXd removed_area;
      /// Wear depth per cycle [m].
      Eigen::VectorXd wear_rate;
      /// Largest pressure of the cycle at each node [Pa].
      Eigen::VectorXd peak_pressure;
      /// Index of the sample with the largest normal force.
      std::size_t peak_sample = 0;
      /// Largest pressure of the cycle [Pa], read as Contact::peak_pressure().
      double max_pressure = 0.;

      const Contact::ContactSolution &
      at_peak_force() const
      {
        return samples[peak_sample];
      }
    };

    /**
     * The bushing of one joint, whose bore wears. Its state is the wear
     * profile; what gives way follows from it, see ElasticJoint.
     *
     * Two operations make up the chain: compute_cycle_contact() turns joint
     * forces and sliding into pressure and wear per cycle, set_depth() turns
     * wear into new geometry.
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
       * Solve the contact in every sample of @p cycle for a bore that is worn
       * by @p depth [m], and add up Archard's law over the cycle.
       * @param similar the result for a similar bore, to start from, or
       * nullptr.
       * @throws ExcRun if a contact problem does not converge; names joint,
       *   sample and force.
       */
      CycleContact
      compute_cycle_contact(const Eigen::VectorXd           &depth,
                            const Multibody::JointDutyCycle &cycle,
                            const CycleContact              *similar) const;

      /**
       * The same with the nodes of @p held in contact, sample by sample, as
       * Contact::ContactSolver::solve_held() has it: rates may be negative
       * where the wrong nodes are held.
       */
      CycleContact
      compute_held_contact(const Eigen::VectorXd           &depth,
                           const Multibody::JointDutyCycle &cycle,
                           const CycleContact              &held) const;

      /**
       * How the wear rate changes with the depth, dW/dh [per cycle]: minus the
       * sum over the samples of @f$ k\,\Delta s\,D^{-1} S @f$, with D the
       * derivative of the bore's area and S of Contact::ForceSensitivity. What
       * the wear does to D, and what it does to the dynamics, is left out.
       */
      Eigen::MatrixXd
      compute_wear_rate_jacobian(const CycleContact &contact) const;

      /**
       * Let the bore be worn by @p depth [m] in all, one value per bore node.
       * @throws ExcRun if the worn geometry cannot be meshed.
       */
      void
      set_depth(const Eigen::VectorXd &depth);

      const Wear::WearProfile &
      profile() const
      {
        return wear_profile;
      }

      /// Angles of the bore nodes [rad].
      const Eigen::VectorXd &
      node_angles() const
      {
        return elastic.bore_nodes().angles;
      }

      /// Clearance between pin and worn bore, c + h, over the angle (eq. 28).
      ClearanceProfile
      clearance_profile() const;

      /// What is lost when the bore is worn by @p depth [m], from the bore
      /// curve alone [m^3].
      double
      volume_for_depth(const Eigen::VectorXd &depth) const;

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
        return elastic.n_compliance_builds();
      }

      bool
      has_elastic_pin() const
      {
        return elastic.has_elastic_pin();
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
      /// How the nodes in contact are found: by the contact problem, or they
      /// are given.
      enum class Nodes
      {
        solved,
        held
      };

      CycleContact
      compute_contact(const Eigen::VectorXd           &depth,
                      const Multibody::JointDutyCycle &cycle,
                      const CycleContact              *similar,
                      const Nodes                      nodes) const;

      Eigen::Vector2d
      force_per_length(const Multibody::JointDutyCycle &cycle,
                       const Eigen::Index               j) const;

      std::string
      unsolved_contact(const Multibody::JointDutyCycle &cycle,
                       const Eigen::Index               j,
                       const SolverReport              &report) const;

      BushingParameters          parameters;
      Multibody::JointParameters joint;
      ElasticJoint               elastic;
      Wear::WearProfile          wear_profile;
    };
  } // namespace Coupling
} // namespace Tribody

#endif
