// SPDX-License-Identifier: Apache-2.0
// Small cases of a jet that traverses a soft slab: in a frame that travels with it, and in one long
// block.
#pragma once

#include <fmt/format.h>

#include <string>

#include "input/read.hpp"
#include "machine/travelling_frame.hpp"
#include "model/case.hpp"

namespace kerf::test {

// What differs between these cases.
struct TravellingText {
  int dimension = 2;
  std::string machine = "traverse_speed = \"10 m/s\"";
  std::string frame = "frame = \"travelling\"\nshift = \"5 mm\"";
  double low = -120e-3, high = -80e-3;  // m, the window at the start, along x
  double thickness = 12e-3;             // m
  std::string time = "end = \"3 ms\"";
  std::string rest;       // of the case
  std::string material =  // keys
      "criterion = \"crack_band\"\nfailure_strain = 0.05\nfracture_energy = \"10 J/m2\"";

  std::string text() const {
    const bool flat = dimension == 2;
    const auto corner = [&](double x, double y, double z) {
      return flat ? fmt::format("[\"{} m\", \"{} m\"]", x, y)
                  : fmt::format("[\"{} m\", \"{} m\", \"{} m\"]", x, y, z);
    };
    return fmt::format(
        R"(title = "a frame that travels"
dimension = {}
quality = "draft"
[machine]
pressure = "0.2 MPa"
orifice_diameter = "4 mm"
orifice_type = "conical"
cone_angle = "20 deg"
standoff = "3 mm"
spacing = "0.8 mm"
position = {}
{}
[materials.curd]
base = "tofu"
poisson_ratio = 0.4
artificial_linear = 0.2
artificial_quadratic = 0.5
{}
[workpiece]
material = "curd"
size = {}
minimum = {}
maximum = {}
spacing = "1 mm"
{}
[time]
{}
{})",
        dimension, corner(-100e-3, 0.0, 0.0), machine, material, corner(0.4, thickness, 0.1),
        corner(low, -thickness, -10e-3), corner(high, 0.0, 10e-3), frame, time, rest);
  }
  Case read() const { return parse_case(text(), "travelling.toml"); }
};

// Returns the same slab as one block that has the places of all windows.
inline TravellingText long_block(TravellingText text) {
  const auto frame = travelling_frame(text.read());
  text.low = frame->path.minimum[0];
  text.high = frame->path.maximum[0];
  text.frame = "frame = \"fixed\"\nlevels = 0";
  text.machine += "\nmotion = \"travelling\"";
  return text;
}

}  // namespace kerf::test
