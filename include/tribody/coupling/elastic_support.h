#ifndef tribody_coupling_elastic_support_h
#define tribody_coupling_elastic_support_h

#include <tribody/contact/contact_solver.h>
#include <tribody/multibody/pin_support.h>

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace Tribody
{
  namespace Coupling
  {
    class ElasticJoint;
    struct BushingParameters;
    struct CaseParameters;

    /**
     * Finite element contact inside the dynamics: Multibody::PinSupport by
     * Contact::ContactSolver on a worn bore, L times the plane forces. The
     * energy is @f$ \frac{L}{2} \lambda^T C \lambda @f$.
     *
     * A round pin looks the same from all sides, so that alpha has no effect.
     */
    class ElasticSupport : public Multibody::PinSupport
    {
    public:
      /// The elastic @p joint as it is worn now, which is copied.
      ElasticSupport(const ElasticJoint      &joint,
                     const BushingParameters &parameters,
                     const double             pin_radius);

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
      void
      check(const Contact::ContactSolution &solution,
            const std::string              &given) const;

      std::string name;
      double      axial_length;
      // Where the solver begins, and what was asked last: the integrator often
      // asks again.
      mutable Contact::ContactSolver                  solver;
      mutable std::optional<Contact::ContactSolution> last_touching;
      mutable std::optional<Contact::ContactSolution> last_resting;
      mutable std::optional<Eigen::Vector2d>          last_centre;
      mutable Multibody::SupportForce                 last_force;
      mutable unsigned int                            solves = 0;
    };

    /// Supports of the unworn joints whose law asks for one, by their names.
    std::map<std::string, std::shared_ptr<const Multibody::PinSupport>>
    make_unworn_supports(const CaseParameters &parameters);
  } // namespace Coupling
} // namespace Tribody

#endif
