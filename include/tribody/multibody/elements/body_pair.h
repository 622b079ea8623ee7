// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_body_pair_h
#define tribody_multibody_elements_body_pair_h

#include <Eigen/Core>

#include <tribody/algebra/matrix_entries.h>

#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    /// Coordinates, velocities or forces of two bodies: (x, y, phi) each.
    using PairVector = Eigen::Matrix<double, 6, 1>;
    /// Derivative of one PairVector with respect to another.
    using PairMatrix = Eigen::Matrix<double, 6, 6>;

    /// Number of the body that does not move. It has no coordinates.
    constexpr int ground_body = -1;

    /// A point fixed in a body.
    struct Marker
    {
      /// Number of the body, or ground_body.
      int body = ground_body;
      /// Position in the body's frame [m].
      Eigen::Vector2d position = Eigen::Vector2d::Zero();
    };

    /// k x a: @p a turned by a right angle, counter-clockwise.
    inline Eigen::Vector2d
    perpendicular(const Eigen::Vector2d &a)
    {
      return {-a.y(), a.x()};
    }

    /// A(angle) @p s: from a body's frame to global axes.
    inline Eigen::Vector2d
    turned(const Eigen::Vector2d &s, const double angle)
    {
      const double c = std::cos(angle), sine = std::sin(angle);
      return {c * s.x() - sine * s.y(), sine * s.x() + c * s.y()};
    }

    /// Position of a marker at @p s in a body with coordinates @p q.
    inline Eigen::Vector2d
    marker_position(const Eigen::Vector3d &q, const Eigen::Vector2d &s)
    {
      return q.head<2>() + turned(s, q(2));
    }

    /**
     * The two bodies that an element acts on. Elements work on fixed-size
     * local quantities; this is their numbering in the global ones. Entries
     * of the ground read as zero, and what is added to them is dropped.
     */
    struct BodyPair
    {
      /// Number of the first body, in a joint with a pin that of the pin.
      int first = ground_body;
      /// Number of the second body, in a joint with a pin that of the bushing.
      int second = ground_body;

      /// Entries of the two bodies in @p global, which has three per body.
      PairVector
      gather(const Eigen::Ref<const Eigen::VectorXd> &global) const
      {
        PairVector local;
        for (const int k : {0, 1})
          if (body(k) == ground_body)
            local.segment<3>(3 * k).setZero();
          else
            local.segment<3>(3 * k) = global.segment<3>(3 * body(k));
        return local;
      }

      /// Add @p local to the entries of the two bodies in @p global.
      void
      add_to(const PairVector &local, Eigen::Ref<Eigen::VectorXd> global) const
      {
        for (const int k : {0, 1})
          if (body(k) != ground_body)
            global.segment<3>(3 * body(k)) += local.segment<3>(3 * k);
      }

      /// Add @p local to the square matrix whose upper left entry is at
      /// (@p row, @p column), one row and column per coordinate.
      void
      add_to(const PairMatrix  &local,
             const Eigen::Index row,
             const Eigen::Index column,
             MatrixEntries     &global) const
      {
        for (const int k : {0, 1})
          for (const int l : {0, 1})
            if (body(k) != ground_body && body(l) != ground_body)
              global.add_block(row + 3 * body(k),
                               column + 3 * body(l),
                               local.block<3, 3>(3 * k, 3 * l));
      }

      /// Add @p local, some rows of six columns, to a matrix whose first row is
      /// @p row and whose columns from @p column on belong to coordinates.
      template <typename Derived>
      void
      add_rows_to(const Eigen::MatrixBase<Derived> &local,
                  const Eigen::Index                row,
                  const Eigen::Index                column,
                  MatrixEntries                    &global) const
      {
        for (const int k : {0, 1})
          if (body(k) != ground_body)
            global.add_block(row,
                             column + 3 * body(k),
                             local.template middleCols<3>(3 * k));
      }

      /// The same for six rows that belong to coordinates.
      template <typename Derived>
      void
      add_columns_to(const Eigen::MatrixBase<Derived> &local,
                     const Eigen::Index                row,
                     const Eigen::Index                column,
                     MatrixEntries                    &global) const
      {
        for (const int k : {0, 1})
          if (body(k) != ground_body)
            global.add_block(row + 3 * body(k),
                             column,
                             local.template middleRows<3>(3 * k));
      }

      /// The first body for k = 0, the second for k = 1.
      int
      body(const int k) const
      {
        return k == 0 ? first : second;
      }
    };
  } // namespace Multibody
} // namespace Tribody

#endif
