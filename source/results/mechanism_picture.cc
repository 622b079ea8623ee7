// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <tribody/results/mechanism_picture.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Tribody
{
  namespace Coupling
  {
    using Output::MechanismLine;
    using Output::MechanismPart;

    namespace
    {
      // A body with three markers or more is a polygon: its corners in the
      // order of their angle about their middle, the first one twice.
      std::vector<Eigen::Vector2d>
      make_polygon(std::vector<Eigen::Vector2d> corners)
      {
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d &corner : corners)
          middle += corner / corners.size();
        const auto angle = [&](const Eigen::Vector2d &corner) {
          return std::atan2(corner.y() - middle.y(), corner.x() - middle.x());
        };
        std::sort(corners.begin(),
                  corners.end(),
                  [&](const Eigen::Vector2d &a, const Eigen::Vector2d &b) {
                    return angle(a) < angle(b);
                  });
        corners.push_back(corners.front());
        return corners;
      }



      MechanismLine
      make_circle(const Eigen::Vector2d &centre,
                  const double           radius,
                  const double           turned_by)
      {
        constexpr unsigned int n_segments = 72;
        MechanismLine          line;
        for (unsigned int i = 0; i <= n_segments; ++i)
          line.points.push_back(
            centre +
            radius *
              Eigen::Vector2d(
                std::cos(2 * dealii::numbers::PI * i / n_segments + turned_by),
                std::sin(2 * dealii::numbers::PI * i / n_segments +
                         turned_by)));
        return line;
      }
    } // namespace



    MechanismPicture::MechanismPicture(const Multibody::Mechanism &mechanism,
                                       const Multibody::DutyCycle &cycle)
      : mechanism(mechanism)
      , cycle(cycle)
    {}



    Eigen::Vector2d
    MechanismPicture::position(const int              body,
                               const Eigen::Vector2d &point,
                               const Eigen::Index     s) const
    {
      return body == Multibody::ground_body
               ? point
               : Multibody::marker_position(
                   cycle.coordinates.col(s).segment<3>(3 * body), point);
    }



    std::vector<MechanismLine>
    MechanismPicture::draw(const Eigen::Index s) const
    {
      std::vector<MechanismLine> lines;
      for (std::size_t i = 0; i < mechanism.parameters().bodies.size(); ++i)
        {
          const MechanismLine body = draw_body(i, s);
          if (body.points.size() > 1)
            lines.push_back(body);
        }
      for (const Multibody::Spring &spring : mechanism.springs())
        {
          MechanismLine line;
          line.part   = MechanismPart::spring;
          line.points = {position(spring.bodies.first, spring.s_1, s),
                         position(spring.bodies.second, spring.s_2, s)};
          lines.push_back(line);
        }
      for (std::size_t j = 0; j < mechanism.joints().size(); ++j)
        draw_joint(j, s, lines);
      return lines;
    }



    MechanismLine
    MechanismPicture::draw_body(const int body, const Eigen::Index s) const
    {
      MechanismLine line;
      line.body = body;
      for (const auto &[name, point] :
           mechanism.parameters().bodies[body].markers)
        line.points.push_back(position(body, {point[0], point[1]}, s));
      if (line.points.size() == 1)
        line.points.push_back(position(body, Eigen::Vector2d::Zero(), s));
      else if (line.points.size() > 2)
        line.points = make_polygon(line.points);
      return line;
    }



    void
    MechanismPicture::draw_joint(const unsigned int          joint,
                                 const Eigen::Index          s,
                                 std::vector<MechanismLine> &lines) const
    {
      const Multibody::JointEntry      &entry = mechanism.joints()[joint];
      const Multibody::JointParameters &parameters =
        mechanism.parameters().joints[joint];
      const auto angle = [&](const int body) {
        return body == Multibody::ground_body
                 ? 0.
                 : cycle.coordinates(3 * body + 2, s);
      };
      const auto add =
        [&](MechanismLine line, const MechanismPart part, const int body) {
          line.part  = part;
          line.body  = body;
          line.joint = joint;
          lines.push_back(line);
        };
      const Eigen::Vector2d first =
        position(entry.bodies.first, entry.first_position, s);
      const Eigen::Vector2d second =
        position(entry.bodies.second, entry.second_position, s);
      if (entry.is_revolute)
        {
          add(make_circle(first,
                          parameters.pin_radius,
                          angle(entry.bodies.first)),
              MechanismPart::pin,
              entry.bodies.first);
          add(make_circle(second,
                          parameters.bushing_radius,
                          angle(entry.bodies.second)),
              MechanismPart::bushing,
              entry.bodies.second);
        }
      else if (parameters.type != Multibody::JointType::rigid)
        add(draw_guide(joint, s), MechanismPart::guide, entry.bodies.first);

      // A line without length: a point that carries the force.
      MechanismLine point;
      point.points = {second, second};
      point.force  = {cycle.joints[joint].force_x[s],
                      cycle.joints[joint].force_y[s]};
      add(point, MechanismPart::joint, entry.bodies.second);
    }



    MechanismLine
    MechanismPicture::draw_guide(const unsigned int joint,
                                 const Eigen::Index s) const
    {
      const Multibody::JointEntry &entry = mechanism.joints()[joint];
      const double axis_angle = mechanism.parameters().joints[joint].axis_angle;
      const auto   axis       = [&](const Eigen::Index sample) {
        const int body = entry.bodies.first;
        return Multibody::turned(
          Eigen::Vector2d::UnitX(),
          axis_angle + (body == Multibody::ground_body
                                  ? 0.
                                  : cycle.coordinates(3 * body + 2, sample)));
      };
      double begin = 0., end = 0.;
      for (Eigen::Index k = 0; k < cycle.time.size(); ++k)
        {
          const double along = axis(k).dot(
            position(entry.bodies.second, entry.second_position, k) -
            position(entry.bodies.first, entry.first_position, k));
          begin = k == 0 ? along : std::min(begin, along);
          end   = k == 0 ? along : std::max(end, along);
        }
      const Eigen::Vector2d origin =
        position(entry.bodies.first, entry.first_position, s);
      MechanismLine line;
      line.points = {origin + begin * axis(s), origin + end * axis(s)};
      return line;
    }



    std::string
    MechanismPicture::legend() const
    {
      std::ostringstream out;
      out << "The numbers in mechanism.pvd\n"
          << "part 0: link, 1: pin, 2: bushing, 3: guide, 4: spring, 5: joint "
             "(a point that carries the force of the first body on the second, "
             "N, global axes)\n"
          << "body -1: ground\n";
      for (std::size_t i = 0; i < mechanism.parameters().bodies.size(); ++i)
        out << "body " << i << ": " << mechanism.parameters().bodies[i].name
            << '\n';
      for (std::size_t j = 0; j < mechanism.joints().size(); ++j)
        out << "joint " << j << ": " << mechanism.joints()[j].name << '\n';
      return out.str();
    }
  } // namespace Coupling
} // namespace Tribody
