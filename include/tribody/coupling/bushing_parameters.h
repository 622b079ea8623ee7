#ifndef tribody_coupling_bushing_parameters_h
#define tribody_coupling_bushing_parameters_h

#include <tribody/contact/contact_solver_parameters.h>
#include <tribody/elasticity/ring_mesh.h>
#include <tribody/output/summary.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Multibody
  {
    struct JointParameters;
  }

  namespace Coupling
  {
    /// When the life of a bushing is over; zero: no limit.
    struct BushingLimits
    {
      /// Maximum wear depth [m].
      double max_depth = 0.;
      /// Largest clearance between pin and worn bore [m].
      double clearance = 0.;
      /// Worn volume [m^3].
      double volume = 0.;
      /// Worn mass [kg].
      double mass = 0.;
    };

    /**
     * The bushing of a revolute joint with clearance, as a body that deforms
     * and wears. Its bore radius and its material are the joint's.
     */
    struct BushingParameters
    {
      /// Name of the joint that the bushing belongs to.
      std::string name;
      /// Length along the axis of the joint [m].
      double axial_length = 10e-3;
      /// Radius of the rim, by which it is held [m].
      double outer_radius = 16e-3;
      /// "plane strain" or "plane stress".
      std::string plane_state = "plane strain";
      /// "finite element", "infinite plate" or "Winkler layer".
      std::string pressure_model = "finite element";
      /// Polynomial degree of the elements.
      unsigned int element_degree = 2;
      /// How finely it is meshed.
      Elasticity::RingMeshParameters mesh;
      /// "automatic", "rigid" or "elastic".
      std::string pin = "automatic";
      /// Radius of the hole in the pin [m]; 0: none.
      double pin_hole_radius = 0.;
      /// When the contact problem counts as solved.
      Contact::ContactSolverParameters contact_solver;
      /// Archard's k [Pa^-1].
      double        wear_coefficient = 0.;
      BushingLimits limits;
      /// Values that the results are shown beside.
      Output::Comparison comparison;

      /// Declares in the current subsection, "Bushing <name>".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @param joint that the bushing belongs to.
      /// @throws ExcParameter with paths that start with "Bushing <name>".
      void
      check(const Multibody::JointParameters &joint) const;

      /// Whether the pin of @p joint is elastic: if asked for, or if its
      /// modulus is not more than 100 times the bushing's.
      bool
      pin_is_elastic(const Multibody::JointParameters &joint) const;
    };
  } // namespace Coupling
} // namespace Tribody

#endif
