// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/bushing/bushing_mesh.h>
#include <tribody/stepping/coarse_run.h>

#include <cmath>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      std::deque<WearingBushing>
      make_coarse_bushings(const WearParameters             &parameters,
                           const std::deque<WearingBushing> &bushings,
                           const MPI_Comm                   &communicator)
      {
        std::deque<WearingBushing> coarse;
        for (const WearingBushing &bushing : bushings)
          if (auto coarse_parameters =
                coarsen_mesh(bushing.bushing_parameters()))
            {
              // When it ends is up to the run on the finer mesh.
              coarse_parameters->limits = {};
              coarse.emplace_back(*coarse_parameters,
                                  bushing.joint_parameters(),
                                  parameters.compliance_update,
                                  communicator);
            }
        return coarse;
      }



      double
      relative_difference(const double coarse, const double fine)
      {
        return fine > 0. ? std::abs(coarse / fine - 1.) : 0.;
      }
    } // namespace



    CoarseRun::CoarseRun(const WearParameters &parameters,
                         const WearProcess    &run,
                         const MPI_Comm       &communicator)
      : follows_whole_run(parameters.mesh_error_estimate ==
                          MeshErrorEstimate::whole_run)
      , twin(parameters,
             make_coarse_bushings(parameters, run.bushings(), communicator),
             run.wear_factors(),
             run.ambient_temperatures())
      , errors(run.bushings().size())
    {
      const std::deque<WearingBushing> &bushings = run.bushings();
      for (const WearingBushing &coarse : twin.bushings())
        for (std::size_t j = 0; j < bushings.size(); ++j)
          if (bushings[j].name() == coarse.name())
            bushing_of_run.push_back(j);
    }



    void
    CoarseRun::start(const WearProcess &run)
    {
      renew_duty_cycles(run);
      for (std::size_t c = 0; c < bushing_of_run.size(); ++c)
        {
          const std::size_t   j      = bushing_of_run[c];
          const CycleContact &fine   = run.state().joints[j].contact;
          const CycleContact &coarse = twin.state().joints[c].contact;
          MeshError          &error  = errors[j];
          error.n_nodes              = run.bushings()[j].node_angles().size();
          error.n_coarse_nodes       = twin.bushings()[c].node_angles().size();
          error.max_pressure =
            relative_difference(coarse.max_pressure, fine.max_pressure);
          error.wear_depth = relative_difference(coarse.wear_rate.maxCoeff(),
                                                 fine.wear_rate.maxCoeff());
        }
    }



    void
    CoarseRun::renew_duty_cycles(const WearProcess &run)
    {
      twin.renew_duty_cycles(run.state().duty_cycles, run.state().shares);
      twin.solve_contacts();
      // The motion is that of the run.
      twin.settle_warmth([]() {});
    }



    void
    CoarseRun::restore(const RunState               &state,
                       const std::vector<MeshError> &errors_so_far)
    {
      twin.restore(state);
      errors = errors_so_far;
    }



    std::vector<RunState>
    CoarseRun::state() const
    {
      if (!follows_whole_run || twin.bushings().empty())
        return {};
      return {twin.state()};
    }



    void
    CoarseRun::follow(const WearProcess &run)
    {
      if (!follows_whole_run || twin.bushings().empty())
        return;
      renew_duty_cycles(run);
      while (twin.state().cycles < run.state().cycles &&
             twin.state().stopped_by.empty())
        {
          const double begin = twin.state().cycles;
          twin.take_step(run.state().cycles);
          twin.complete_step(begin);
        }
      for (std::size_t c = 0; c < bushing_of_run.size(); ++c)
        {
          MeshError &error       = errors[bushing_of_run[c]];
          error.covers_whole_run = true;
          // One that is worn through before the other has stopped there.
          error.wear_depth = relative_difference(
            twin.bushings()[c].profile().max_depth() / twin.state().cycles,
            run.bushings()[bushing_of_run[c]].profile().max_depth() /
              run.state().cycles);
        }
    }
  } // namespace Coupling
} // namespace Tribody
