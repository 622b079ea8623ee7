// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_case_memory_estimate_h
#define tribody_case_memory_estimate_h

#include <string>

namespace Tribody
{
  namespace Multibody
  {
    struct JointParameters;
  }

  namespace Coupling
  {
    struct BushingParameters;

    /**
     * Memory that a bushing takes on a rank while it is set up [bytes], within
     * a factor of two or so, as measured: dense matrices over the @f$ n @f$
     * nodes of the bore, and the factors of the stiffness of @f$ N @f$
     * unknowns,
     * @f[ 8 c n^2 + N (a + b \log_2 N). @f]
     * Of a mesh from a file, whose nodes are not known yet, it says 0. Of cells
     * that ranks share, which may be too many for one of them, it says nothing:
     * the matrices are all that is counted then. The program itself, some
     * 170 MB, comes on top.
     */
    double
    estimate_memory(const BushingParameters          &bushing,
                    const Multibody::JointParameters &joint);

    /// What this process may take at most [bytes]: the machine's memory, or the
    /// limit that a user has set.
    double
    available_memory();

    /// "3.2 GB" for a number of bytes.
    std::string
    describe_memory(const double bytes);

    /**
     * @throws ExcParameter if this machine cannot hold the bushing together
     * with @p others [bytes], with the parameter that decides.
     */
    void
    check_memory(const BushingParameters          &bushing,
                 const Multibody::JointParameters &joint,
                 const double                      others);
  } // namespace Coupling
} // namespace Tribody

#endif
