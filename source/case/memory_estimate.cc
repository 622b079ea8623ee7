// SPDX-License-Identifier: LGPL-2.1-or-later

#include <sys/resource.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/bushing/bushing_parameters.h>
#include <tribody/case/memory_estimate.h>
#include <tribody/multibody/joints/joint_parameters.h>

#include <algorithm>
#include <cmath>
#include <unistd.h>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // Cells around the bore and in all, with those of the refined sector.
      struct CellNumbers
      {
        double at_bore, all;
      };

      CellNumbers
      count_cells(const Elasticity::RingMeshParameters &mesh)
      {
        const double n    = mesh.n_bore_cells;
        const double turn = 2. * dealii::numbers::PI;
        const double width =
          std::clamp(mesh.sector[1] - mesh.sector[0], 0., turn);
        // Cells that are divided lie near the bore, as deep as the sector is
        // wide; each division leaves four times as many of half the depth.
        const double in_sector = n * width / turn;
        CellNumbers  numbers{n, n * mesh.n_radial_cells};
        for (unsigned int k = 1; k <= mesh.n_sector_refinements; ++k)
          {
            numbers.at_bore += in_sector * std::pow(2., k - 1);
            numbers.all += 3. * in_sector * std::pow(2., k);
          }
        return numbers;
      }
    } // namespace



    double
    estimate_memory(const BushingParameters          &bushing,
                    const Multibody::JointParameters &joint)
    {
      // Dense matrices at a time, and bytes of an unknown: measured with
      // 60 to 5760 bore cells.
      constexpr double n_matrices = 3., n_matrices_of_pin = 3.;
      constexpr double of_unknown = 2000., of_factor = 150.;

      if (bushing.mesh_file.is_given())
        return 0.;
      const double      degree = bushing.element_degree;
      const CellNumbers cells  = count_cells(bushing.mesh);
      // A housing sees the rim as well.
      const double n_nodes =
        (bushing.rim_support.is_housing() ? 2. : 1.) * cells.at_bore * degree;
      const double unknowns =
        2. * (cells.all * degree * degree + cells.at_bore * degree);
      const double matrices =
        n_matrices + (bushing.pin_is_elastic(joint) ? n_matrices_of_pin : 0.);
      const double of_matrices = 8. * matrices * n_nodes * n_nodes;
      if (bushing.shares_mesh())
        return of_matrices;
      return of_matrices +
             unknowns * (of_unknown + of_factor * std::log2(unknowns));
    }



    double
    available_memory()
    {
      double available = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                         static_cast<double>(sysconf(_SC_PAGESIZE));
      for (const auto resource : {RLIMIT_AS, RLIMIT_DATA})
        {
          rlimit limit;
          if (getrlimit(resource, &limit) == 0 &&
              limit.rlim_cur != RLIM_INFINITY)
            available =
              std::min(available, static_cast<double>(limit.rlim_cur));
        }
      return available;
    }



    std::string
    describe_memory(const double bytes)
    {
      return bytes < 1e9 ? significant_digits(1e-6 * bytes, 2) + " MB"
                         : significant_digits(1e-9 * bytes, 2) + " GB";
    }



    void
    check_memory(const BushingParameters          &bushing,
                 const Multibody::JointParameters &joint,
                 const double                      others)
    {
      const double needed    = estimate_memory(bushing, joint);
      const double available = available_memory();
      AssertThrow(
        needed + others <= available,
        ExcParameter("Bushing " + bushing.name + "/Mesh/Bore cells",
                     std::to_string(bushing.mesh.n_bore_cells) +
                       " bore cells and " +
                       std::to_string(bushing.mesh.n_radial_cells) +
                       " radial cells need about " + describe_memory(needed) +
                       " of memory" +
                       (others > 0. ? ", besides " + describe_memory(others) +
                                        " for other bushings"
                                    : "") +
                       "; this machine or a limit of the system allows " +
                       describe_memory(available) +
                       ". Fewer bore cells need less, by the square of their "
                       "number; a 'Refined sector' makes cells small only "
                       "where the contact is"));
    }
  } // namespace Coupling
} // namespace Tribody
