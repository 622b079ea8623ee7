// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_output_mechanism_vtu_h
#define tribody_output_mechanism_vtu_h

#include <Eigen/Core>

#include <string>
#include <vector>

namespace Tribody
{
  namespace Output
  {
    /// What a line in the picture of a mechanism stands for.
    enum class MechanismPart
    {
      /// Between the markers of a body.
      link = 0,
      /// Surface of a pin.
      pin = 1,
      /// Surface of a bushing.
      bushing = 2,
      /// Axis of a translational joint.
      guide  = 3,
      spring = 4,
      /// Where a joint is: the only part with a force.
      joint = 5
    };

    /// A line in the picture of a mechanism at one moment.
    struct MechanismLine
    {
      /// Two or more, global axes [m].
      std::vector<Eigen::Vector2d> points;
      /// What the line shows, to colour by.
      MechanismPart part = MechanismPart::link;
      /// Number of the body that it moves with; -1: the ground.
      int body = -1;
      /// Number of the joint that it belongs to; -1: none.
      int joint = -1;
      /// Of the first body on the second, global axes [N].
      Eigen::Vector2d force = Eigen::Vector2d::Zero();
    };

    /**
     * Write a VTU file for ParaView: the @p lines with the fields part, body
     * and joint to colour by, and the vector force.
     *
     * @throws ExcRun if the file cannot be written.
     */
    void
    write_mechanism_vtu(const std::string                &file_name,
                        const std::vector<MechanismLine> &lines);
  } // namespace Output
} // namespace Tribody

#endif
