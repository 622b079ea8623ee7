// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/significant_digits.h>
#include <tribody/base/units.h>
#include <tribody/results/rating.h>
#include <tribody/results/warnings.h>

#include <algorithm>
#include <utility>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // Parts beyond which a number is doubtful.
      constexpr double largest_error        = 0.1;
      constexpr double largest_oscillation  = 0.1;
      constexpr double largest_energy_error = 0.01;
      // From the next coarser mesh: about three times the error.
      constexpr double largest_pressure_change = 0.3;



      std::string
      percent(const double part)
      {
        return significant_digits(100. * part, 2) + " %";
      }



      // What to do about the largest part of the error of the depth.
      std::string
      advise(const BushingResults &bushing)
      {
        const DutyErrors &duty  = bushing.duty_errors;
        const std::string joint = "'Joint " + bushing.name + "/";
        const std::vector<std::pair<double, std::string>> parts = {
          {bushing.step_error(),
           "the wear steps: choose 'Wear/Extrapolation = implicit', or shorten "
           "them by 'Wear/Tolerance' or 'Wear/Cycles per step'"},
          {bushing.mesh_error,
           "the mesh: refine it by 'Bushing " + bushing.name +
             "/Mesh/Bore cells'"},
          {duty.sampling,
           "the samples: take more by 'Dynamics/Samples per cycle'"},
          {duty.inertia,
           "the inertia of pins that follow their bores: choose "
           "'Dynamics/Joint motion = dynamic'"},
          {duty.settling,
           "a motion that has not settled: raise 'Dynamics/Maximum settling "
           "cycles' or 'Dynamics/Averaged cycles'"},
          {duty.integration,
           "the integration: choose a smaller 'Dynamics/Accuracy'"},
          {duty.creep,
           "sliding that is slower than the friction law is right for: lower " +
             joint + "Friction regularisation speed'"}};
        return std::max_element(parts.begin(), parts.end())->second;
      }



      std::string
      in_load_case(const std::string &load_case)
      {
        return load_case.empty() ? "" : "in load case " + load_case + " ";
      }



      // What the material of a bushing does not endure; a limit of zero is
      // none.
      void
      warn_of_limit(const std::string    &joint,
                    const char           *code,
                    const std::string    &quantity,
                    const double          value,
                    const double          limit,
                    const char           *si_unit,
                    const char           *shown_unit,
                    std::vector<Warning> &warnings)
      {
        const auto shown = [&](const double number) {
          return Units::to_string(number, si_unit, shown_unit, 4);
        };
        if (limit > 0. && value > limit)
          warnings.push_back(
            {code,
             joint,
             quantity + " is " + shown(value) +
               ", more than the material of the bushing endures, " +
               shown(limit) +
               ": its wear coefficient does not hold there. It takes a larger "
               "bushing, less load or speed, or another material"});
      }



      void
      warn_of_bushing(const CaseParameters &parameters,
                      const BushingResults &bushing,
                      const RunResults     &results,
                      std::vector<Warning> &warnings)
      {
        const RunState &state   = results.state;
        const Strains  &strains = state.joints[bushing.number].totals.strains;
        if (strains.largest() > Strains::doubtful)
          warnings.push_back({"strains", bushing.name, describe(strains)});
        const Material &material =
          parameters.joint(bushing.name).bushing_material;
        if (const Warmth &warmth = state.joints[bushing.number].warmth;
            warmth.is_known())
          {
            warn_of_limit(bushing.name,
                          "temperature_limit",
                          "the largest temperature of the bore",
                          state.joints[bushing.number].totals.max_temperature,
                          material.limits.temperature,
                          "K",
                          "degC",
                          warnings);
            // What is left out must be worn off, or little beside the
            // clearance.
            constexpr double part_of_clearance = 0.1;
            const double     depth             = bushing.bushing.max_wear_depth;
            const double     unworn =
              std::max(0., bushing.clearance - depth - warmth.closing);
            if (warmth.out_of_round > depth + part_of_clearance * unworn)
              warnings.push_back(
                {"out_of_round",
                 bushing.name,
                 "uneven heat makes the bore out of round by " +
                   significant_digits(1e3 * warmth.out_of_round, 2) +
                   " mm, more than has been worn off and than a tenth of the "
                   "clearance; this is left out, so that pressure and depth "
                   "are doubtful until as much is worn off: it takes more "
                   "cycles, less friction, load or speed, or a material that "
                   "conducts heat better"});
          }
        const std::string refine =
          "refine 'Bushing " + bushing.name + "/Mesh/Bore cells'";
        if (bushing.mesh_oscillation > largest_oscillation)
          warnings.push_back(
            {"oscillation",
             bushing.name,
             "the wear rate changes from node to node by " +
               percent(bushing.mesh_oscillation) +
               ", and pressures and depths may be wrong by as much: " + refine +
               (parameters.wear.extrapolation == Extrapolation::implicit
                  ? ""
                  : ", or shorten the wear steps")});
        if (bushing.number < state.mesh_errors.size() &&
            state.mesh_errors[bushing.number].max_pressure >
              largest_pressure_change)
          warnings.push_back(
            {"pressure",
             bushing.name,
             "the largest pressure may be wrong by " +
               percent(state.mesh_errors[bushing.number].max_pressure) +
               ", as much as it differs on the next coarser mesh: " + refine});
        if (bushing.depth_relative_error() > largest_error)
          warnings.push_back({"depth",
                              bushing.name,
                              "the depth may be wrong by " +
                                percent(bushing.depth_relative_error()) +
                                ", most of it by " + advise(bushing)});
      }



      void
      warn_of_rating(const CaseParameters            &parameters,
                     const BushingParameters         &bushing,
                     const std::string               &load_case,
                     const double                     period,
                     const Multibody::JointDutyCycle &loads,
                     std::vector<Warning>            &warnings)
      {
        const Multibody::JointParameters &joint =
          parameters.joint(bushing.name);
        const MaterialLimits &limits = joint.bushing_material.limits;
        const Rating          rating = rate(loads, period, bushing, joint);
        const std::string     where  = in_load_case(load_case);
        warn_of_limit(bushing.name,
                      "pressure_limit",
                      where + "the largest projected pressure",
                      rating.max_pressure,
                      limits.pressure,
                      "Pa",
                      "MPa",
                      warnings);
        warn_of_limit(bushing.name,
                      "speed_limit",
                      where + "the largest sliding speed",
                      rating.max_speed,
                      limits.speed,
                      "m/s",
                      "m/s",
                      warnings);
        warn_of_limit(bushing.name,
                      "pv_limit",
                      where + "the mean of projected pressure times speed",
                      rating.mean_pv,
                      limits.pv,
                      "Pa m/s",
                      "MPa m/s",
                      warnings);
      }



      // Joints that creep instead of being held.
      void
      warn_of_creep(const Multibody::JointDutyCycle &joint,
                    const std::string               &load_case,
                    std::vector<Warning>            &warnings)
      {
        if (joint.creep_distance > 0.)
          warnings.push_back(
            {"held_by_friction",
             joint.name,
             in_load_case(load_case) +
               "friction holds this joint: all of its " +
               significant_digits(1e3 * joint.creep_distance, 2) + " mm" +
               " per cycle is creep of the friction law, which is smooth at "
               "rest, and does not count as sliding; nothing wears. If it does "
               "slide that slowly, lower 'Joint " +
               joint.name +
               "/Friction regularisation speed' below a third of its speed"});
      }



      void
      warn_of_motion(const CaseParameters &parameters,
                     const RunState       &state,
                     std::vector<Warning> &warnings)
      {
        if (!state.dynamics.all_settled)
          warnings.push_back(
            {"not_settled",
             "",
             std::string(parameters.cycles > 0
                           ? "not every duty cycle "
                             "settled: "
                           : "the motion has not settled: ") +
               state.dynamics.unsettled_message +
               ". Forces may be wrong by as much; raise 'Dynamics/Maximum "
               "settling cycles' if the motion is to repeat"});
        for (const Multibody::DutyCycle &cycle : state.duty_cycles)
          if (cycle.energy.cycle.has_work &&
              cycle.energy.relative_error > largest_energy_error)
            warnings.push_back(
              {"energy",
               "",
               "the energies of the recorded cycle miss their balance by " +
                 percent(cycle.energy.relative_error) +
                 " of the largest, and forces may be wrong by as much: choose "
                 "a smaller 'Dynamics/Accuracy'"});
      }
    } // namespace



    std::vector<Warning>
    find_warnings(const CaseParameters &parameters, const RunResults &results)
    {
      const RunState      &state = results.state;
      std::vector<Warning> warnings;
      for (std::size_t j = 0; !state.duty_cycles.empty() &&
                              j < state.duty_cycles.front().joints.size();
           ++j)
        {
          for (std::size_t i = 0; i < state.duty_cycles.size(); ++i)
            warn_of_creep(state.duty_cycles[i].joints[j],
                          parameters.load_cases[i].name,
                          warnings);
          const std::string &name = state.duty_cycles.front().joints[j].name;
          if (const BushingResults *bushing = results.bushing(name))
            warn_of_bushing(parameters, *bushing, results, warnings);
          if (const BushingParameters *bushing = parameters.bushing(name))
            for (std::size_t i = 0; i < state.duty_cycles.size(); ++i)
              warn_of_rating(parameters,
                             *bushing,
                             parameters.load_cases[i].name,
                             state.duty_cycles[i].period,
                             state.duty_cycles[i].joints[j],
                             warnings);
        }
      warn_of_motion(parameters, state, warnings);
      if (state.unstable_step_reported)
        warnings.push_back(
          {"unstable_steps",
           "",
           "'Wear/Cycles per step' is longer than explicit steps are stable "
           "for on this mesh, about " +
             significant_digits(state.stepper.max_stable_step, 3) +
             " cycles: pressures and depths oscillate from node to node. "
             "Choose shorter steps, a coarser mesh, or 'Wear/Extrapolation = "
             "implicit'"});
      // Before the first step it may not have been looked for.
      if (parameters.wear.mesh_error_estimate != MeshErrorEstimate::none &&
          !results.bushings.empty() && state.cycles > 0. &&
          state.mesh_errors.empty())
        warnings.push_back(
          {"no_mesh_error",
           "",
           "the error of the mesh is not known, as the next coarser one "
           "fails: compare with 'Mesh/Bore cells' of your own"});
      return warnings;
    }
  } // namespace Coupling
} // namespace Tribody
