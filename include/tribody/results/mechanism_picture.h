// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_results_mechanism_picture_h
#define tribody_results_mechanism_picture_h

#include <Eigen/Core>

#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/output/mechanism_vtu.h>

#include <string>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * Draws a mechanism as it moves through a cycle: a link between the markers
     * of each body, pins and bushings with their radii, axes of translational
     * joints as far as they are used, springs, and the joint forces.
     */
    class MechanismPicture
    {
    public:
      /// Keeps references to both.
      MechanismPicture(const Multibody::Mechanism &mechanism,
                       const Multibody::DutyCycle &cycle);

      /// The lines at sample @p s.
      std::vector<Output::MechanismLine>
      draw(const Eigen::Index s) const;

      /// Which body and joint the numbers in the lines mean, for the reader.
      std::string
      legend() const;

    private:
      // Position of a point of a body at sample s; ground: the point itself.
      Eigen::Vector2d
      position(const int              body,
               const Eigen::Vector2d &point,
               const Eigen::Index     s) const;

      Output::MechanismLine
      draw_body(const int body, const Eigen::Index s) const;

      void
      draw_joint(const unsigned int                  joint,
                 const Eigen::Index                  s,
                 std::vector<Output::MechanismLine> &lines) const;

      Output::MechanismLine
      draw_guide(const unsigned int joint, const Eigen::Index s) const;

      const Multibody::Mechanism &mechanism;
      const Multibody::DutyCycle &cycle;
    };
  } // namespace Coupling
} // namespace Tribody

#endif
