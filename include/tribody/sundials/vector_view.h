// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_sundials_vector_view_h
#define tribody_sundials_vector_view_h

#include <Eigen/Core>
#include <nvector/nvector_serial.h>

namespace Tribody
{
  namespace Sundials
  {
    /// The entries of a serial vector, to write to.
    inline Eigen::Map<Eigen::VectorXd>
    view(const N_Vector x)
    {
      return {NV_DATA_S(x), static_cast<Eigen::Index>(NV_LENGTH_S(x))};
    }

    /// The entries of a serial vector.
    inline Eigen::Map<const Eigen::VectorXd>
    const_view(const N_Vector x)
    {
      return {NV_DATA_S(x), static_cast<Eigen::Index>(NV_LENGTH_S(x))};
    }
  } // namespace Sundials
} // namespace Tribody

#endif
