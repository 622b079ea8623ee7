// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <tribody/algebra/dense_products.h>

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
  namespace DenseProducts
  {
    namespace
    {
      using Eigen::Index;

      /// Four numbers in one register, or in two with SSE2.
      typedef double  Pack __attribute__((vector_size(32)));
      constexpr Index n_in_pack = 4;

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



      /// Up to this many terms the result is swept once for every four of them,
      /// beyond it four columns at a time, for all terms of a panel.
      constexpr Index max_few_terms = 8;



      /// Packs of rows that are worked on together: results that stay in the
      /// registers, and enough of them that none waits for the one before.
      constexpr Index
      packs_per_strip(const Index n_columns)
      {
        return n_columns == 1 ? 8 : n_columns == 4 ? 2 : 4;
      }



      /// The rows of n_columns columns of the result that @p y begins with, of
      /// which the first @p n_known have been worked on already.
      template <Index n_columns>
      [[gnu::always_inline]] inline void
      add_strip(const Index   k,
                const double *a,
                const Index   stride_a,
                const double *b,
                const Index   stride_b,
                double       *y,
                const Index   stride_y,
                const Index   n_known)
      {
        constexpr Index n_packs = packs_per_strip(n_columns);
        Pack            sums[n_columns][n_packs];
#pragma GCC unroll 8
        for (Index q = 0; q < n_columns; ++q)
#pragma GCC unroll 8
          for (Index p = 0; p < n_packs; ++p)
            sums[q][p] = load(y + n_in_pack * p + q * stride_y);
        for (Index j = 0; j < k; ++j)
#pragma GCC unroll 8
          for (Index p = 0; p < n_packs; ++p)
            {
              const Pack rows = load(a + n_in_pack * p + j * stride_a);
#pragma GCC unroll 8
              for (Index q = 0; q < n_columns; ++q)
                sums[q][p] += rows * b[j + q * stride_b];
            }
#pragma GCC unroll 8
        for (Index q = 0; q < n_columns; ++q)
          {
            double *column = y + q * stride_y;
            if (n_known == 0)
              {
#pragma GCC unroll 8
                for (Index p = 0; p < n_packs; ++p)
                  store(sums[q][p], column + n_in_pack * p);
                continue;
              }
            double strip[n_packs * n_in_pack];
#pragma GCC unroll 8
            for (Index p = 0; p < n_packs; ++p)
              store(sums[q][p], strip + n_in_pack * p);
            std::copy(strip + n_known,
                      strip + n_packs * n_in_pack,
                      column + n_known);
          }
      }



      /// n_columns columns of the result, strip by strip; the last one overlaps
      /// with the one before.
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
        constexpr Index n_rows = n_in_pack * packs_per_strip(n_columns);
        if (m < n_rows)
          {
            for (Index j = 0; j < k; ++j)
              for (Index q = 0; q < n_columns; ++q)
                for (Index i = 0; i < m; ++i)
                  y[i + q * stride_y] +=
                    a[i + j * stride_a] * b[j + q * stride_b];
            return;
          }
        for (Index end = n_rows;; end += n_rows)
          {
            const Index first = std::min(end, m) - n_rows;
            add_strip<n_columns>(k,
                                 a + first,
                                 stride_a,
                                 b,
                                 stride_b,
                                 y + first,
                                 stride_y,
                                 end - n_rows - first);
            if (end >= m)
              return;
          }
      }



      /// All of the result, for a product over n_terms only.
      template <Index n_terms>
      [[gnu::always_inline]] inline void
      add_terms(const Index   m,
                const Index   n,
                const double *a,
                const Index   stride_a,
                const double *b,
                const Index   stride_b,
                double       *y,
                const Index   stride_y)
      {
        for (Index q = 0; q < n; ++q)
          {
            double factors[n_terms];
            std::copy_n(b + q * stride_b, n_terms, factors);
            double *column = y + q * stride_y;
            Index   i      = 0;
            for (; i + n_in_pack <= m; i += n_in_pack)
              {
                Pack sum = load(column + i);
#pragma GCC unroll 8
                for (Index j = 0; j < n_terms; ++j)
                  sum += load(a + i + j * stride_a) * factors[j];
                store(sum, column + i);
              }
            for (; i < m; ++i)
              for (Index j = 0; j < n_terms; ++j)
                column[i] += a[i + j * stride_a] * factors[j];
          }
      }



      TRIBODY_FOR_ALL_PROCESSORS
      void
      add_few_columns(const Index   m,
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



      TRIBODY_FOR_ALL_PROCESSORS
      void
      add_few_terms(const Index   m,
                    const Index   n,
                    const Index   k,
                    const double *a,
                    const Index   stride_a,
                    const double *b,
                    const Index   stride_b,
                    double       *y,
                    const Index   stride_y)
      {
        for (Index j = 0; j < k; j += n_together)
          {
            const double *few_a = a + j * stride_a;
            const double *few_b = b + j;
            switch (k - j)
              {
                case 1:
                  add_terms<1>(
                    m, n, few_a, stride_a, few_b, stride_b, y, stride_y);
                  break;
                case 2:
                  add_terms<2>(
                    m, n, few_a, stride_a, few_b, stride_b, y, stride_y);
                  break;
                case 3:
                  add_terms<3>(
                    m, n, few_a, stride_a, few_b, stride_b, y, stride_y);
                  break;
                default:
                  add_terms<4>(
                    m, n, few_a, stride_a, few_b, stride_b, y, stride_y);
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
      const auto add = a.cols() < b.cols() && a.cols() <= max_few_terms
                         ? add_few_terms
                         : add_few_columns;
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



    Eigen::MatrixXd
    multiply(const ConstBlock &a, const ConstBlock &b)
    {
      Eigen::MatrixXd product = Eigen::MatrixXd::Zero(a.rows(), b.cols());
      add_product(a, b, product);
      return product;
    }
  } // namespace DenseProducts
} // namespace Tribody
