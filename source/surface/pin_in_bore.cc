// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <Eigen/LU>

#include <tribody/surface/pin_in_bore.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Tribody
{
  namespace
  {
    using RowVector3 = SurfaceContact::RowVector3;
    using Matrix23   = SurfaceContact::Matrix23;

    // Below this eccentricity the direction of e has no meaning.
    constexpr double smallest_eccentricity = std::numeric_limits<double>::min();

    Eigen::Vector2d
    perpendicular(const Eigen::Vector2d &a)
    {
      return {-a.y(), a.x()};
    }
  } // namespace



  // delta(theta; e, alpha) and its derivatives: by theta, by w = (e, alpha),
  // and mixed.
  struct PinInBore::Overlap
  {
    double          theta;
    double          value;
    double          d_theta;
    double          d2_theta;
    RowVector3      d_w;
    RowVector3      d_theta_w;
    Eigen::Matrix3d d2_w;

    /// Point of the bore with its derivative by theta, direction from the
    /// pin's centre to it, and their distance.
    Eigen::Vector2d x;
    Eigen::Vector2d d_x;
    Eigen::Vector2d m;
    double          distance;
  };



  PinInBore::PinInBore(const JointClearance    &clearance,
                       const double             pin_radius,
                       const PenetrationMeasure measure)
    : surfaces(clearance)
    , radius(pin_radius)
    , measure(measure)
  {
    const int n_pin = static_cast<int>(surfaces.pin_wear.n_nodes());
    const int n = std::max(static_cast<int>(surfaces.bushing.n_nodes()), n_pin);
    table_x.resize(n);
    table_y.resize(n);
    for (int i = 0; i < n; ++i)
      {
        const double theta = 2. * dealii::numbers::PI * i / n;
        const double r     = radius + surfaces.bushing.value(theta);
        table_x(i)         = r * std::cos(theta);
        table_y(i)         = r * std::sin(theta);
      }
    least_pin_wear = surfaces.pin_wear.mean();
    for (int i = 0; i < n_pin; ++i)
      least_pin_wear =
        std::min(least_pin_wear,
                 surfaces.pin_wear.value(2. * dealii::numbers::PI * i / n_pin));
  }



  bool
  PinInBore::is_along_eccentricity() const
  {
    return measure == PenetrationMeasure::scalar || table_x.size() == 0;
  }



  bool
  PinInBore::is_beyond_bore(const Eigen::Vector2d &e) const
  {
    return e.norm() > radius &&
           e.norm() > radius + surfaces.bushing.value(std::atan2(e.y(), e.x()));
  }



  SurfaceContact
  PinInBore::find_along_eccentricity(const Eigen::Vector2d &e,
                                     const double           alpha) const
  {
    SurfaceContact result;
    const double   r = e.norm();
    if (!(r > smallest_eccentricity))
      {
        result.penetration =
          r - surfaces.bushing.value(0.) - surfaces.pin_wear.value(-alpha);
        return result;
      }
    const Eigen::Vector2d n = e / r, t = perpendicular(n);
    const double          theta = std::atan2(n.y(), n.x());
    const auto            c     = surfaces.bushing.evaluate(theta);
    const auto            h     = surfaces.pin_wear.evaluate(theta - alpha);

    // theta turns with e like t/r.
    const RowVector3 D_theta(t.x() / r, t.y() / r, 0.);
    const RowVector3 D_r(n.x(), n.y(), 0.), D_alpha(0., 0., 1.);
    const RowVector3 D_beta = D_theta - D_alpha;
    const double     slope  = c.first_derivative + h.first_derivative;
    // Second derivatives of r and of theta.
    const Eigen::Matrix3d H_r = r * D_theta.transpose() * D_theta;
    const Eigen::Matrix3d H_theta =
      -(D_r.transpose() * D_theta + D_theta.transpose() * D_r) / r;

    result.penetration = r - c.value - h.value;
    result.d_penetration =
      D_r - c.first_derivative * D_theta - h.first_derivative * D_beta;
    result.d2_penetration =
      H_r - slope * H_theta -
      c.second_derivative * D_theta.transpose() * D_theta -
      h.second_derivative * D_beta.transpose() * D_beta;
    result.direction   = n;
    result.d_direction = t * D_theta;
    result.pin_point   = (radius - h.value) * n;
    result.d_pin_point =
      (radius - h.value) * t * D_theta - n * h.first_derivative * D_beta;
    result.bushing_point = (radius + c.value) * n;
    result.d_bushing_point =
      ((radius + c.value) * t + c.first_derivative * n) * D_theta;
    return result;
  }



  PinInBore::Overlap
  PinInBore::evaluate_overlap(const double           theta,
                              const Eigen::Vector2d &e,
                              const double           alpha) const
  {
    Overlap               result;
    const Eigen::Vector2d u(std::cos(theta), std::sin(theta));
    const Eigen::Vector2d v = perpendicular(u);
    const auto            c = surfaces.bushing.evaluate(theta);
    const double          r = radius + c.value;
    result.theta            = theta;
    result.x                = r * u;
    result.d_x              = c.first_derivative * u + r * v;
    const Eigen::Vector2d d2_x =
      (c.second_derivative - r) * u + 2. * c.first_derivative * v;

    // delta is R_i - h_p(psi(y) - alpha) - |y| with y = x - e; G and H are its
    // derivatives by y.
    const Eigen::Vector2d y = result.x - e;
    const double          d = y.norm();
    const Eigen::Vector2d m = y / d, t = perpendicular(m);
    result.m          = m;
    result.distance   = d;
    result.value      = radius - d;
    Eigen::Vector2d G = -m;
    Eigen::Matrix2d H = -t * t.transpose() / d;
    // Derivatives by alpha, and by alpha and y.
    double          G_alpha = 0., H_alpha = 0.;
    Eigen::Vector2d H_alpha_y = Eigen::Vector2d::Zero();
    if (!surfaces.pin_wear.is_constant())
      {
        const auto h =
          surfaces.pin_wear.evaluate(std::atan2(m.y(), m.x()) - alpha);
        result.value -= h.value;
        G -= h.first_derivative / d * t;
        H += (h.first_derivative * (m * t.transpose() + t * m.transpose()) -
              h.second_derivative * t * t.transpose()) /
             (d * d);
        G_alpha   = h.first_derivative;
        H_alpha   = -h.second_derivative;
        H_alpha_y = h.second_derivative / d * t;
      }
    else
      result.value -= surfaces.pin_wear.mean();

    const Eigen::Vector2d H_d_x = H * result.d_x;
    result.d_theta              = G.dot(result.d_x);
    result.d2_theta             = result.d_x.dot(H_d_x) + G.dot(d2_x);
    result.d_w << -G.transpose(), G_alpha;
    result.d_theta_w << -H_d_x.transpose(), H_alpha_y.dot(result.d_x);
    result.d2_w << H, -H_alpha_y, -H_alpha_y.transpose(), H_alpha;
    return result;
  }



  Eigen::Index
  PinInBore::deepest_table_entry(const Eigen::Vector2d &e,
                                 const double           alpha) const
  {
    const Eigen::ArrayXd distances =
      ((table_x - e.x()).square() + (table_y - e.y()).square());
    Eigen::Index nearest;
    distances.minCoeff(&nearest);
    if (surfaces.pin_wear.is_constant())
      return nearest;

    const auto overlap = [&](const Eigen::Index i) {
      const double psi = std::atan2(table_y(i) - e.y(), table_x(i) - e.x());
      return -std::sqrt(distances(i)) - surfaces.pin_wear.value(psi - alpha);
    };
    Eigen::Index deepest = nearest;
    double       largest = overlap(nearest);
    // No point farther away than this can be deeper.
    double limit = std::pow(-largest - least_pin_wear, 2);
    for (Eigen::Index i = 0; i < distances.size(); ++i)
      if (distances(i) < limit)
        {
          const double value = overlap(i);
          if (value > largest)
            {
              largest = value;
              deepest = i;
              limit   = std::pow(-largest - least_pin_wear, 2);
            }
        }
    return deepest;
  }



  PinInBore::Overlap
  PinInBore::find_deepest(const Eigen::Vector2d &e, const double alpha) const
  {
    // Newton's method for the largest overlap beside the deepest point of the
    // table, kept between its neighbours by bisection.
    const double     spacing = 2. * dealii::numbers::PI / table_x.size();
    const double     start   = spacing * deepest_table_entry(e, alpha);
    Overlap          overlap = evaluate_overlap(start, e, alpha);
    double           lower = start - spacing, upper = start + spacing;
    double           last_step = spacing;
    constexpr double rounding  = 4. * std::numeric_limits<double>::epsilon();
    for (unsigned int k = 0; k < 60; ++k)
      {
        if (std::abs(overlap.d_theta) < rounding * overlap.d_x.norm())
          break;
        (overlap.d_theta > 0. ? lower : upper) = overlap.theta;
        double next = overlap.theta - overlap.d_theta / overlap.d2_theta;
        // Not uphill, or out of bounds, or not contracting.
        if (!(overlap.d2_theta < 0.) || next < lower || next > upper ||
            std::abs(next - overlap.theta) > 0.5 * std::abs(last_step))
          next = (lower + upper) / 2.;
        last_step = next - overlap.theta;
        if (std::abs(last_step) < rounding)
          break;
        overlap = evaluate_overlap(next, e, alpha);
      }
    return overlap;
  }



  SurfaceContact
  PinInBore::find_contact(const Eigen::Vector2d &e, const double alpha) const
  {
    if (is_along_eccentricity() || is_beyond_bore(e))
      return find_along_eccentricity(e, alpha);

    const Overlap  overlap = find_deepest(e, alpha);
    SurfaceContact result;
    // How the deepest point moves. Where pin and bore fit each other so well
    // that there is none, it is left where it is.
    RowVector3 theta_w = RowVector3::Zero();
    if (overlap.d2_theta < 0.)
      theta_w = -overlap.d_theta_w / overlap.d2_theta;
    result.penetration   = overlap.value;
    result.d_penetration = overlap.d_w;
    result.d2_penetration =
      overlap.d2_w + overlap.d_theta_w.transpose() * theta_w;

    const Eigen::Vector2d gradient   = overlap.d_w.head<2>().transpose();
    const Matrix23        d_gradient = result.d2_penetration.topRows<2>();
    result.force_ratio               = gradient.norm();
    result.direction                 = gradient / result.force_ratio;
    const Eigen::Vector2d t          = perpendicular(result.direction);
    result.d_force_ratio = result.direction.transpose() * d_gradient;
    result.d_direction = t * (t.transpose() * d_gradient) / result.force_ratio;

    result.bushing_point   = overlap.x;
    result.d_bushing_point = overlap.d_x * theta_w;
    Matrix23 d_y           = result.d_bushing_point;
    d_y.leftCols<2>() -= Eigen::Matrix2d::Identity();
    const Eigen::Vector2d m_t = perpendicular(overlap.m);
    const double          arm = overlap.distance + overlap.value;
    result.pin_point          = arm * overlap.m;
    result.d_pin_point =
      overlap.m * (overlap.m.transpose() * d_y + result.d_penetration) +
      arm / overlap.distance * m_t * (m_t.transpose() * d_y);
    return result;
  }



  double
  PinInBore::compute_penetration(const Eigen::Vector2d &e,
                                 const double           alpha) const
  {
    if (is_along_eccentricity() || is_beyond_bore(e))
      {
        const double theta = std::atan2(e.y(), e.x());
        return e.norm() - surfaces.bushing.value(theta) -
               surfaces.pin_wear.value(theta - alpha);
      }
    return find_deepest(e, alpha).value;
  }



  Eigen::Vector2d
  PinInBore::find_position(const Eigen::Vector2d &direction,
                           const double           penetration,
                           const double           alpha) const
  {
    const double    angle = std::atan2(direction.y(), direction.x());
    Eigen::Vector2d e     = (surfaces.bushing.value(angle) +
                         surfaces.pin_wear.value(angle - alpha) + penetration) *
                        direction;
    if (is_along_eccentricity())
      return e;

    // Where the pin can go farthest in the direction; among points of the bore
    // first, by linear constraints that are those of the exact overlaps.
    const double longest_step = surfaces.bushing.mean() + penetration;
    for (unsigned int k = 0; k < 20; ++k)
      {
        const Eigen::Vector2d step =
          find_farthest_step(e, alpha, direction, penetration);
        e += step;
        if (step.norm() < 1e-12 * longest_step)
          break;
      }

    // Between these points, Newton's method for penetration and direction.
    // Where the pin rests on two points at once there is nothing to be found.
    Eigen::Vector2d better = e;
    for (unsigned int k = 0; k < 10; ++k)
      {
        const SurfaceContact  contact = find_contact(better, alpha);
        const Eigen::Vector2d t       = perpendicular(direction);
        const Eigen::Vector2d residual(contact.penetration - penetration,
                                       contact.direction.dot(t) * longest_step);
        if (residual.norm() < 1e-14 * longest_step)
          return better;
        Eigen::Matrix2d jacobian;
        jacobian << contact.d_penetration.head<2>(),
          longest_step * t.transpose() * contact.d_direction.leftCols<2>();
        better -= jacobian.partialPivLu().solve(residual);
        if (!((better - e).norm() < 0.1 * longest_step))
          return e;
        if (residual.norm() < 1e-10 * longest_step)
          return better;
      }
    return e;
  }



  Eigen::Vector2d
  PinInBore::find_farthest_step(const Eigen::Vector2d &e,
                                const double           alpha,
                                const Eigen::Vector2d &direction,
                                const double           penetration) const
  {
    // Point i lets the pin go on by the step s if d_i . s <= g_i.
    const Eigen::ArrayXd  x = table_x - e.x(), y = table_y - e.y();
    const Eigen::ArrayXd  distance = (x.square() + y.square()).sqrt();
    Eigen::ArrayXd        g        = distance - radius + penetration;
    const Eigen::Vector2d t        = perpendicular(direction);
    if (surfaces.pin_wear.is_constant())
      g += surfaces.pin_wear.mean();
    else
      for (Eigen::Index i = 0; i < g.size(); ++i)
        g(i) += surfaces.pin_wear.value(std::atan2(y(i), x(i)) - alpha);
    const Eigen::ArrayXd d_n =
      (x * direction.x() + y * direction.y()) / distance;
    const Eigen::ArrayXd d_t = (x * t.x() + y * t.y()) / distance;

    // Along the direction it can go by the least (g_i - w d_t) / d_n, a concave
    // function of the step w across; its peak is where two of these lines
    // meet.
    struct Line
    {
      double value, slope;
    };
    const auto lowest = [&](const double w) {
      Eigen::Index i = 0;
      (d_n > 1e-6)
        .select((g - w * d_t) / d_n, std::numeric_limits<double>::max())
        .minCoeff(&i);
      return Line{g(i) / d_n(i), -d_t(i) / d_n(i)};
    };
    const double width = 4. * g.abs().maxCoeff() + penetration;
    Line         left = lowest(-width), right = lowest(width);
    double       w = 0.;
    for (unsigned int k = 0; k < 100; ++k)
      {
        if (!(left.slope > right.slope))
          break;
        w = (right.value - left.value) / (left.slope - right.slope);
        const Line   here = lowest(w);
        const double gain =
          left.value + left.slope * w - (here.value + here.slope * w);
        if (!(gain > 1e-14 * width))
          break;
        (here.slope > 0. ? left : right) = here;
      }
    const Line here = lowest(w);
    return (here.value + here.slope * w) * direction + w * t;
  }
} // namespace Tribody
