// SPDX-License-Identifier: LGPL-2.1-or-later

// The largest pressure in an unworn joint as its parameters make it, where the
// elasticity decides: a joint that has worn into its crescent has forgotten it.
// Each model beside what is known of it, and beside a model that would be
// wrong, which must be off by ten times the bound, so that the wrong one cannot
// pass.
//
// - Infinite plate with an elastic pin of the same material: Persson's solution
//   (tests/contact/reference). Also a ring of finite elements whose rim is 100
//   bore radii away, which gives way by 1e-4 less, since a rim shifts the
//   displacements by the square of the radii; wrong: a rigid pin. The clearance
//   is 1e-4 of the radius, so that the theory, linear in it, is as good. 0.3 %,
//   which 240 nodes keep (persson_01).
// - Winkler layer: the peak k (d - c) of tests/contact/pressure_models_01; d
//   follows from the force. The clearance is 1e-4 of the radius here, too.
//   0.3 %, since nodes count whole; wrong: the infinite plate.
// - Finite elements, clamped, rigid pin: the validation joint as a code that
//   shares nothing with this one has it to 1e-3 (tests/contact/reference);
//   wrong: the infinite plate.
// - A ring that is read from a file, on a foundation of 1e15 N/m^3 (E/t of the
//   wall is 2e10 N/m^3, so that the rim is clamped to 1e-4), beside a clamped
//   ring with as many cells. The rim in the file has 24 straight edges, which
//   makes the wall 1.5 % thinner in the mean and the peak some 0.1 % higher;
//   wrong: a foundation as stiff as the wall.

#include <deal.II/base/mpi.h>

#include <support/reference_table.h>

#include <tribody/bushing/elastic_joint.h>
#include <tribody/contact/contact_solver.h>

#include <cmath>
#include <iostream>
#include <sstream>
#include <string>

using namespace Tribody;
using namespace Tribody::Coupling;

constexpr double  R = 9.535e-3;
const Material    plastic{"PTFE", 0.139e9, 0.38, 2160.};
const Material    steel{"steel", 206.8e9, 0.29, 7800.};
const std::string references =
  std::string(SOURCE_DIR) + "/../contact/reference/";

struct Joint
{
  Joint(const PressureModel model, const double clearance)
  {
    joint.name                = "pin";
    joint.bushing_radius      = R;
    joint.pin_radius          = R - clearance;
    joint.bushing_material    = plastic;
    joint.pin_material        = steel;
    bushing.name              = joint.name;
    bushing.outer_radius      = 15.875e-3;
    bushing.pressure_model    = model;
    bushing.pin               = PinModel::rigid;
    bushing.mesh.n_bore_cells = 120;
  }

  /// Under a force per length along x [N/m].
  double
  peak_pressure(const double load) const
  {
    const ElasticJoint     elastic(bushing, joint, 1.);
    Contact::ContactSolver solver(elastic.bore(),
                                  elastic.compliance(),
                                  joint.pin_radius);
    const auto             solution = solver.solve_force_controlled({load, 0.});
    return solution.report.converged
             ? Contact::peak_pressure(solution, elastic.bore())
             : std::nan("");
  }

  Multibody::JointParameters joint;
  BushingParameters          bushing;
};

void
report(const std::string &what,
       const double       peak,
       const double       wrong,
       const double       known)
{
  constexpr double bound = 3e-3;
  const double     error = std::abs(peak / known - 1.);
  const double     other = std::abs(wrong / known - 1.);
  std::cout << what << ": peak within 0.3 %: " << (error < bound)
            << ", a wrong model off by more than 3 %: "
            << (other > 10. * bound);
  if (!(error < bound && other > 10. * bound))
    std::cout << " (" << error << ", " << other << ')';
  std::cout << std::endl;
}

void
check_persson()
{
  const double plane_modulus = 0.139e9 / (1. - 0.38 * 0.38);
  const double clearance     = 1e-4 * R;
  for (const auto &row : read_reference_table(references + "persson.csv"))
    {
      // Without clearance the two radii would be one.
      if (row.at(0) == 0.)
        continue;
      const double load  = plane_modulus * clearance / row[0];
      const double known = row.at(2) * load / R;
      Joint        plate(PressureModel::infinite_plate, clearance);
      const double rigid       = plate.peak_pressure(load);
      plate.bushing.pin        = PinModel::elastic;
      plate.joint.pin_material = plastic;
      std::ostringstream name;
      name << ", E' dR/Q " << row[0];
      report("infinite plate" + name.str(),
             plate.peak_pressure(load),
             rigid,
             known);
      Joint ring                       = plate;
      ring.bushing.pressure_model      = PressureModel::finite_element;
      ring.bushing.outer_radius        = 100. * R;
      ring.bushing.mesh.n_radial_cells = 27;
      ring.bushing.mesh.grading        = 4.5;
      report("distant rim" + name.str(),
             ring.peak_pressure(load),
             rigid,
             known);
    }
}

void
check_winkler()
{
  const double nu = plastic.poissons_ratio, clearance = 1e-4 * R;
  Joint        layer(PressureModel::winkler_layer, clearance);
  Joint        plate(PressureModel::infinite_plate, clearance);
  const double k =
    plastic.youngs_modulus * (1. - nu) /
    ((1. + nu) * (1. - 2. * nu) * (layer.bushing.outer_radius - R));
  for (const double load : {200., 1400.})
    {
      double low = clearance, high = 1e-3;
      for (unsigned int i = 0; i < 100; ++i)
        {
          const double d = 0.5 * (low + high);
          const double t = std::acos(clearance / d);
          const double f = layer.joint.pin_radius * k *
                           (d * (t + std::sin(t) * std::cos(t)) -
                            2. * clearance * std::sin(t));
          (f < load ? low : high) = d;
        }
      std::cout << load << " N/m, ";
      report("Winkler layer",
             layer.peak_pressure(load),
             plate.peak_pressure(load),
             k * (low - clearance));
    }
}

void
check_validation_joint()
{
  const Joint ring(PressureModel::finite_element, 10e-6),
    plate(PressureModel::infinite_plate, 10e-6);
  for (const auto &row :
       read_reference_table(references + "bushing_contact.csv"))
    {
      const double load = row.at(0) / 13.1e-3;
      std::cout << row[0] << " N, ";
      report("finite elements",
             ring.peak_pressure(load),
             plate.peak_pressure(load),
             1e6 * row.at(1));
    }
}

void
check_mesh_file()
{
  Joint ring(PressureModel::finite_element, 10e-6);
  ring.bushing.mesh.n_bore_cells   = 48;
  ring.bushing.mesh.n_radial_cells = 4;
  Joint from_file                  = ring;
  from_file.bushing.mesh_file      = {
         std::string(SOURCE_DIR) + "/../app/ring.msh", 1, 2, 1e-3, 1};
  from_file.bushing.rim_support.kind =
    Elasticity::RimSupport::Kind::elastic_foundation;
  from_file.bushing.rim_support.normal_stiffness = 1e15;
  Joint soft                                     = from_file;
  soft.bushing.rim_support.normal_stiffness      = 2e10;
  for (const double load : {2000., 14000.})
    {
      std::cout << load << " N/m, ";
      report("ring from a file",
             from_file.peak_pressure(load),
             soft.peak_pressure(load),
             ring.peak_pressure(load));
    }
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_persson();
  check_winkler();
  check_validation_joint();
  check_mesh_file();
}
