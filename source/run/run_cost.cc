// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <tribody/base/interruption.h>
#include <tribody/base/significant_digits.h>
#include <tribody/run/run_cost.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // Implicit wear steps of a run: the shipped cases take 5 to 25.
      constexpr double usual_n_steps = 12.;
      // Steps are measured for that long [s], or one step.
      constexpr double measuring_time = 1.;
      // What is long [s].
      constexpr double one_hour = 3600.;



      struct PartTimes
      {
        double motion = 0., wear = 0.;
      };

      PartTimes
      times_of(const WearSimulation &simulation)
      {
        PartTimes times;
        for (const auto &[part, seconds] : simulation.times_of_parts())
          (part == "dynamics" ? times.motion : times.wear) += seconds;
        return times;
      }



      double
      count_steps(const CaseParameters &parameters)
      {
        const double          n_outputs = parameters.n_outputs - 1.;
        const WearParameters &wear      = parameters.wear;
        if (wear.extrapolation == Extrapolation::one_shot)
          return n_outputs;
        if (wear.extrapolation == Extrapolation::constant &&
            wear.cycles_per_step > 0.)
          return std::max(n_outputs, parameters.cycles / wear.cycles_per_step);
        return std::max(n_outputs, usual_n_steps);
      }



      std::string
      duration(const double seconds)
      {
        const auto in = [&](const double unit, const char *name) {
          return significant_digits(seconds / unit, 2) + name;
        };
        if (seconds < 120.)
          return in(1., " s");
        if (seconds < 2. * one_hour)
          return in(60., " min");
        if (seconds < 48. * one_hour)
          return in(one_hour, " h");
        return in(24. * one_hour, " days");
      }



      // The parameters that would make a long run shorter.
      std::string
      reason(const RunCost &cost, const CaseParameters &parameters)
      {
        if (cost.n_left > 10. * usual_n_steps)
          return "the number of wear steps: choose 'Wear/Extrapolation = "
                 "implicit', which chooses their lengths by the error, or more "
                 "'Wear/Cycles per step'";
        if (cost.step_motion > cost.step_wear || cost.n_measured == 0.)
          {
            if (parameters.dynamics.joint_motion ==
                Multibody::JointMotion::dynamic)
              return "the integration of the motion: 'Dynamics/Joint motion = "
                     "automatic' integrates it only where pins do not follow "
                     "their bores";
            return "the motion: fewer 'Dynamics/Maximum settling cycles' or a "
                   "larger 'Dynamics/Accuracy' shorten it, and the error that "
                   "is stated grows";
          }
        const auto finest =
          std::max_element(parameters.bushings.begin(),
                           parameters.bushings.end(),
                           [](const auto &a, const auto &b) {
                             return a.mesh.n_bore_cells < b.mesh.n_bore_cells;
                           });
        return "the contacts: fewer 'Bushing " + finest->name +
               "/Mesh/Bore cells' (now " +
               std::to_string(finest->mesh.n_bore_cells) +
               ") or 'Dynamics/Samples per cycle' (now " +
               std::to_string(parameters.dynamics.samples_per_cycle) +
               ") shorten it";
      }
    } // namespace



    double
    RunCost::total() const
    {
      return first_cycle + (n_measured + n_left) * (step_motion + step_wear);
    }



    RunCost
    measure_cost(WearSimulation                     &simulation,
                 const CaseParameters               &parameters,
                 const std::chrono::duration<double> patience,
                 const MPI_Comm                     &communicator)
    {
      std::optional<TimeLimit> limit;
      if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
        limit.emplace(patience);
      RunCost   cost;
      PartTimes first;
      try
        {
          simulation.start();
          first            = times_of(simulation);
          cost.first_cycle = first.motion + first.wear;
          while (!simulation.is_over())
            {
              simulation.advance(parameters.cycles);
              ++cost.n_measured;
              const PartTimes now = times_of(simulation);
              cost.step_motion = (now.motion - first.motion) / cost.n_measured;
              cost.step_wear   = (now.wear - first.wear) / cost.n_measured;
              if (cost.n_measured * (cost.step_motion + cost.step_wear) >
                  measuring_time)
                break;
            }
        }
      catch (const ExcTimeLimit &)
        {
          cost.is_bound = true;
          if (cost.first_cycle == 0.)
            cost.first_cycle = patience.count();
          // At least that part of a step, each step has.
          const PartTimes now = times_of(simulation);
          if (cost.n_measured == 0.)
            {
              cost.step_motion = now.motion - first.motion;
              cost.step_wear   = now.wear - first.wear;
            }
        }
      if (parameters.cycles > 0 && !simulation.is_over())
        cost.n_left = std::max(1., count_steps(parameters) - cost.n_measured);
      return cost;
    }



    void
    print_cost(std::ostream         &out,
               const RunCost        &cost,
               const CaseParameters &parameters)
    {
      const std::string about = cost.is_bound ? "more than " : "about ";
      out << "Time: " << about << duration(cost.total()) << " (";
      if (parameters.cycles == 0)
        out << "the motion";
      else
        out << "the first cycle " << duration(cost.first_cycle)
            << ", a wear step " << duration(cost.step_motion + cost.step_wear)
            << ", of which the motion " << duration(cost.step_motion)
            << "; about " << std::lround(cost.n_measured + cost.n_left)
            << " steps";
      out << ')' << std::endl;
      if (cost.total() > one_hour)
        out << "WARNING: most of that time goes into "
            << reason(cost, parameters) << '.' << std::endl;
    }
  } // namespace Coupling
} // namespace Tribody
