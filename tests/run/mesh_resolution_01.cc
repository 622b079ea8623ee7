// SPDX-License-Identifier: LGPL-2.1-or-later

// Meshes chosen by the nodes across the contact, and the estimate of their
// error. A tight joint (arc of 125 degrees) and a loose one (10 degrees), under
// forces of which the largest decides. Known:
// - As many nodes are in contact as were asked for, within the twentieth to
//   which the arc is known and one node on each side.
// - The errors against a mesh with 160 nodes across the contact fall with the
//   number of nodes; the estimate, which compares with the next coarser mesh,
//   is no less than a third of them.
// - In a sector that is refined once the same nodes are there with half as many
//   cells around.
// - Over a whole run of 2000 cycles the estimate for the depth bounds what the
//   mesh does to it in the same way.

#include <deal.II/base/mpi.h>

#include <tribody/run/mesh_resolution.h>
#include <tribody/stepping/coarse_run.h>
#include <tribody/stepping/wear_process.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace Tribody;
using namespace Tribody::Coupling;

Multibody::DutyCycle
make_duty_cycle()
{
  Multibody::JointDutyCycle joint;
  joint.name                  = "pin";
  joint.normal_force          = Eigen::Vector3d(40., 100., 70.);
  joint.contact_angle_bushing = Eigen::Vector3d(2.6, 2.7, 2.8);
  joint.sliding_increment     = Eigen::Vector3d::Constant(20e-3);
  Multibody::DutyCycle cycle;
  cycle.joints = {joint};
  return cycle;
}

struct Case
{
  explicit Case(const double clearance)
  {
    joint.name               = "pin";
    joint.bushing_radius     = 9.535e-3;
    joint.pin_radius         = joint.bushing_radius - clearance;
    joint.bushing_material   = {"PTFE", 0.139e9, 0.38, 2160.};
    joint.pin_material       = {"steel", 207e9, 0.29, 7800.};
    bushing.name             = joint.name;
    bushing.axial_length     = 13.1e-3;
    bushing.outer_radius     = 15.875e-3;
    bushing.wear_coefficient = 5.05e-13;
  }

  /// With a mesh of so many nodes across the contact.
  std::deque<WearingBushing>
  make(const unsigned int n_contact_nodes)
  {
    bushing.mesh.n_contact_nodes = n_contact_nodes;
    std::deque<WearingBushing> bushings;
    bushings.emplace_back(resolve_contact_arc(bushing,
                                              joint,
                                              make_duty_cycle().joints[0]),
                          joint,
                          0.005);
    return bushings;
  }

  Multibody::JointParameters joint;
  BushingParameters          bushing;
};

CycleContact
solve(const WearingBushing &bushing)
{
  return bushing.compute_cycle_contact(bushing.profile().depth,
                                       make_duty_cycle().joints[0],
                                       nullptr);
}

void
check(const double clearance)
{
  Case         joint(clearance);
  const double exact = solve(joint.make(160).front()).max_pressure;
  std::cout << "clearance " << 1e6 * clearance << " um: largest pressure "
            << 1e-6 * exact << " MPa" << std::endl;
  for (const unsigned int n : {10, 20, 40})
    {
      const WearParameters wear;
      WearProcess          process(wear, joint.make(n));
      process.renew_duty_cycle(make_duty_cycle());
      process.solve_contacts();
      const CycleContact &contact = process.state().joints[0].contact;

      CoarseRun coarse(wear, process);
      coarse.start(process);
      const MeshError estimate = coarse.mesh_errors()[0];
      const double    error    = std::abs(contact.max_pressure / exact - 1.);
      const double    across   = contact.at_peak_force().active_set.size();
      std::cout << "  " << n << " nodes asked for: "
                << (std::abs(across - n) <= 0.05 * n + 2. ? "there"
                                                          : "not there")
                << ", " << estimate.n_coarse_nodes << " of " << estimate.n_nodes
                << " bore nodes; error " << 1e3 * error << "e-3, estimate "
                << 1e3 * estimate.max_pressure << "e-3; bounds it "
                << (estimate.max_pressure > error / 3.) << std::endl;
    }
}

/// Depth after 2000 cycles [um], and its estimated error by the mesh [-].
std::pair<double, double>
wear_out(std::deque<WearingBushing> &&bushings)
{
  WearParameters wear;
  wear.mesh_error_estimate = MeshErrorEstimate::whole_run;
  WearProcess process(wear, std::move(bushings));
  process.renew_duty_cycle(make_duty_cycle());
  process.solve_contacts();
  CoarseRun coarse(wear, process);
  coarse.start(process);
  while (process.state().cycles < 2000.)
    {
      const double begin = process.state().cycles;
      process.take_step(2000.);
      coarse.follow(process);
      process.complete_step(begin);
    }
  return {1e6 * process.bushings().front().profile().max_depth(),
          coarse.mesh_errors()[0].wear_depth};
}

void
check_run()
{
  Case         joint(10e-6);
  const double exact           = wear_out(joint.make(80)).first;
  const auto [depth, estimate] = wear_out(joint.make(20));
  const double error           = std::abs(depth / exact - 1.);
  std::cout << "after 2000 cycles: depth " << exact << " um, error "
            << 1e3 * error << "e-3, estimate " << 1e3 * estimate
            << "e-3; bounds it " << (estimate > error / 3.) << std::endl;
}

void
check_sector()
{
  Case       joint(10e-6);
  const auto n_cells = joint.make(40).front().bushing_parameters().mesh;
  joint.bushing.mesh.n_sector_refinements = 1;
  joint.bushing.mesh.sector               = {1., 4.4};
  const auto refined                      = joint.make(40);
  const auto n_half = refined.front().bushing_parameters().mesh;
  std::cout << "in a sector: " << n_half.n_bore_cells << " instead of "
            << n_cells.n_bore_cells << " cells around, "
            << solve(refined.front()).at_peak_force().active_set.size()
            << " nodes in contact" << std::endl;
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::fixed << std::setprecision(2);
  check(10e-6);
  check(500e-6);
  check_sector();
  check_run();
}
