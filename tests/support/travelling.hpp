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
  double half_width = 10e-3;            // m, in 3D
  double spacing = 1e-3;                // m
  double standoff = 3e-3;               // m, beyond the reach of the slab's particles
  double poisson_ratio = 0.4;
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
standoff = "{} m"
spacing = "0.8 mm"
position = {}
{}
[materials.curd]
base = "tofu"
poisson_ratio = {}
artificial_linear = 0.2
artificial_quadratic = 0.5
{}
[workpiece]
material = "curd"
size = {}
minimum = {}
maximum = {}
spacing = "{} m"
{}
[time]
{}
{})",
        dimension, standoff, corner(-100e-3, 0.0, 0.0), machine, poisson_ratio, material,
        corner(0.4, thickness, 0.1), corner(low, -thickness, -half_width),
        corner(high, 0.0, half_width), spacing, frame, time, rest);
  }
  Case read() const { return parse_case(text(), "travelling.toml"); }
};

// Returns a graded, nearly incompressible one in 3D.
inline TravellingText graded_window() {
  TravellingText text;
  text.dimension = 3;
  text.spacing = 2e-3;
  text.half_width = 16e-3;
  text.standoff = 6e-3;
  text.poisson_ratio = 0.49;
  text.frame = "frame = \"travelling\"\nshift = \"8 mm\"\nlevels = 1\ngrading_width = \"4 mm\"";
  return text;
}

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
