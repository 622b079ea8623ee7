// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_inverted_mesh_h
#define tribody_base_inverted_mesh_h

#include <tribody/base/exceptions.h>

namespace Tribody
{
  /**
   * A worn geometry cannot be meshed. Less wear can: a shorter step may do.
   */
  class ExcInvertedMesh : public ExcRun
  {
  public:
    using ExcRun::ExcRun;
  };
} // namespace Tribody

#endif
