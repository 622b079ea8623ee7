// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/stepping/wear_parameters.h>

namespace Tribody
{
  namespace Coupling
  {
    void
    WearParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_choice(
        prm,
        "Scheme",
        scheme,
        "How dynamics and contact pressure go together. staggered: joint "
        "forces by the contact force laws of the joints, then pressures by "
        "finite elements under these forces (Mukras et al.). coupled: the law "
        "'finite element' in all joints with a bushing, whatever their entry "
        "'Contact force law' says, so that forces and pressures are one "
        "model.");
      Parameters::add_choice(prm,
                             "Extrapolation",
                             extrapolation,
                             "How the wear of one cycle is carried over many. "
                             "implicit: as few implicit steps as the tolerance "
                             "allows, whatever the mesh. constant: explicit "
                             "steps of equal length, eqs. (24) and (25) of "
                             "Mukras et al. one-shot: the wear of the first "
                             "cycle times the number of cycles, to see how "
                             "wrong that is.");
      Parameters::add_quantity(prm,
                               "Tolerance",
                               tolerance,
                               "",
                               "Error of the depth that an implicit step may "
                               "make, its root mean square over the worn arc "
                               "relative to the largest depth of the bushing, "
                               "between 1e-8 and 0.1. What the wear changes in "
                               "motion and compliance during a step is held "
                               "to the same tolerance. Depths below 5 % of the "
                               "clearance do not make it tighter.");
      Parameters::add_quantity(
        prm,
        "Cycles per step",
        cycles_per_step,
        "",
        "Length A_E of a wear step in cycles. Explicit "
        "steps are stable up to a length that falls "
        "with the mesh size; longer ones grow "
        "oscillations in pressure and depth, which the "
        "log reports. 0: 80 % of the stable length. A run "
        "has at most 1e9 steps.");
      Parameters::add_quantity(prm,
                               "Compliance update",
                               compliance_update,
                               "",
                               "The elastic compliance of a bushing is "
                               "computed anew when its profile has changed by "
                               "this fraction of its wall; gap, normals and "
                               "weights always follow the worn profile.");
      Parameters::add_choice(
        prm,
        "Mesh error estimate",
        mesh_error_estimate,
        "What is also computed on the next coarser mesh (half as many bore "
        "cells and layers, or one file refinement less) to see what the mesh "
        "does to the results: the largest pressure and the wear rate of the "
        "first cycle, or the wear of the whole run too, which takes some ten "
        "per cent longer. The dynamics is not repeated. The difference of the "
        "depth, which is larger than its error, counts in the estimated error "
        "if it is of the whole run.");
      Parameters::add_quantity(prm,
                               "Dynamics update",
                               dynamics_update,
                               "",
                               "The motion is computed anew when the profile "
                               "of a bushing has changed by this fraction of "
                               "the largest clearance of its worn joint since "
                               "it was computed last, and always at the end. "
                               "What the delay may have changed is part of the "
                               "estimated error. 0: after every wear step.");
    }



    void
    WearParameters::check() const
    {
      AssertThrow(tolerance >= 1e-8 && tolerance <= 0.1,
                  ExcParameter("Wear/Tolerance",
                               Units::to_string(tolerance, "", "") +
                                 " must lie between 1e-8 and 0.1"));
      AssertThrow(cycles_per_step >= 0.,
                  ExcParameter("Wear/Cycles per step",
                               Units::to_string(cycles_per_step, "", "") +
                                 " must be positive, or 0 for an automatic "
                                 "choice"));
      AssertThrow(compliance_update > 0. && compliance_update < 1.,
                  ExcParameter("Wear/Compliance update",
                               Units::to_string(compliance_update, "", "") +
                                 " must lie between 0 and 1, both excluded"));
      AssertThrow(dynamics_update >= 0. && dynamics_update < 1.,
                  ExcParameter("Wear/Dynamics update",
                               Units::to_string(dynamics_update, "", "") +
                                 " must be at least 0 and less than 1"));
    }
  } // namespace Coupling
} // namespace Tribody
