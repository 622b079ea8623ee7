// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_bushing_bushing_parameters_h
#define tribody_bushing_bushing_parameters_h

#include <tribody/base/choice.h>
#include <tribody/bushing/joint_limits.h>
#include <tribody/contact/contact_solver_parameters.h>
#include <tribody/elasticity/mesh_file.h>
#include <tribody/elasticity/plane_state.h>
#include <tribody/elasticity/rim_shape.h>
#include <tribody/elasticity/rim_support.h>
#include <tribody/elasticity/ring_mesh.h>
#include <tribody/thermal/heat_parameters.h>
#include <tribody/wear/wear_coefficient.h>
#include <tribody/wear/wear_law.h>

#include <string>
#include <vector>

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
    /// How a bushing gives way to the pin.
    enum class PressureModel
    {
      finite_element,
      infinite_plate,
      winkler_layer
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<PressureModel>
    choice_names(const PressureModel)
    {
      return {{PressureModel::finite_element, "finite element"},
              {PressureModel::infinite_plate, "infinite plate"},
              {PressureModel::winkler_layer, "Winkler layer"}};
    }

    /// How displacements are found from forces: by a factorisation that every
    /// rank has, or by iterations on cells that the ranks share.
    enum class StiffnessSolver
    {
      direct,
      multigrid
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<StiffnessSolver>
    choice_names(const StiffnessSolver)
    {
      return {{StiffnessSolver::direct, "direct"},
              {StiffnessSolver::multigrid, "multigrid"}};
    }

    /// Whether the pin deforms; automatic: if it is not much stiffer than the
    /// bushing.
    enum class PinModel
    {
      automatic,
      rigid,
      elastic
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<PinModel>
    choice_names(const PinModel)
    {
      return {{PinModel::automatic, "automatic"},
              {PinModel::rigid, "rigid"},
              {PinModel::elastic, "elastic"}};
    }

    /// A published or measured value that a result is shown beside.
    struct Comparison
    {
      /// What it is and where it comes from; empty if there is none.
      std::string source;
      /// [m]; zero if not given.
      double max_wear_depth = 0.;
      /// [kg]; zero if not given.
      double worn_mass = 0.;
    };

    /**
     * The bushing of a revolute joint with clearance, as a body that deforms
     * and wears. Its bore radius and its material are the joint's.
     */
    struct BushingParameters
    {
      /// Name of the joint that the bushing belongs to.
      std::string name;
      /// Loads from elsewhere; empty: those of the mechanism.
      std::string duty_cycle_file;
      /// Length along the axis of the joint [m].
      double axial_length = 10e-3;
      /// Radius of the rim, or its semi-axis along x [m].
      double outer_radius = 16e-3;
      /// Circle or ellipse, and where its centre is.
      Elasticity::RimShape rim_shape;
      /// What holds it there.
      Elasticity::RimSupport rim_support;
      /// Of bushing and elastic pin.
      Elasticity::PlaneState plane_state = Elasticity::PlaneState::strain;
      /// By what pressure is computed from the position of the pin.
      PressureModel pressure_model = PressureModel::finite_element;
      /// Polynomial degree of the elements.
      unsigned int element_degree = 2;
      /// How displacements are found in the model "finite element".
      StiffnessSolver stiffness_solver = StiffnessSolver::direct;
      /// How finely it is meshed.
      Elasticity::RingMeshParameters mesh;
      /// Instead of a ring, if there is one.
      Elasticity::MeshFile mesh_file;
      /// Whether the pin deforms too, see pin_is_elastic().
      PinModel pin = PinModel::automatic;
      /// Radius of the hole in the pin [m]; 0: none.
      double pin_hole_radius = 0.;
      /// When the contact problem counts as solved.
      Contact::ContactSolverParameters contact_solver;
      /// Of the bushing as given [Pa^-1]; Archard's k is in wear_law().
      double wear_coefficient = 0.;
      /// File with k(p, v) instead, see Wear::CoefficientTable; empty: none.
      std::string wear_coefficient_table;
      /// What the coefficient was measured as.
      Wear::CoefficientBasis wear_coefficient_basis =
        Wear::CoefficientBasis::local;
      /// Archard's k of the pin [Pa^-1]; 0: it does not wear.
      double pin_wear_coefficient = 0.;
      /// What multiplies that of the bushing: an expression of p, v and s, see
      /// Wear::FactorExpression.
      std::string wear_coefficient_factor = "1";
      /// The same for that of the pin.
      std::string pin_wear_coefficient_factor = "1";
      /// Running-in of both surfaces, see Wear::RunningIn: f_0 [-].
      double running_in_factor = 1.;
      /// s_0 of both surfaces [m]; 0: no running-in.
      double running_in_distance = 0.;
      /// At which the run ends, one per entry of joint_limits(), in SI units;
      /// 0: none.
      std::vector<double> limits = std::vector<double>(joint_limits().size());
      /// How it gets warm, and what that changes.
      Thermal::HeatParameters heat;
      /// Values that the results are shown beside.
      Comparison comparison;

      /// Declares in the current subsection, "Bushing <name>".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @param joint that the bushing belongs to.
      /// @throws ExcParameter with paths that start with "Bushing <name>".
      void
      check(const Multibody::JointParameters &joint) const;

      /// Whether the ranks share the cells of the mesh.
      bool
      shares_mesh() const
      {
        return stiffness_solver == StiffnessSolver::multigrid;
      }

      /// Whether mesh and geometry look the same from each cell around the
      /// bore, unworn.
      bool
      cells_are_alike() const;

      /// The law by which the bushing wears.
      Wear::WearLaw
      wear_law() const;

      /// The law by which the pin wears; without a coefficient it takes
      /// nothing.
      Wear::WearLaw
      pin_wear_law() const;

      /// Whether the pin of @p joint is elastic: if asked for, or if its
      /// modulus is not more than 100 times the bushing's.
      bool
      pin_is_elastic(const Multibody::JointParameters &joint) const;

    private:
      /// A table is no second coefficient.
      void
      check_table() const;

      /// Not negative, and not passed by the new joint.
      void
      check_limits(const Multibody::JointParameters &joint) const;

      /// Temperatures where something depends on them, and only where they can
      /// be computed.
      void
      check_heat(const Multibody::JointParameters &joint) const;

      /// A ring in a housing is not everything at once.
      void
      check_housing(const Multibody::JointParameters &joint) const;

      void
      check_mesh(const Multibody::JointParameters &joint) const;

      /// @param parameter that holds the @p factor.
      Wear::WearLaw
      make_wear_law(const double       coefficient,
                    const std::string &factor,
                    const std::string &parameter) const;
    };
  } // namespace Coupling
} // namespace Tribody

#endif
