// SPDX-License-Identifier: LGPL-2.1-or-later

// Loads of several cycles as those of one. Two forces of the same size at the
// angles a + d and a - d, over the same distance, are one of F cos d at a: what
// is lost is 1 - cos d. The same forces over other distances keep their work F
// s exactly; an impact in one of the cycles stays what it is. Then neighbours
// become one, too, four at a time, unless that is another place on the pin. A
// loss beyond the tolerance leaves loads as they are, and one more: the
// largest.

#include <tribody/multibody/joints/bearing_loads.h>

#include <cmath>
#include <iostream>

using namespace Tribody::Multibody;

namespace
{
  constexpr int n_samples = 12, n_cycles = 2;

  // In the second cycle the pin slides farther by the factor, and the direction
  // turns from -d to d.
  BearingLoads
  two_cycles(const double factor, const double d)
  {
    BearingLoads loads;
    for (Eigen::VectorXd *values : {&loads.normal_force,
                                    &loads.contact_angle_bushing,
                                    &loads.contact_angle_pin,
                                    &loads.sliding_increment,
                                    &loads.sliding_speed})
      values->resize(n_samples * n_cycles);
    for (int j = 0; j < n_samples * n_cycles; ++j)
      {
        const bool   second            = j >= n_samples;
        const double scale             = second ? factor : 1.;
        const double angle             = 0.5 * (j % n_samples);
        loads.normal_force(j)          = 10. + j % n_samples;
        loads.contact_angle_bushing(j) = angle + (second ? d : -d);
        loads.contact_angle_pin(j)     = 2. * angle + (second ? d : -d);
        loads.sliding_increment(j)     = scale * 1e-3;
        loads.sliding_speed(j)         = 0.1;
      }
    return loads;
  }



  BearingLoads
  with_other_speeds()
  {
    BearingLoads loads = two_cycles(1., 0.);
    loads.sliding_speed.head(n_samples) *= 2.;
    return loads;
  }



  double
  work(const BearingLoads &loads)
  {
    return loads.mean_normal_force() * loads.sliding_distance();
  }



  bool
  is_near(const double a, const double b)
  {
    return std::abs(a - b) < 1e-12 * (1. + std::abs(b));
  }
} // namespace

int
main()
{
  const double d = 0.1;
  {
    // That of both neighbours together would be a loss of 3 %.
    const BearingLoads all    = two_cycles(1., d);
    const BearingLoads merged = merge_cycles(all, n_cycles, 0.006);
    std::cout << "two directions: " << all.size() << " loads become "
              << merged.size() << ", the wear "
              << (is_near(work(merged) / work(all), std::cos(d))
                    ? "cos d of"
                    : "not as expected from")
              << " what it was\n"
              << "  in the middle of both: in the bushing "
              << is_near(merged.contact_angle_bushing(3), 1.5)
              << ", on the pin " << is_near(merged.contact_angle_pin(2), 2.)
              << "\n  the largest is kept: "
              << (is_near(merged.normal_force(n_samples), 9. + n_samples) &&
                  merged.sliding_increment(n_samples) == 0.)
              << "\n  beyond the tolerance: "
              << merge_cycles(all, n_cycles, 1e-4).size() << " loads"
              << std::endl;
  }
  {
    const BearingLoads all    = two_cycles(3., 0.);
    const BearingLoads merged = merge_cycles(all, n_cycles, 1e-12);
    std::cout << "one direction at each place: " << merged.size()
              << " loads, the same work " << is_near(work(merged), work(all))
              << ", distance "
              << is_near(merged.sliding_distance(), all.sliding_distance())
              << ", mean speed " << is_near(merged.sliding_speed(0), 0.1)
              << std::endl;
  }
  {
    BearingLoads all = two_cycles(3., 0.);
    all.contact_angle_bushing.setZero();
    all.normal_force.setConstant(10.);
    std::cout << "one direction in the bushing, but not on the pin: "
              << merge_cycles(all, n_cycles, 1e-12).size();
    all.contact_angle_pin.setZero();
    const BearingLoads merged = merge_cycles(all, n_cycles, 1e-12);
    std::cout << " loads; on both: " << merged.size() << ", the same work "
              << is_near(work(merged), work(all)) << std::endl;
  }
  {
    BearingLoads all          = two_cycles(1., 0.);
    all.normal_force(3)       = 0.;
    const BearingLoads merged = merge_cycles(all, n_cycles, 1e-3);
    std::cout << "other speeds: "
              << merge_cycles(with_other_speeds(), n_cycles, 1e-4).size()
              << " loads\n"
              << "an impact: " << merged.size() << " loads, the largest force "
              << "at its place " << merged.normal_force(4) << std::endl;
  }
  {
    BearingLoads still        = two_cycles(2., 0.);
    still.sliding_increment   = 0. * still.sliding_increment;
    still.normal_force        = 10. + 0. * still.normal_force.array();
    still.contact_angle_pin   = 0. * still.contact_angle_pin;
    const BearingLoads merged = merge_cycles(still, n_cycles, 0.);
    std::cout << "no sliding: nothing slides "
              << (merged.sliding_distance() == 0.) << ", the largest force "
              << merged.normal_force(merged.size() - 1) << std::endl;
  }
  std::cout << "one cycle: " << merge_cycles(two_cycles(1., d), 1, 0.).size()
            << " loads" << std::endl;
}
