// SPDX-License-Identifier: Apache-2.0
// This header declares the drawing of a kerf: its cross-section with dimensions, as an SVG element.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "report/palette.hpp"

namespace kerf {

struct Jet;

// The data of the drawing besides the shape of the kerf.
struct KerfSetting {
  double lean = 0.0;    // rad, of the jet from the vertical; positive = towards the right
  bool parted = false;  // the workpiece is in two, by a crack where the kerf does not go through
};

// Returns the angle of the jet in the plane of the drawing, rad. That is the plane of a 2D case; in
// 3D the plane across the traverse of the nozzle, or through the jet and the vertical where the
// nozzle stands still.
double lean_of(const Jet& jet, int dimension);

// Draws the object `kerf` of result.json; the text is empty where nothing was cut.
std::string draw_kerf(const nlohmann::ordered_json& kerf, const KerfSetting& setting = {});

// The colours of the lines, for a legend.
inline constexpr Colour kerf_jet_colour = rgb(0x1f7a4d), kerf_crack_colour = rgb(0x2b62d9);

}  // namespace kerf
