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
#include "verification/plan.hpp"

namespace kerf {

namespace {

bool has_mesh(const Shape& shape) {
  return shape.kind == Shape::Kind::mesh ||
         std::any_of(shape.parts.begin(), shape.parts.end(), has_mesh);
}

bool is_straight_down_or_in_plane(const Jet& jet) {
  return std::sin(jet.angle) == 0.0 || std::abs(std::sin(jet.azimuth)) < 1e-12;
}

// Returns the first reason of a case against a placement; empty if there is none.
std::string refusal(const PlacementRefusals& refuses, const Placement& placement) {
  if (placement.angle != 0.0 && !refuses.turned.empty()) return refuses.turned;
  if (placement.mirrored && !refuses.mirrored.empty()) return refuses.mirrored;
  if (placement.moved != 0.0 && !refuses.moved.empty()) return refuses.moved;
  if (placement.standoff != 1.0) return refuses.standoff;
  return "";
}

// Returns the parts of a placement, and calls refused(part alone, problem) for the others.
// problem(placement) is empty for what is allowed.
template <class Problem, class Refused>
Placement part_without(const Problem& problem, const Placement& placement, const Refused& refused) {
  Placement allowed;
  const auto add = [&](auto part) {
    Placement more = allowed, alone;
    more.*part = alone.*part = placement.*part;
    const std::string reason = problem(more);
    if (reason.empty())
      allowed = more;
    else
      refused(alone, reason);
  };
  add(&Placement::angle);
  add(&Placement::mirrored);
  add(&Placement::moved);
  add(&Placement::standoff);
  return allowed;
}

// Returns what a verification case says against placements.
class Problems {
 public:
  explicit Problems(const VerificationCase& verification) : refuses_(verification.refuses) {
    for (const PlannedRun& run : verification.runs) runs_.push_back(run.description());
  }
  std::string operator()(const Placement& placement) const {
    std::string problem = refusal(refuses_, placement);
    for (const Case& run : runs_)
      if (problem.empty()) problem = placement_problem(run, placement);
    return problem;
  }

 private:
  const PlacementRefusals& refuses_;
  std::vector<Case> runs_;
};

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
  return part_without([&](const Placement& part) { return placement_problem(description, part); },
                      placement, [](const Placement&, const std::string&) {});
}

std::string placement_problem(const VerificationCase& verification, const Placement& placement) {
  return Problems(verification)(placement);
}

Placement allowed_part(const VerificationCase& verification, const Placement& placement) {
  return part_without(Problems(verification), placement,
                      [](const Placement&, const std::string&) {});
}

std::string allowed_text(const VerificationCase& verification, const Placement& placement) {
  std::string others;
  const Placement allowed = part_without(
      Problems(verification), placement, [&](const Placement& part, const std::string& reason) {
        others += fmt::format("; not {}: {}", part.text(), reason);
      });
  return allowed.text() + others;
}

}  // namespace kerf
