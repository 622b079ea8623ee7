// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_sundials_ida_vector_h
#define tribody_sundials_ida_vector_h

#include <Eigen/Core>
#include <sundials/sundials_nvector.h>

namespace Tribody
{
  namespace Sundials
  {
    /**
     * A serial vector of SUNDIALS that shares the entries of @p x, which must
     * outlive it and keep its size. The operations that IDA spends its time
     * with are Eigen's; so are those of its clones. A mechanism has some tens
     * of unknowns, and on vectors this short those of SUNDIALS took 40 % of
     * the time of an integration.
     * @return nullptr without memory. Release it by N_VDestroy().
     */
    N_Vector
    make_ida_vector(Eigen::VectorXd &x, SUNContext context);
  } // namespace Sundials
} // namespace Tribody

#endif
