// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/bushing/bushing_mesh.h>
#include <tribody/stepping/coarse_run.h>
#include <tribody/stepping/make_jump.h>

#include <cmath>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      std::list<WearingBushing>
      make_coarse_bushings(const WearParameters            &parameters,
                           const std::list<WearingBushing> &bushings)
      {
        std::list<WearingBushing> coarse;
        for (const WearingBushing &bushing : bushings)
          if (auto coarse_parameters =
                coarsen_mesh(bushing.bushing_parameters()))
            {
              // When it ends is up to the run on the finer mesh.
              coarse_parameters->limits = {};
              coarse.emplace_back(*coarse_parameters,
                                  bushing.joint_parameters(),
                                  parameters.compliance_update);
            }
        return coarse;
      }



      double
      relative_difference(const double coarse, const double fine)
      {
        return fine > 0. ? std::abs(coarse / fine - 1.) : 0.;
      }



      const WearingBushing *
      find(const std::list<WearingBushing> &bushings, const std::string &name)
      {
        for (const WearingBushing &bushing : bushings)
          if (bushing.name() == name)
            return &bushing;
        return nullptr;
      }
    } // namespace



    CoarseRun::CoarseRun(const WearParameters            &parameters,
                         const std::list<WearingBushing> &bushings)
      : follows_whole_run(parameters.mesh_error_estimate ==
                          MeshErrorEstimate::whole_run)
      , coarse(make_coarse_bushings(parameters, bushings))
      , no_conditions(coarse)
      , jump(coarse.empty() ? nullptr
                            : make_jump(parameters, coarse, no_conditions))
      , errors(bushings.size())
    {
      state.totals.resize(coarse.size());
    }



    void
    CoarseRun::start(const RunState                  &fine_state,
                     const std::list<WearingBushing> &bushings)
    {
      state.duty_cycle = fine_state.duty_cycle;
      state.cycles     = fine_state.cycles;
      solve_contacts();

      std::size_t b = 0, c = 0;
      for (const WearingBushing &bushing : bushings)
        {
          if (const WearingBushing *twin = find(coarse, bushing.name()))
            {
              const CycleContact &fine_contact   = fine_state.contacts[b];
              const CycleContact &coarse_contact = state.contacts[c];
              MeshError          &error          = errors[b];
              error.n_nodes                      = bushing.node_angles().size();
              error.n_coarse_nodes               = twin->node_angles().size();
              error.max_pressure =
                relative_difference(coarse_contact.max_pressure,
                                    fine_contact.max_pressure);
              error.wear_depth =
                relative_difference(coarse_contact.wear_rate.maxCoeff(),
                                    fine_contact.wear_rate.maxCoeff());
              ++c;
            }
          ++b;
        }
    }



    void
    CoarseRun::follow(const Multibody::DutyCycle &cycle, const double end)
    {
      if (!follows_whole_run || coarse.empty())
        return;
      state.duty_cycle = cycle;
      solve_contacts();
      while (state.cycles < end)
        {
          const double begin = state.cycles;
          jump->advance(state, end);
          std::size_t b = 0;
          for (const WearingBushing &bushing : coarse)
            state.totals[b++].sliding_distance +=
              (state.cycles - begin) *
              cycle.joint(bushing.name()).sliding_distance();
          solve_contacts();
          // By which it chooses its next step.
          jump->estimate_error(state.contacts, state.cycles - begin);
        }
    }



    const std::vector<MeshError> &
    CoarseRun::compare(const std::list<WearingBushing> &bushings)
    {
      if (!follows_whole_run || state.cycles == 0.)
        return errors;
      std::size_t b = 0;
      for (const WearingBushing &bushing : bushings)
        {
          if (const WearingBushing *twin = find(coarse, bushing.name()))
            {
              errors[b].covers_whole_run = true;
              errors[b].wear_depth =
                relative_difference(twin->profile().max_depth(),
                                    bushing.profile().max_depth());
            }
          ++b;
        }
      return errors;
    }



    void
    CoarseRun::solve_contacts()
    {
      std::vector<CycleContact> contacts;
      for (const WearingBushing &bushing : coarse)
        {
          const std::size_t   b = contacts.size();
          const CycleContact *similar =
            b < state.contacts.size() ? &state.contacts[b] : nullptr;
          contacts.push_back(bushing.compute_cycle_contact(
            bushing.depth(),
            state.duty_cycle.joint(bushing.name()),
            similar,
            state.totals[b].sliding_distance));
        }
      state.contacts = contacts;
    }
  } // namespace Coupling
} // namespace Tribody
