// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/sundials/ida_vector.h>
#include <tribody/sundials/vector_view.h>

#include <cmath>

namespace Tribody
{
  namespace Sundials
  {
    namespace
    {
      void
      linear_sum(realtype a, N_Vector x, realtype b, N_Vector y, N_Vector z)
      {
        view(z) = a * const_view(x) + b * const_view(y);
      }



      int
      linear_combination(int n, realtype *c, N_Vector *x, N_Vector z)
      {
        // z may be the first of the vectors, but no other one.
        Eigen::Map<Eigen::VectorXd> sum = view(z);
        sum                             = c[0] * const_view(x[0]);
        for (int k = 1; k < n; ++k)
          sum += c[k] * const_view(x[k]);
        return 0;
      }



      void
      scale(realtype c, N_Vector x, N_Vector z)
      {
        view(z) = c * const_view(x);
      }



      realtype
      wrms_norm(N_Vector x, N_Vector weights)
      {
        return std::sqrt(
          const_view(x).cwiseProduct(const_view(weights)).squaredNorm() /
          N_VGetLength(x));
      }



      // Of the entries whose @p id is positive, over the number of all.
      realtype
      wrms_norm_mask(N_Vector x, N_Vector weights, N_Vector id)
      {
        return std::sqrt(
          (const_view(id).array() > 0.)
            .select(const_view(x).cwiseProduct(const_view(weights)), 0.)
            .squaredNorm() /
          N_VGetLength(x));
      }
    } // namespace



    N_Vector
    make_ida_vector(Eigen::VectorXd &x, SUNContext context)
    {
      const N_Vector vector = N_VMake_Serial(x.size(), x.data(), context);
      if (vector == nullptr)
        return vector;
      vector->ops->nvlinearsum         = linear_sum;
      vector->ops->nvlinearcombination = linear_combination;
      vector->ops->nvscale             = scale;
      vector->ops->nvwrmsnorm          = wrms_norm;
      vector->ops->nvwrmsnormmask      = wrms_norm_mask;
      return vector;
    }
  } // namespace Sundials
} // namespace Tribody
