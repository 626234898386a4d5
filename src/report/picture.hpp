// SPDX-License-Identifier: Apache-2.0
// Pictures of a frame in the paper's colours: particles are discs of their spacing at true scale.
// In 3D an oblique view with the front half cut away stands beside a thin slice through the axis.
#pragma once

#include <string>

#include "case/case.hpp"
#include "simulation/frame.hpp"

namespace kerf {

// The part of the world that pictures of a case show: its bodies and jets with a margin, within the
// domain. It is the same for every frame.
Box picture_window(const Case& description);

// The bytes of a PNG file; `scale` shrinks it.
std::string draw_picture(const Frame& frame, const Case& description, double scale = 1.0);

}  // namespace kerf
