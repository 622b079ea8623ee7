// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_run_make_unworn_supports_h
#define tribody_run_make_unworn_supports_h

#include <tribody/case/case_parameters.h>
#include <tribody/multibody/joints/pin_support.h>

#include <map>
#include <memory>
#include <string>

namespace Tribody
{
  namespace Coupling
  {
    /// Supports of the unworn joints whose law asks for one, by their names.
    std::map<std::string, std::shared_ptr<const Multibody::PinSupport>>
    make_unworn_supports(const CaseParameters &parameters);
  } // namespace Coupling
} // namespace Tribody

#endif
