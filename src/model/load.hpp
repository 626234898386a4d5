// SPDX-License-Identifier: Apache-2.0
// This header declares a load on a body of a case as plain data in SI units.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "model/shape.hpp"

namespace kerf {

// Force per area of a face, pressure on a face, or force per mass like that of gravity.
enum class LoadKind { traction, pressure, body_force };
inline constexpr std::array<std::string_view, 3> load_words{"traction", "pressure", "body_force"};

struct Load {
  LoadKind kind = LoadKind::traction;
  std::string body;             // its name
  std::optional<Shape> region;  // of the loaded part of the surface or body; none = all of the body
  Point traction{};             // Pa, force per area as it was at the start
  double pressure = 0.0;        // Pa, follows the surface as it deforms
  Point acceleration{};         // m/s^2
  std::string history = "1";    // 1, the factor of the load, an expression in t (s)
  bool operator==(const Load&) const = default;
};

}  // namespace kerf
