// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_case_case_checks_h
#define tribody_case_case_checks_h

#include <tribody/base/parameter_file.h>
#include <tribody/case/case_parameters.h>

namespace Tribody
{
  namespace Coupling
  {
    /// Names of results differ in more than capitals. @throws ExcParameter.
    void
    check_names(const CaseParameters &parameters);

    /// A bushing is that of a joint which can press on it.
    /// @throws ExcParameter.
    void
    check_bushing_joints(const CaseParameters &parameters);

    /// Values that belong to the case and that nobody can guess are set: a
    /// default would be a silent invention. @throws ExcParameter.
    void
    check_required(const ParameterFile &file, const CaseParameters &parameters);

    /// Steps are no such small part of the run that they are lost in its
    /// rounding. @throws ExcParameter.
    void
    check_cycles_per_step(const CaseParameters &parameters);

    /// Values of all parts, and whether this machine can hold the case; not
    /// whether the mechanism can be assembled. @throws ExcParameter.
    void
    check_values(const CaseParameters &parameters);
  } // namespace Coupling
} // namespace Tribody

#endif
