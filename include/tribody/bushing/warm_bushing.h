// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_bushing_warm_bushing_h
#define tribody_bushing_warm_bushing_h

#include <Eigen/Core>

#include <tribody/bushing/bushing_parameters.h>
#include <tribody/bushing/elastic_joint.h>
#include <tribody/multibody/joints/joint_parameters.h>
#include <tribody/thermal/heat_conduction.h>
#include <tribody/thermal/heat_parameters.h>

#include <mpi.h>

namespace Tribody
{
  namespace Coupling
  {
    /// How warm a joint is, and how much less clearance that leaves. A plain
    /// value; the default is a joint whose temperature nobody asks for.
    struct Warmth
    {
      /// Mean power of friction in the joint [W].
      double power = 0.;
      /// The part of it that leaves through the shaft [W].
      double shaft_power = 0.;
      /// Of the surroundings, mean over the duty [K].
      double ambient_temperature = 0.;
      /// Of the bore, mean weighted with the heat that it gets [K].
      double contact_temperature = 0.;
      /// Of the bore, largest [K].
      double max_temperature = 0.;
      /// Of the bushing, mean over its cross section [K].
      double mean_temperature = 0.;
      /// Over the degrees of freedom of WarmBushing [K].
      dealii::Vector<double> temperature;
      /// By which bore and pin have come nearer since the reference
      /// temperature, mean around the bore [m]; negative where they have come
      /// apart.
      double closing = 0.;
      /// The difference between where the bore has moved most and least [m]:
      /// what an uneven heat does to its roundness, which is left out.
      double out_of_round = 0.;
      /// How far they are from temperatures that belong to motion and contact
      /// and these to them, estimated [K]: the largest.
      double residual = 0.;

      /// Whether it has been computed.
      bool
      is_known() const
      {
        return temperature.size() > 0;
      }
    };

    /// What a fixed point iteration remembers of its last step.
    struct WarmthIteration
    {
      /// By how much the contact temperature was off, with its sign [K]; 0
      /// before the first step.
      double difference = 0.;
      /// The part of it by which it was corrected [-].
      double relaxation = 1.;
    };

    /**
     * From @p warmth, whose motion and contact have the temperatures @p found,
     * a step of the fixed point iteration: x + omega (f(x) - x) with Aitken's
     * relaxation, the factor that would have made the last step exact if the
     * difference changes by the same factor each time. It is positive: where
     * the difference grows, the joint gets warmer without bound, and so does
     * this.
     */
    Warmth
    correct(const Warmth    &warmth,
            const Warmth    &found,
            WarmthIteration &iteration);

    /// What lies the @p part of the way from one to the other; its power is
    /// that of the latter.
    Warmth
    between(const Warmth &from, const Warmth &to, const double part);

    /**
     * What friction does to the temperature of a bushing and its pin, and that
     * to their clearance. The heat Q leaves through bushing and shaft,
     * @f[ Q = Q_b + G\,(T_c - T_a), \qquad T_c - T_a = \vartheta_c Q_b, @f]
     * with the conductance G of the shaft and the temperature
     * @f$\vartheta_c@f$ of the contact per power by HeatConduction: pin and
     * bore have the same temperature T_c where they touch, the pin has it
     * everywhere. Bushing and pin expand from their sizes at the reference
     * temperature, the bushing as its rim and its plane state let it, the pin
     * freely in all directions. The bore is taken to stay as round as it was:
     * what bulges under the contact is worn off first.
     */
    class WarmBushing
    {
    public:
      /// @param elastic must outlive this object.
      /// @param communicator of ranks that hold the same bushing: all of them
      ///   must compute() together, and get the same.
      WarmBushing(const BushingParameters          &parameters,
                  const Multibody::JointParameters &joint,
                  const ElasticJoint               &elastic,
                  const MPI_Comm &communicator = MPI_COMM_SELF);

      /// Of the bushing as it is worn now, from now on.
      void
      follow_geometry();

      /**
       * The temperatures, and what they do to the clearance.
       * @param heat_shape in which parts the bore nodes get the heat of the
       *   bushing, of any sum; all zero: evenly.
       * @param power Q [W].
       * @param ambient_temperature T_a [K].
       */
      Warmth
      compute(const Eigen::VectorXd &heat_shape,
              const double           power,
              const double           ambient_temperature) const;

      /// What knows where temperatures are.
      const dealii::DoFHandler<2> &
      get_dof_handler() const
      {
        return conduction.get_dof_handler();
      }

      /// What multiplies Young's modulus of the bushing [-]; one if @p warmth
      /// is not known.
      double
      modulus_factor(const Warmth &warmth) const;

      /// Likewise the friction coefficients of the joint [-].
      double
      friction_factor(const Warmth &warmth) const;

      /// Between two rounds, below which their temperatures agree [K].
      double
      tolerance() const
      {
        return heat.tolerance;
      }

    private:
      /// Above the surroundings, if @p power enters the bushing at all.
      Thermal::TemperatureRise
      compute_rise(const Eigen::VectorXd &parts, const double power) const;

      void
      set_closing(Warmth &warmth, const Thermal::TemperatureRise &rise) const;

      MPI_Comm                   communicator;
      Thermal::HeatParameters    heat;
      Material                   bushing_material;
      double                     axial_length;
      double                     pin_radius;
      double                     pin_expansion;
      const ElasticJoint        &elastic;
      Thermal::HeatConduction    conduction;
      Thermal::TemperatureFactor modulus;
      Thermal::TemperatureFactor friction;
    };
  } // namespace Coupling
} // namespace Tribody

#endif
