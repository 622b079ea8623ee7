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

      /// Columns of the matrix or of the result that are worked on together.
      constexpr Index n_together = 4;



      /// Add n_columns columns of a, m rows each, times the n_columns by
      /// n_few block b to y.
      template <Index n_columns, Index n_few>
      [[gnu::always_inline]] inline void
      add_columns(const Index   m,
                  const double *a,
                  const Index   stride_a,
                  const double *b,
                  const Index   stride_b,
                  double       *y,
                  const Index   stride_y)
      {
        Index i = 0;
        for (; i + 4 <= m; i += 4)
          for (Index q = 0; q < n_few; ++q)
            {
              double *target = y + i + q * stride_y;
              Pack    sum    = load(target);
              for (Index j = 0; j < n_columns; ++j)
                sum += load(a + i + j * stride_a) * b[j + q * stride_b];
              store(sum, target);
            }
        for (; i < m; ++i)
          for (Index q = 0; q < n_few; ++q)
            for (Index j = 0; j < n_columns; ++j)
              y[i + q * stride_y] += a[i + j * stride_a] * b[j + q * stride_b];
      }



      template <Index n_few>
      [[gnu::always_inline]] inline void
      add_all_columns(const Index   m,
                      const Index   n,
                      const double *a,
                      const Index   stride_a,
                      const double *b,
                      const Index   stride_b,
                      double       *y,
                      const Index   stride_y)
      {
        Index j = 0;
        for (; j + n_together <= n; j += n_together)
          add_columns<n_together, n_few>(
            m, a + j * stride_a, stride_a, b + j, stride_b, y, stride_y);
        for (; j < n; ++j)
          add_columns<1, n_few>(
            m, a + j * stride_a, stride_a, b + j, stride_b, y, stride_y);
      }



      TRIBODY_FOR_ALL_PROCESSORS
      void
      add_few(const Index   m,
              const Index   n,
              const Index   n_few,
              const double *a,
              const Index   stride_a,
              const double *b,
              const Index   stride_b,
              double       *y,
              const Index   stride_y)
      {
        switch (n_few)
          {
            case 1:
              return add_all_columns<1>(
                m, n, a, stride_a, b, stride_b, y, stride_y);
            case 2:
              return add_all_columns<2>(
                m, n, a, stride_a, b, stride_b, y, stride_y);
            case 3:
              return add_all_columns<3>(
                m, n, a, stride_a, b, stride_b, y, stride_y);
            default:
              return add_all_columns<4>(
                m, n, a, stride_a, b, stride_b, y, stride_y);
          }
      }



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
      add_outer(const Index   m,
                const Index   n,
                const Index   k,
                const double *a,
                const Index   stride_a,
                const double *b,
                const Index   stride_b,
                double       *y,
                const Index   stride_y)
      {
        Index j = 0;
        for (; j + n_together <= n; j += n_together)
          add_strips<n_together>(m,
                                 k,
                                 a,
                                 stride_a,
                                 b + j * stride_b,
                                 stride_b,
                                 y + j * stride_y,
                                 stride_y);
        for (; j < n; ++j)
          add_strips<1>(m,
                        k,
                        a,
                        stride_a,
                        b + j * stride_b,
                        stride_b,
                        y + j * stride_y,
                        stride_y);
      }
    } // namespace



    void
    add_product(const ConstBlock &matrix, const ConstBlock &few, Block sum)
    {
      AssertDimension(matrix.cols(), few.rows());
      AssertDimension(matrix.rows(), sum.rows());
      AssertDimension(few.cols(), sum.cols());
      for (Index q = 0; q < few.cols(); q += n_together)
        add_few(matrix.rows(),
                matrix.cols(),
                std::min(n_together, few.cols() - q),
                matrix.data(),
                matrix.outerStride(),
                few.data() + q * few.outerStride(),
                few.outerStride(),
                sum.data() + q * sum.outerStride(),
                sum.outerStride());
    }



    void
    add_outer_product(const ConstBlock &tall, const ConstBlock &flat, Block sum)
    {
      AssertDimension(tall.cols(), flat.rows());
      AssertDimension(tall.rows(), sum.rows());
      AssertDimension(flat.cols(), sum.cols());
      add_outer(tall.rows(),
                flat.cols(),
                tall.cols(),
                tall.data(),
                tall.outerStride(),
                flat.data(),
                flat.outerStride(),
                sum.data(),
                sum.outerStride());
    }
  } // namespace Contact
} // namespace Tribody
