// SPDX-License-Identifier: Apache-2.0
// This header defines the colours of pictures and curves. Particles have those of Shinohara et al.
// (2004): water green, solid red, fractured blue, plate yellow; their lightness differs as well
// (light, dark, middle, bright), for readers with red-green blindness. Curves have the palette of
// Okabe & Ito (2008), designed for colour blindness.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "simulation/frame.hpp"

namespace kerf {

struct Colour {
  double red = 0.0, green = 0.0, blue = 0.0;  // 0 to 1
};

constexpr Colour rgb(int code) {
  return {((code >> 16) & 255) / 255.0, ((code >> 8) & 255) / 255.0, (code & 255) / 255.0};
}

// Returns the colour as a page writes it: "#22272e".
inline std::string hex(Colour colour) {
  const auto byte = [](double share) { return static_cast<int>(std::lround(255.0 * share)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.red), byte(colour.green),
                     byte(colour.blue));
}

namespace palette {
inline constexpr Colour water = rgb(0x5cc48a);
inline constexpr Colour water_in_nozzle = rgb(0xb4e2c8);
inline constexpr Colour solid = rgb(0xb3262a);
inline constexpr Colour fractured = rgb(0x2b62d9);
inline constexpr Colour plate = rgb(0xf0c52e);
inline constexpr Colour ink = rgb(0x22272e);
inline constexpr Colour faint = rgb(0x8a929c);
inline constexpr Colour grid = rgb(0xe3e6ea);
inline constexpr Colour paper = rgb(0xffffff);
inline constexpr Colour failed = rgb(0x9a3412);
inline constexpr std::array<Colour, 8> curves = {rgb(0x0072b2), rgb(0xd55e00), rgb(0x009e73),
                                                 rgb(0xcc79a7), rgb(0xe69f00), rgb(0x56b4e9),
                                                 rgb(0x7a6a00), rgb(0x444b54)};
}  // namespace palette

inline Colour colour_of(Category category, bool upstream) {
  switch (category) {
    case Category::water:
      return upstream ? palette::water_in_nozzle : palette::water;
    case Category::solid:
      return palette::solid;
    case Category::fractured:
      return palette::fractured;
    case Category::rigid:
      return palette::plate;
  }
  return palette::ink;
}

}  // namespace kerf
