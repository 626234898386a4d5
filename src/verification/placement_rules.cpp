// SPDX-License-Identifier: Apache-2.0
// The text of a placement, its choice at random, and the placements that a case allows.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "model/case.hpp"
#include "verification/placement.hpp"

namespace kerf {

namespace {

bool has_mesh(const Shape& shape) {
  return shape.kind == Shape::Kind::mesh ||
         std::any_of(shape.parts.begin(), shape.parts.end(), has_mesh);
}

bool is_straight_down_or_in_plane(const Jet& jet) {
  return std::sin(jet.angle) == 0.0 || std::abs(std::sin(jet.azimuth)) < 1e-12;
}

}  // namespace

std::string Placement::text() const {
  std::vector<std::string> parts;
  if (angle != 0.0)
    parts.push_back(fmt::format("turned {:.4g} deg", angle * 180.0 / std::numbers::pi));
  if (mirrored) parts.push_back("mirrored");
  if (moved != 0.0) parts.push_back(fmt::format("moved {:.3g} d", moved));
  if (standoff != 1.0) parts.push_back(fmt::format("standoff x {:.3g}", standoff));
  return parts.empty() ? "as written" : fmt::format("{}", fmt::join(parts, ", "));
}

Placement random_placement(const std::string& text) {
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a
  for (const unsigned char letter : text) hash = (hash ^ letter) * 1099511628211u;
  std::mt19937_64 engine(hash);
  const auto draw = [&engine] { return static_cast<double>(engine() >> 11) * 0x1p-53; };  // [0, 1)
  Placement placement;
  placement.angle = (2.0 * draw() - 1.0) * std::numbers::pi;
  placement.mirrored = draw() < 0.5;
  placement.moved = draw() - 0.5;
  placement.standoff = 1.0 + 0.5 * draw();
  return placement;
}

std::string placement_problem(const Case& description, const Placement& placement) {
  const bool is_turned = placement.angle != 0.0;
  const auto& bodies = description.bodies;
  if (description.machine) return "it states a machine";
  if ((placement.moved != 0.0 || placement.standoff != 1.0) && description.jets.empty())
    return "it has no jet";
  if (is_turned && description.symmetry.any()) return "it has symmetry planes";
  for (const Body& body : bodies) {
    if (is_turned && body.absorbing.any()) return "it has absorbing faces";
    if ((is_turned || placement.mirrored) && has_mesh(body.shape)) return "it has a mesh";
    if (is_turned && body.role == Role::rigid &&
        description.formulation == Formulation::shinohara2004 &&
        body.repelling_layer != RepellingLayer::all)
      return "one side of a rigid body repels";
  }
  const auto in_plane = [](const Jet& jet) { return is_straight_down_or_in_plane(jet); };
  if ((is_turned || placement.mirrored) &&
      !std::all_of(description.jets.begin(), description.jets.end(), in_plane))
    return "a jet leans out of the plane of x and y";
  return "";
}

Placement allowed_part(const Case& description, const Placement& placement) {
  Placement allowed;
  const auto add = [&](auto part) {
    Placement more = allowed;
    more.*part = placement.*part;
    if (placement_problem(description, more).empty()) allowed = more;
  };
  add(&Placement::angle);
  add(&Placement::mirrored);
  add(&Placement::moved);
  add(&Placement::standoff);
  return allowed;
}

}  // namespace kerf
