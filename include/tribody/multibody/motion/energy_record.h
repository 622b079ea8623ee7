// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_motion_energy_record_h
#define tribody_multibody_motion_energy_record_h

#include <Eigen/Core>

#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * Energies of a mechanism at one instant [J]. What was exchanged counts
     * from the start of the motion or, after since(), from another record.
     * Then
     * @f[ W_{drivers} + W_{forces} = \Delta T + \Delta V + \Delta U + D @f]
     * with the kinetic energy T, the potential energy V of gravity and springs,
     * the energy U stored in contacts, and the losses D in dampers,
     * contacts and impacts.
     */
    struct EnergyRecord
    {
      /// T.
      double kinetic = 0.;
      /// V, of gravity and springs.
      double potential = 0.;
      /// Whether the entries below are known.
      bool has_work = false;
      /// Work of the drivers on the mechanism.
      double driver_work = 0.;
      /// Work of the forces that are given as functions of time.
      double force_work = 0.;
      /// Lost in the dampers of springs.
      double damper_loss = 0.;
      /// Lost where velocities jump.
      double impact_loss = 0.;
      /// For each joint with a contact law: the work of the normal force that a
      /// penetration without rate would give, which comes back.
      Eigen::VectorXd contact_energy;
      /// Likewise what the normal force takes beyond that.
      Eigen::VectorXd normal_loss;
      /// Likewise what friction and tangential damping take.
      Eigen::VectorXd friction_loss;

      /// Of drivers and forces.
      double
      work() const;

      /// In dampers, contacts and impacts.
      double
      dissipated() const;

      /// What remains of the balance, which is zero for an exact motion; for
      /// the result of since().
      double
      balance_error() const;

      /// The largest of the terms of the balance, without its sign; for the
      /// result of since().
      double
      largest_term() const;

      /// Changes since @p earlier.
      EnergyRecord
      since(const EnergyRecord &earlier) const;
    };

    /// @p error of a balance, relative to its largest @p term, or to what
    /// roundings leave of the largest @p kinetic energy, if that is more: a
    /// motion that exchanges nothing has nothing but roundings in its balance.
    /// All in J.
    double
    relative_to_exchange(const double error,
                         const double term,
                         const double kinetic);

    /// Largest error of the balance among @p changes (results of since() one
    /// earlier record), relative to the largest term that occurs among them or
    /// to what roundings leave of @p kinetic, the largest kinetic energy [J].
    double
    balance_relative_error(const std::vector<EnergyRecord> &changes,
                           const double                     kinetic);
  } // namespace Multibody
} // namespace Tribody

#endif
