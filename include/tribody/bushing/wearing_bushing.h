// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_bushing_wearing_bushing_h
#define tribody_bushing_wearing_bushing_h

#include <Eigen/Core>

#include <tribody/bushing/bushing_parameters.h>
#include <tribody/bushing/elastic_joint.h>
#include <tribody/bushing/warm_bushing.h>
#include <tribody/bushing/wearing_pin.h>
#include <tribody/contact/contact_solution.h>
#include <tribody/multibody/joints/joint_parameters.h>
#include <tribody/surface/bore_surface.h>
#include <tribody/surface/joint_clearance.h>
#include <tribody/surface/periodic_profile.h>
#include <tribody/wear/wear_law.h>
#include <tribody/wear/wear_profile.h>

#include <memory>
#include <mpi.h>
#include <string>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    class PinSupport;
    struct BearingLoads;
  } // namespace Multibody

  namespace Coupling
  {
    /**
     * What one duty cycle does to a bushing and its pin. A plain value. What
     * belongs to a "wearing node" has one entry per bore node, followed by one
     * per node of the pin if it wears.
     */
    struct CycleContact
    {
      /// The contact under every load, called samples: in those of this rank's
      /// share and in the peak_sample, the others are left empty.
      std::vector<Contact::ContactSolution> samples;
      /// How the pin slides in each sample.
      std::vector<Wear::Sliding> slidings;
      /// The worn bore that they belong to.
      BoreSurface surface;
      /// How the pin faces it; empty if the pin does not wear.
      PinFacings facings;
      /// Derivative of the lost area with respect to the depth at each wearing
      /// node [m].
      Eigen::VectorXd area_derivative;
      /// Cross-section area that the cycle removes at each wearing node [m^2].
      Eigen::VectorXd removed_area;
      /// Wear depth per cycle at each wearing node [m].
      Eigen::VectorXd wear_rate;
      /// Sum of force per length times sliding at each bore node [N]: in these
      /// parts friction heats it. Empty unless the joint gets warm.
      Eigen::VectorXd force_over_sliding;
      /// Largest pressure of the cycle at each bore node [Pa].
      Eigen::VectorXd peak_pressure;
      /// Index of the sample with the largest normal force.
      Eigen::Index peak_sample = 0;
      /// Largest pressure of the cycle [Pa], read as Contact::peak_pressure().
      double max_pressure = 0.;

      /// The contact in the peak_sample, which every rank has.
      const Contact::ContactSolution &
      at_peak_force() const
      {
        return samples[peak_sample];
      }
    };

    /// One of the surfaces of a joint that wear, and which of the wearing nodes
    /// are its own.
    struct WearingSurface
    {
      /// "bushing" or "pin".
      const char *name;
      /// Its first wearing node.
      Eigen::Index first_node;
      /// How many wearing nodes follow from there.
      Eigen::Index n_nodes;
      /// Its curve and how deep it is worn.
      const Wear::WearProfile &profile;
      /// By which it wears.
      const Wear::WearLaw &law;
      /// [kg/m^3].
      double density;

      /// Its part of a @p field over the wearing nodes.
      auto
      part_of(const Eigen::VectorXd &field) const
      {
        return field.segment(first_node, n_nodes);
      }
    };

    /**
     * The bushing of one joint, whose bore wears, and with it the pin if that
     * has a wear coefficient. It has the shape that it was given last; all that
     * it holds follows from that: from the depth of both surfaces, and from the
     * depth for which the compliance was computed, see ElasticJoint. A run
     * keeps these in JointState.
     *
     * Two operations make up the chain: compute_cycle_contact() turns joint
     * forces and sliding into pressure and wear per cycle, set_depth() turns
     * wear into new geometry.
     *
     * The depth is one vector: of the bore nodes and then, if the pin wears, of
     * the pin's nodes, which lie in its own frame.
     */
    class WearingBushing
    {
    public:
      /**
       * @param compliance_update change of the profile, as a fraction of the
       *   wall, after which the compliance is computed anew [-].
       * @param communicator of ranks that hold the same bushing. They share the
       *   columns of the compliance and the samples of a cycle.
       */
      WearingBushing(const BushingParameters          &parameters,
                     const Multibody::JointParameters &joint,
                     const double                      compliance_update,
                     const MPI_Comm &communicator = MPI_COMM_SELF);

      /// Of the joint that it belongs to.
      const std::string &
      name() const
      {
        return parameters.name;
      }

      /**
       * Solve the contact in every sample of @p loads for surfaces that are
       * worn by @p depth [m], and add up their wear laws over the cycle. What
       * the pin loses, it loses where it faces the bore: the area
       * @f$ P_j A_j @f$ with P of TurnedSurfaces, if its law gives @f$A_j@f$ at
       * the bore nodes in sample j.
       * @param similar the result for similar surfaces, to start from, or
       * nullptr.
       * @param sliding_distance how far the joint has slid before [m].
       * All ranks must call this together; all get the same result, but for
       * the samples.
       * @throws ExcRun on all ranks if a contact problem does not converge;
       *   names joint, sample and force.
       */
      CycleContact
      compute_cycle_contact(const Eigen::VectorXd         &depth,
                            const Multibody::BearingLoads &loads,
                            const CycleContact            *similar,
                            const double sliding_distance = 0.) const;

      /**
       * The same with the nodes of @p held in contact, sample by sample, as
       * Contact::ContactSolver::solve_held() has it: rates may be negative
       * where the wrong nodes are held. @pre @p held belongs to as many
       * samples.
       */
      CycleContact
      compute_held_contact(const Eigen::VectorXd         &depth,
                           const Multibody::BearingLoads &loads,
                           const CycleContact            &held,
                           const double sliding_distance = 0.) const;

      /// Over all samples of @p contact and all ranks, nodes that are held
      /// though they should not be, or the other way round.
      std::size_t
      count_wrong_nodes(const CycleContact &contact) const;

      /**
       * How the wear rate changes with the depth, dW/dh [per cycle]. With the
       * derivatives k of the removed areas with respect to the nodal forces
       * (diagonal, of bushing b and pin p), D of the lost areas with respect to
       * the depth, and S of Contact::ForceSensitivity,
       * @f[ \frac{dW}{dh} = -D^{-1} \sum_j
       *     \begin{pmatrix} k_b S & k_b S P^T \\
       *                     P k_p S & P k_p S P^T \end{pmatrix}_j. @f]
       * What the wear does to D and P, and what it does to the dynamics, is
       * left out. Constant coefficients are @f$ k \Delta s_j @f$; then it is
       * symmetric in the metric @f$ D/k @f$ and nowhere positive.
       * All ranks must call this together.
       */
      Eigen::MatrixXd
      compute_wear_rate_jacobian(const CycleContact &contact) const;

      /**
       * Let the surfaces be worn by @p depth [m] in all, one value per wearing
       * node.
       * @throws ExcRun if the worn geometry cannot be meshed.
       */
      void
      set_depth(const Eigen::VectorXd &depth);

      /// What computes its temperature, or nullptr if it does not get warm.
      const WarmBushing *
      warm_bushing() const
      {
        return heat.get();
      }

      /// Its clearance, modulus and wear follow; by default it is cold.
      void
      set_warmth(const Warmth &warmth);

      /// What set_warmth() was given.
      const Warmth &
      warmth() const
      {
        return warm;
      }

      /// Young's modulus of the bushing, as warm as it is [Pa].
      double
      youngs_modulus() const;

      /// Take the shape that a run has come to: surfaces worn by @p depth [m]
      /// with the compliance for @p depth_at_compliance [m], see there.
      void
      restore(const Eigen::VectorXd &depth,
              const Eigen::VectorXd &depth_at_compliance);

      /// The depth of the bore for which the compliance was computed [m].
      const Eigen::VectorXd &
      depth_at_compliance() const
      {
        return elastic.compliance_depth();
      }

      /// One value per wearing node [m].
      Eigen::VectorXd
      depth() const;

      /// The depth() after each wearing node has lost the cross-section area
      /// @p removed_area [m^2], exactly.
      Eigen::VectorXd
      depth_after_removing(const Eigen::VectorXd &removed_area) const;

      /// The bushing, and the pin if it wears. The references are to members.
      std::vector<WearingSurface>
      surfaces() const;

      /// Of the bore.
      const Wear::WearProfile &
      profile() const
      {
        return wear_profile;
      }

      /// Of the pin, or nullptr if it does not wear.
      const WearingPin *
      wearing_pin() const
      {
        return pin.get();
      }

      /// Angles of the bore nodes [rad].
      const Eigen::VectorXd &
      node_angles() const
      {
        return elastic.bore_nodes().angles;
      }

      /// Clearance between the unworn pin and the worn bore, c + h, over the
      /// angle in the bushing's frame (eq. 28). The joint is cold.
      PeriodicProfile
      clearance_profile() const;

      /// What wear has taken from the pin's radius, over the angle in the pin's
      /// frame: zero everywhere if the pin does not wear.
      PeriodicProfile
      pin_wear_profile() const;

      /// The worn, warm surfaces as the dynamics takes them. A ring without
      /// inertia in a housing follows the pin until it touches that: the pin
      /// has the gap of the housing more to go, in all directions.
      JointClearance
      clearance() const;

      /// The elasticity of pin and worn bore as the dynamics takes it.
      std::shared_ptr<const Multibody::PinSupport>
      make_support() const;

      /// The largest clearance that surfaces worn by @p depth have when they
      /// turn: where both are deepest at the same place [m]. The gap of a
      /// housing does not count, and the joint is cold.
      double
      largest_clearance(const Eigen::VectorXd &depth) const;

      /// What each of the surfaces() has lost when they are worn by @p depth
      /// [m], from their curves alone [m^3].
      std::vector<double>
      volumes_for_depth(const Eigen::VectorXd &depth) const;

      /// What wear has removed from the bushing, measured on the mesh [m^3].
      double
      worn_volume() const;

      /// What wear has removed from the pin, measured on its curve [m^3].
      double
      pin_worn_volume() const;

      /// Cycles per explicit wear step up to which it is stable, when wear goes
      /// on as in @p contact. If the pin wears, for a pin whose nodes face
      /// those of the bore.
      double
      max_stable_step(const CycleContact &contact) const;

      /// Write fields of @p contact.at_peak_force to a VTU file.
      void
      write_vtu(const std::string  &file_name,
                const CycleContact &contact) const;

      /// Thickness of the unworn wall where it is thinnest [m].
      double
      wall() const
      {
        return elastic.wall();
      }

      /// The part of the wall that a bore worn by @p depth [m] has lost where
      /// that is the largest; one: worn through [-].
      double
      lost_wall(const Eigen::VectorXd &depth) const;

      /// Cycles until a bore is worn through that goes on wearing as in
      /// @p contact; infinite without wear.
      double
      cycles_to_wear_through(const CycleContact &contact) const;

      /// Whether the compliance of the pin counts, see
      /// BushingParameters::pin_is_elastic().
      bool
      has_elastic_pin() const
      {
        return elastic.has_elastic_pin();
      }

      /// What it was made from.
      const BushingParameters &
      bushing_parameters() const
      {
        return parameters;
      }

      /// The joint whose bore and pin these are.
      const Multibody::JointParameters &
      joint_parameters() const
      {
        return joint;
      }

    private:
      /// The bore worn by its part of @p depth.
      Wear::WearProfile
      profile_for_depth(const Eigen::VectorXd &depth) const;

      /// How the nodes in contact are found: by the contact problem, or they
      /// are given.
      enum class Nodes
      {
        solved,
        held
      };

      /// The surfaces worn by @p depth over a cycle, before anything presses on
      /// them.
      CycleContact
      face_surfaces(const Eigen::VectorXd         &depth,
                    const Multibody::BearingLoads &loads,
                    const CycleContact            *similar,
                    const double                   sliding_distance) const;

      CycleContact
      compute_contact(const Eigen::VectorXd         &depth,
                      const Multibody::BearingLoads &loads,
                      const CycleContact            *similar,
                      const Nodes                    nodes,
                      const double                   sliding_distance) const;

      Eigen::Vector2d
      force_per_length(const Multibody::BearingLoads &loads,
                       const Eigen::Index             j) const;

      std::string
      unsolved_contact(const Multibody::BearingLoads &loads,
                       const Eigen::Index             j,
                       const SolverReport            &report) const;

      /// Add what sample @p j of the contact removes.
      void
      add_wear(CycleContact &contact, const Eigen::Index j) const;

      /// Subtract the derivative of what @p sample removes with respect to
      /// the depths, with S on the nodes in contact.
      void
      subtract_wear_derivative(Eigen::MatrixXd       &derivative,
                               const CycleContact    &contact,
                               const Eigen::Index     j,
                               const Eigen::MatrixXd &S) const;

      BushingParameters           parameters;
      Multibody::JointParameters  joint;
      MPI_Comm                    communicator;
      Wear::WearLaw               law;
      ElasticJoint                elastic;
      Wear::WearProfile           wear_profile;
      std::unique_ptr<WearingPin> pin;
      /// Of a joint that gets warm.
      std::unique_ptr<WarmBushing> heat;
      Warmth                       warm;
    };
  } // namespace Coupling
} // namespace Tribody

#endif
