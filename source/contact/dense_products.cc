#include <deal.II/base/exceptions.h>

#include <tribody/contact/dense_products.h>

#include <algorithm>
#include <cstring>

// Sanitizers cannot follow the choice at load time.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
  !defined(__SANITIZE_ADDRESS__)
#  define TRIBODY_FOR_ALL_PROCESSORS \
    __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#  define TRIBODY_FOR_ALL_PROCESSORS
#endif

namespace Tribody
{
  namespace Contact
  {
    namespace
    {
      using Eigen::Index;

      /// Four numbers in one register, or in two with SSE2.
      typedef double Pack __attribute__((vector_size(32)));

      /// From anywhere, aligned or not.
      [[gnu::always_inline]] inline Pack
      load(const double *from)
      {
        Pack pack;
        std::memcpy(&pack, from, sizeof(pack));
        return pack;
      }

      [[gnu::always_inline]] inline void
      store(const Pack &pack, double *to)
      {
        std::memcpy(to, &pack, sizeof(pack));
      }

      /// Columns of the result that are worked on together.
      constexpr Index n_together = 4;

      /// Columns of the first factor that are read side by side: fewer than a
      /// processor remembers pages.
      constexpr Index panel_width = 32;



      /// n_columns columns of the result, in strips of eight rows that stay in
      /// registers.
      template <Index n_columns>
      [[gnu::always_inline]] inline void
      add_strips(const Index   m,
                 const Index   k,
                 const double *a,
                 const Index   stride_a,
                 const double *b,
                 const Index   stride_b,
                 double       *y,
                 const Index   stride_y)
      {
        Index i = 0;
        for (; i + 8 <= m; i += 8)
          {
            Pack low[n_columns], high[n_columns];
            for (Index q = 0; q < n_columns; ++q)
              {
                const double *at = y + i + q * stride_y;
                low[q]           = load(at);
                high[q]          = load(at + 4);
              }
            for (Index j = 0; j < k; ++j)
              {
                const double *at     = a + i + j * stride_a;
                const Pack    a_low  = load(at);
                const Pack    a_high = load(at + 4);
                for (Index q = 0; q < n_columns; ++q)
                  {
                    low[q] += a_low * b[j + q * stride_b];
                    high[q] += a_high * b[j + q * stride_b];
                  }
              }
            for (Index q = 0; q < n_columns; ++q)
              {
                double *at = y + i + q * stride_y;
                store(low[q], at);
                store(high[q], at + 4);
              }
          }
        for (; i < m; ++i)
          for (Index q = 0; q < n_columns; ++q)
            for (Index j = 0; j < k; ++j)
              y[i + q * stride_y] += a[i + j * stride_a] * b[j + q * stride_b];
      }



      TRIBODY_FOR_ALL_PROCESSORS
      void
      add(const Index   m,
          const Index   n,
          const Index   k,
          const double *a,
          const Index   stride_a,
          const double *b,
          const Index   stride_b,
          double       *y,
          const Index   stride_y)
      {
        for (Index first = 0; first < k; first += panel_width)
          for (Index j = 0; j < n; j += n_together)
            {
              const Index   width = std::min(panel_width, k - first);
              const double *panel = a + first * stride_a;
              const double *few   = b + first + j * stride_b;
              double       *sum   = y + j * stride_y;
              switch (n - j)
                {
                  case 1:
                    add_strips<1>(
                      m, width, panel, stride_a, few, stride_b, sum, stride_y);
                    break;
                  case 2:
                    add_strips<2>(
                      m, width, panel, stride_a, few, stride_b, sum, stride_y);
                    break;
                  case 3:
                    add_strips<3>(
                      m, width, panel, stride_a, few, stride_b, sum, stride_y);
                    break;
                  default:
                    add_strips<4>(
                      m, width, panel, stride_a, few, stride_b, sum, stride_y);
                }
            }
      }
    } // namespace



    void
    add_product(const ConstBlock &a, const ConstBlock &b, Block sum)
    {
      AssertDimension(a.cols(), b.rows());
      AssertDimension(a.rows(), sum.rows());
      AssertDimension(b.cols(), sum.cols());
      add(a.rows(),
          b.cols(),
          a.cols(),
          a.data(),
          a.outerStride(),
          b.data(),
          b.outerStride(),
          sum.data(),
          sum.outerStride());
    }
  } // namespace Contact
} // namespace Tribody
