// SPDX-License-Identifier: LGPL-2.1-or-later

// A bushing whose mesh ranks share. Known: it is the same bushing. Each rank
// owns its share of the cells; compliance and lost area are compared with those
// of the whole mesh and its factorisation. The tolerance of the iteration,
// 1e-12 of the force, times the few tens that a displacement field is longer
// than its value at the bore leaves less than 1e-10 of the largest compliance.
// Where a sector is refined, a distributed mesh may be graded more gently: the
// whole mesh is then made by one rank alone in the same way. A cycle worn by
// either bushing agrees as far as the contact, solved to 1e-10, amplifies the
// difference: to 1e-8. The picture is one file that holds all cells.

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include <tribody/bushing/wearing_bushing.h>
#include <tribody/elasticity/rim_shape.h>
#include <tribody/multibody/cycle/duty_cycle.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

using namespace Tribody;
using namespace Tribody::Coupling;

namespace
{
  const double inner = 9.5e-3, outer = 16e-3;

  using Mesh        = dealii::Triangulation<2>;
  using Distributed = dealii::parallel::distributed::Triangulation<2>;

  struct Compliances
  {
    Eigen::MatrixXd unworn, worn;
    double          lost_area;
  };

  void
  make_mesh(const Elasticity::RingMeshParameters &parameters,
            const Elasticity::RimShape           &rim,
            Mesh                                 &mesh)
  {
    Elasticity::make_ring_mesh(parameters, inner, outer, rim, mesh);
    Elasticity::refine_sector(parameters, inner, outer - inner, "Mesh", mesh);
  }

  Compliances
  compute(const Mesh                   &mesh,
          const unsigned int            degree,
          const Elasticity::RimSupport &support)
  {
    Geometry::WornConfiguration   geometry(mesh, degree, "crank_pin");
    Elasticity::BushingElasticity elasticity(mesh,
                                             degree,
                                             {"steel", 207e9, 0.3, 7800.},
                                             Elasticity::PlaneState::strain,
                                             support);
    const auto                    compliance = [&]() {
      elasticity.reinit(geometry.mapping());
      return elasticity.normal_compliance(
        make_bore_surface(geometry.worn_positions(), degree).normals);
    };
    Compliances result;
    result.unworn = compliance();
    geometry.update(1e-3 *
                    (1. + geometry.bore_nodes().angles.array().cos()).square());
    result.worn      = compliance();
    result.lost_area = geometry.removed_area();
    return result;
  }

  double
  difference(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b)
  {
    return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
  }

  std::string
  yes(const bool agree)
  {
    return agree ? "yes" : "no";
  }

  void
  check_compliance(std::ostream                         &out,
                   const std::string                    &name,
                   const Elasticity::RingMeshParameters &parameters,
                   const Elasticity::RimShape           &rim,
                   const unsigned int                    degree,
                   const Elasticity::RimSupport         &support)
  {
    Mesh whole(parameters.n_sector_refinements > 0
                 ? Mesh::limit_level_difference_at_vertices
                 : Mesh::none);
    make_mesh(parameters, rim, whole);
    Distributed shared(MPI_COMM_WORLD,
                       Mesh::none,
                       Distributed::no_automatic_repartitioning);
    make_mesh(parameters, rim, shared);
    const Compliances one = compute(whole, degree, support);
    const Compliances all = compute(shared, degree, support);

    const double largest_share =
      dealii::Utilities::MPI::max(1. * shared.n_locally_owned_active_cells(),
                                  MPI_COMM_WORLD) /
      shared.n_global_active_cells();
    out << name << ", degree " << degree << std::endl
        << "  same number of cells: "
        << yes(shared.n_global_active_cells() == whole.n_active_cells())
        << ", largest share of a rank: " << largest_share << std::endl
        << "  compliance equal to 1e-10, unworn: "
        << yes(difference(all.unworn, one.unworn) < 1e-10)
        << ", worn: " << yes(difference(all.worn, one.worn) < 1e-10)
        << std::endl
        << "  lost area equal to 1e-10: "
        << yes(std::abs(all.lost_area / one.lost_area - 1.) < 1e-10)
        << std::endl;
  }

  WearingBushing
  make_bushing(const StiffnessSolver solver, const MPI_Comm &communicator)
  {
    Multibody::JointParameters joint;
    joint.name             = "pin";
    joint.bushing_material = {"plastic", 0.139e9, 0.38, 2160.};
    BushingParameters bushing;
    bushing.name                = joint.name;
    bushing.axial_length        = 8.6e-3;
    bushing.outer_radius        = 15.875e-3;
    bushing.wear_coefficient    = 5.05e-13;
    bushing.mesh.n_bore_cells   = 48;
    bushing.mesh.n_radial_cells = 4;
    bushing.stiffness_solver    = solver;
    return {bushing, joint, 0.005, communicator};
  }

  void
  check_cycle(std::ostream &out)
  {
    Multibody::JointDutyCycle cycle;
    const unsigned int        n = 21;
    cycle.name                  = "pin";
    cycle.sliding_increment     = Eigen::VectorXd::Constant(n, 60e-3 / n);
    cycle.normal_force          = Eigen::VectorXd::LinSpaced(n, 50., 100.);
    cycle.contact_angle_bushing = Eigen::VectorXd::LinSpaced(n, 0., 6.);

    WearingBushing one = make_bushing(StiffnessSolver::direct, MPI_COMM_SELF);
    WearingBushing all =
      make_bushing(StiffnessSolver::multigrid, MPI_COMM_WORLD);
    CycleContact contact;
    double       cycles = 5000.;
    for (unsigned int step = 0; step < 3; ++step)
      for (WearingBushing *bushing : {&one, &all})
        {
          contact =
            bushing->compute_cycle_contact(bushing->depth(), cycle, nullptr);
          bushing->set_depth(bushing->depth() + cycles * contact.wear_rate);
        }
    out << "worn depth, in mm " << 1e3 * one.depth().maxCoeff()
        << ", equal to 1e-8: "
        << yes(difference(all.depth(), one.depth()) < 1e-8) << std::endl
        << "worn volume equal to 1e-8: "
        << yes(std::abs(all.worn_volume() / one.worn_volume() - 1.) < 1e-8)
        << std::endl;

    all.write_vtu("bushing.vtu", contact);
    MPI_Barrier(MPI_COMM_WORLD);
    std::ifstream     file("bushing.vtu");
    std::stringstream content;
    content << file.rdbuf();
    const std::string text  = content.str();
    std::size_t       cells = 0;
    for (std::size_t at = 0;
         (at = text.find("NumberOfCells=\"", at)) != std::string::npos;)
      {
        at += 15;
        cells += std::stoul(text.substr(at));
      }
    // Every cell is drawn as degree by degree patches.
    out << "cells in the picture: " << cells << " of " << 48 * 4 * 4
        << ", the file is complete: "
        << yes(text.find("</VTKFile>") != std::string::npos) << std::endl;
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::ofstream                                  output;
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    output.open("output");

  const Elasticity::RimSupport clamped;
  const Elasticity::RimSupport springs{
    Elasticity::RimSupport::Kind::elastic_foundation, 1e13, 4e12};
  const Elasticity::RimShape circle;
  Elasticity::RimShape       ellipse;
  ellipse.kind             = Elasticity::RimShape::Kind::ellipse;
  ellipse.centre           = {1e-3, -0.5e-3};
  ellipse.second_semi_axis = 14e-3;
  Elasticity::RingMeshParameters ring{32, 4, 1.5};
  for (const unsigned int degree : {1, 3})
    check_compliance(output, "clamped", ring, circle, degree, clamped);
  check_compliance(output, "springs", ring, circle, 2, springs);
  check_compliance(output, "ellipse", ring, ellipse, 2, clamped);
  // Three layers cannot be halved: every rank holds the mesh, not the rest.
  check_compliance(output, "odd layers", {34, 3, 1.}, circle, 2, clamped);
  ring.sector               = {0.3, 1.8};
  ring.n_sector_refinements = 1;
  check_compliance(output, "sector", ring, circle, 2, springs);
  ring.n_sector_refinements = 2;
  check_compliance(output, "sector in an ellipse", ring, ellipse, 1, clamped);
  check_cycle(output);
}
