// SPDX-License-Identifier: Apache-2.0
#include "loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "input/read.hpp"

namespace kerf {
namespace {

constexpr int slab_layers = 4;

constexpr std::string_view head = R"toml(
title = "Benchmark: {load}"
dimension = {dimension}
formulation = "standard"
[time]
end = "1 s"
[materials.bench_water]
base = "water"
sound_speed = "20 m/s"
)toml";

constexpr std::string_view body = R"toml(
[[body]]
name = "layers-from-{bottom}"
material = "{material}"
shape = {{ type = "box", minimum = [{minimum}], maximum = [{maximum}] }}
spacing = "1 mm"
velocity_expression = [{velocity}]
)toml";

// A list of texts in TOML: y and, for each other axis, x.
std::string components(int dimension, const std::string& x, const std::string& y) {
  const std::string in_plane = fmt::format(R"("{}", "{}")", x, y);
  return dimension == 2 ? in_plane : fmt::format(R"({}, "{}")", in_plane, x);
}

const char* material_of(Load load, int slab) {
  const bool wet = load == Load::water || (load == Load::soaked && slab % 2 == 1);
  return wet ? "bench_water" : "tofu";
}

std::string millimetres(int length) {
  return fmt::format("{} mm", length);
}

}  // namespace

const char* load_name(Load load) {
  switch (load) {
    case Load::water:
      return "water";
    case Load::solid:
      return "solid";
    case Load::slabs:
      return "slabs";
    case Load::soaked:
      return "soaked";
  }
  return "unknown";
}

Case load_case(Load load, int dimension, std::size_t particles) {
  const double root = std::pow(static_cast<double>(particles), 1.0 / dimension);
  const int side = std::max(2, static_cast<int>(std::lround(root)));
  const bool whole = load == Load::water || load == Load::solid;
  const int thickness = whole ? side : std::min(slab_layers, side);
  std::string text =
      fmt::format(head, fmt::arg("load", load_name(load)), fmt::arg("dimension", dimension));
  for (int bottom = 0; bottom < side; bottom += thickness) {
    const int top = std::min(bottom + thickness, side);
    // Squeezed by 1 m/s over its height, so that there is pressure in all of it.
    text += fmt::format(
        body, fmt::arg("bottom", bottom),
        fmt::arg("material", material_of(load, bottom / thickness)),
        fmt::arg("minimum", components(dimension, "0 mm", millimetres(bottom))),
        fmt::arg("maximum", components(dimension, millimetres(side), millimetres(top))),
        fmt::arg("velocity", components(dimension, "0", fmt::format("-{}*y", 1000.0 / side))));
  }
  return parse_case(text, "a benchmark's case");
}

}  // namespace kerf
