// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/stepping/spectrum.h>

#include <limits>
#include <numeric>

namespace Tribody
{
  namespace Coupling
  {
    double
    Spectrum::n_cycles() const
    {
      return std::accumulate(cycles.begin(), cycles.end(), 0.);
    }



    double
    Spectrum::next_change(const double at) const
    {
      if (order == LoadCaseOrder::in_sequence)
        {
          double end = 0.;
          for (std::size_t i = 0; i + 1 < n_cases(); ++i)
            {
              end += cycles[i];
              if (end > at)
                return end;
            }
        }
      return std::numeric_limits<double>::infinity();
    }



    Eigen::VectorXd
    Spectrum::shares(const double at) const
    {
      Eigen::VectorXd result = Eigen::VectorXd::Zero(n_cases());
      if (order == LoadCaseOrder::repeated)
        {
          const double all = n_cycles();
          for (std::size_t i = 0; i < n_cases(); ++i)
            result[i] = cycles[i] / all;
          return result;
        }
      double      end = 0.;
      std::size_t i   = 0;
      while (i + 1 < n_cases() && (end += cycles[i]) <= at)
        ++i;
      result[i] = 1.;
      return result;
    }



    double
    Spectrum::cycles_in(const double time) const
    {
      if (order == LoadCaseOrder::repeated)
        {
          const double in_block = std::inner_product(cycles.begin(),
                                                     cycles.end(),
                                                     periods.begin(),
                                                     0.);
          return time / in_block * n_cycles();
        }
      double passed = 0., counted = 0.;
      for (std::size_t i = 0; i + 1 < n_cases(); ++i)
        {
          const double of_case = cycles[i] * periods[i];
          if (passed + of_case >= time)
            return counted + (time - passed) / periods[i];
          passed += of_case;
          counted += cycles[i];
        }
      return counted + (time - passed) / periods.back();
    }
  } // namespace Coupling
} // namespace Tribody
