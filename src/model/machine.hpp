// SPDX-License-Identifier: Apache-2.0
// The settings of a water-jet machine, as plain data in SI units. src/machine/ computes the jet of
// a case from them.
#pragma once

#include <array>
#include <string_view>

#include "model/point.hpp"

namespace kerf {

enum class OrificeType { sharp, conical, slit, fan };
inline constexpr std::array<std::string_view, 4> orifice_words{"sharp", "conical", "slit", "fan"};

// What the nozzle does in the run: it stands still where the workpiece is cut long before the
// nozzle has moved by the width of its jet.
enum class NozzleMotion { automatic, travelling, standing };
inline constexpr std::array<std::string_view, 3> nozzle_motion_words{"auto", "travelling",
                                                                     "standing"};

struct Machine {
  double pressure = 0.0;  // Pa, at the orifice, above that of the air
  OrificeType orifice_type = OrificeType::sharp;
  double orifice_diameter = 0.0;       // m; of a slit or fan, its width
  double orifice_length = 0.0;         // m, of a slit or fan, in 3D
  double cone_angle = 0.0;             // rad, between the wall and the axis
  double fan_angle = 0.0;              // rad, from side to side of the sheet of a fan
  double velocity_coefficient = 0.0;   // 1, speed over that without friction
  double discharge_coefficient = 0.0;  // 1, flow over that of the full area without friction
  double coherent_length = 0.0;        // m, up to which a jet in air stays intact; infinity: always
  double standoff = 0.0;               // m
  Point position{};                    // m, the point on the workpiece that it aims at
  double lead_angle = 0.0;             // rad, the jet leans forwards along the traverse
  double tilt_angle = 0.0;             // rad, and to the right of it
  double traverse_speed = 0.0;         // m/s
  Point traverse_direction{1.0, 0.0, 0.0};  // unit vector, horizontal
  NozzleMotion motion = NozzleMotion::travelling;
  double dwell = 0.0;            // s, before the traverse begins
  double pulse_frequency = 0.0;  // Hz, 0 = a steady jet
  double duty = 1.0;             // 1, part of a pulse in which water flows
  double spacing = 0.0;          // m, of the water's particles
  int material = -1;             // index into Case::materials
  bool is_pulsed() const { return pulse_frequency > 0.0 && duty < 1.0; }
  bool operator==(const Machine&) const = default;
};

}  // namespace kerf
