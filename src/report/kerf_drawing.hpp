// SPDX-License-Identifier: Apache-2.0
// The cross-section of a kerf with its dimensions, as an SVG element.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "case/case.hpp"
#include "report/palette.hpp"

namespace kerf {

// What the shape of a kerf does not say.
struct KerfSetting {
  double lean = 0.0;  // rad, of the jet from the vertical: positive = its water flies to the right
  bool parted = false;  // the workpiece came apart, by a crack where the kerf does not go through
};

// In the plane of the drawing: that of a 2D case; in 3D across the way of the nozzle, seen along
// it, or through the jet and the vertical where the nozzle stands still.
double lean_of(const Jet& jet, int dimension);

// `kerf` as in result.json; empty where there is none.
std::string draw_kerf(const nlohmann::ordered_json& kerf, const KerfSetting& setting = {});

// Of its lines, for a legend.
inline constexpr Colour kerf_jet_colour = rgb(0x1f7a4d), kerf_crack_colour = rgb(0x2b62d9);

}  // namespace kerf
