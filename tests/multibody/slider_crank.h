// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_multibody_slider_crank_h
#define tests_multibody_slider_crank_h

#include <tribody/multibody/cycle/cycle_simulation.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/system/mechanism.h>

#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

/**
 * The paper's two slider-cranks (design.md, section 9). Links have their
 * centre of mass in the middle; "half length" means that the printed length is
 * that from joint to centre of mass, so that the links are twice as long.
 */
namespace SliderCrank
{
  using namespace Tribody;
  using namespace Tribody::Multibody;

  struct Numbers
  {
    double crank_length, follower_length;
    double crank_mass, follower_mass, slider_mass;
    double crank_inertia, follower_inertia;
    double spring_stiffness, spring_force;
  };

  inline MechanismParameters
  make(const Numbers &x, const double length_factor, const double speed = M_PI)
  {
    const double        a    = length_factor * x.crank_length;
    const double        l    = length_factor * x.follower_length;
    const double        wall = 10.;
    MechanismParameters p;
    p.ground.markers = {{"O", {0., 0.}}, {"W", {wall, 0.}}};

    BodyParameters crank;
    crank.name              = "crank";
    crank.mass              = x.crank_mass;
    crank.moment_of_inertia = x.crank_inertia;
    crank.markers           = {{"O", {-a / 2, 0.}}, {"A", {a / 2, 0.}}};
    crank.initial_position  = {a / 2, 0.};
    BodyParameters follower;
    follower.name              = "follower";
    follower.mass              = x.follower_mass;
    follower.moment_of_inertia = x.follower_inertia;
    follower.markers           = {{"A", {-l / 2, 0.}}, {"B", {l / 2, 0.}}};
    follower.initial_position  = {a + l / 2, 0.};
    BodyParameters slider;
    slider.name              = "slider";
    slider.mass              = x.slider_mass;
    slider.moment_of_inertia = 1e-3;
    slider.markers           = {{"B", {0., 0.}}};
    slider.initial_position  = {a + l, 0.};
    p.bodies                 = {crank, follower, slider};

    JointParameters ground_pin;
    ground_pin.name           = "ground_pin";
    ground_pin.pin_marker     = "ground.O";
    ground_pin.bushing_marker = "crank.O";
    JointParameters crank_pin;
    crank_pin.name           = "crank_pin";
    crank_pin.pin_marker     = "crank.A";
    crank_pin.bushing_marker = "follower.A";
    JointParameters wrist_pin;
    wrist_pin.name           = "wrist_pin";
    wrist_pin.pin_marker     = "slider.B";
    wrist_pin.bushing_marker = "follower.B";
    JointParameters guide;
    guide.name          = "guide";
    guide.type          = JointType::translational;
    guide.first_marker  = "ground.O";
    guide.second_marker = "slider.B";
    p.joints            = {ground_pin, crank_pin, wrist_pin, guide};

    if (x.spring_stiffness > 0)
      {
        SpringParameters spring;
        spring.name                      = "spring";
        spring.first_marker              = "slider.B";
        spring.second_marker             = "ground.W";
        spring.stiffness                 = x.spring_stiffness;
        spring.reference_length          = wall - l;
        spring.force_at_reference_length = x.spring_force;
        p.springs                        = {spring};
      }

    DriverParameters motor;
    motor.name  = "motor";
    motor.body  = "crank";
    motor.speed = speed;
    p.drivers   = {motor};
    return p;
  }

  /// Tables 3-5; the spring pulls the slider away from the crank.
  inline MechanismParameters
  validation(const double length_factor)
  {
    return make(
      {0.0381, 0.1016, 0.4045, 0.8175, 5.5487, 204e-6, 5500e-6, 525.4, 90.},
      length_factor);
  }

  /// Tables 1-2.
  inline MechanismParameters
  steel(const double length_factor)
  {
    return make({1., 1.75, 25., 35., 25., 45., 35., 0., 0.}, length_factor);
  }

  /// Give joint number @p joint of @p p the clearance of Tables 1-2.
  inline void
  add_steel_clearance(MechanismParameters &p,
                      const unsigned int   joint,
                      const double         bushing_radius)
  {
    JointParameters &j            = p.joints[joint];
    j.model                       = JointModel::clearance;
    j.pin_radius                  = 20e-3;
    j.bushing_radius              = bushing_radius;
    j.pin_material.name           = "steel";
    j.pin_material.youngs_modulus = 206.8e9;
    j.pin_material.poissons_ratio = 0.29;
    j.bushing_material            = j.pin_material;
  }

  /// Give joint number @p joint of @p p the clearance of Tables 3-5, steel in
  /// PTFE.
  inline void
  add_ptfe_clearance(MechanismParameters &p, const unsigned int joint)
  {
    JointParameters &j                = p.joints[joint];
    j.model                           = JointModel::clearance;
    j.pin_radius                      = 9.525e-3;
    j.bushing_radius                  = 9.535e-3;
    j.pin_material.name               = "steel";
    j.pin_material.youngs_modulus     = 206.8e9;
    j.pin_material.poissons_ratio     = 0.29;
    j.bushing_material.name           = "PTFE";
    j.bushing_material.youngs_modulus = 0.139e9;
    j.bushing_material.poissons_ratio = 0.38;
  }

  /// Radius of the bushing of joint number @p joint [m].
  inline double
  joint_radius(const Mechanism &mechanism, const unsigned int joint)
  {
    return mechanism.joints()[joint].bushing_radius;
  }

  /// The rows of a reference table, without comments and the header.
  inline std::vector<std::vector<double>>
  read_table(const std::string &file_name)
  {
    std::ifstream file(file_name);
    if (!file)
      std::cout << "cannot read " << file_name << std::endl;
    std::vector<std::vector<double>> rows;
    std::string                      line;
    while (std::getline(file, line))
      {
        if (line.empty() || !std::isdigit(line[0]))
          continue;
        std::vector<double> row;
        std::istringstream  in(line);
        std::string         entry;
        while (std::getline(in, entry, ','))
          row.push_back(std::stod(entry));
        rows.push_back(row);
      }
    return rows;
  }
} // namespace SliderCrank

#endif
