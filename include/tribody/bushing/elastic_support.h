// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_bushing_elastic_support_h
#define tribody_bushing_elastic_support_h

#include <tribody/contact/contact_solver.h>
#include <tribody/multibody/joints/pin_support.h>
#include <tribody/surface/periodic_profile.h>

#include <memory>
#include <optional>
#include <string>

namespace Tribody
{
  namespace Coupling
  {
    class ElasticJoint;
    struct BushingParameters;

    /**
     * Finite element contact inside the dynamics: Multibody::PinSupport by
     * Contact::ContactSolver on a worn bore, L times the plane forces. The
     * energy is @f$ \frac{L}{2} \lambda^T C \lambda @f$.
     *
     * A worn pin recedes by @f$ r_i(\alpha) = h_p(\psi_i - \alpha) @f$ where it
     * faces node i (@f$\psi_i@f$ as in TurnedSurfaces), with the spline that
     * the dynamics sees for @f$h_p@f$: it is twice differentiable, and costs
     * less than the projection of the wear, from which it differs by the error
     * of interpolation on the pin's nodes. A round pin looks the same from all
     * sides.
     */
    class ElasticSupport : public Multibody::PinSupport
    {
    public:
      /// The elastic @p joint as it is worn now, which is copied.
      /// @param pin_radius as manufactured [m]. @param pin_wear what it has
      ///   lost, over the angle in the pin's frame. @param closing by which
      ///   pin and bore are nearer, as they are warm [m].
      ElasticSupport(const ElasticJoint      &joint,
                     const BushingParameters &parameters,
                     const double             pin_radius,
                     const PeriodicProfile   &pin_wear = PeriodicProfile(0.),
                     const double             closing  = 0.);

      Multibody::SupportForce
      compute_force(const Eigen::Vector2d &e,
                    const double           alpha) const override;

      Eigen::Vector2d
      find_position(const Eigen::Vector2d &force,
                    const double           alpha) const override;

      /// Contact problems solved so far; questions asked twice count once.
      unsigned int
      n_solves() const
      {
        return solves;
      }

    private:
      /// The recess with its derivatives by alpha; empty for a round pin.
      struct Recess
      {
        Eigen::VectorXd value;
        Eigen::VectorXd slope;
        Eigen::VectorXd curvature;
      };

      Recess
      compute_recess(const double alpha) const;

      void
      check(const Contact::ContactSolution &solution,
            const std::string              &given) const;

      std::string     name;
      double          axial_length;
      PeriodicProfile pin_wear;
      Eigen::VectorXd facing_angles;
      double          closing;
      // Where the solver begins, and what was asked last: the integrator often
      // asks again.
      mutable Contact::ContactSolver                  solver;
      mutable std::optional<Contact::ContactSolution> last_touching;
      mutable std::optional<Contact::ContactSolution> last_resting;
      mutable std::optional<Eigen::Vector3d>          last_place;
      mutable Multibody::SupportForce                 last_force;
      mutable unsigned int                            solves = 0;
    };
  } // namespace Coupling
} // namespace Tribody

#endif
