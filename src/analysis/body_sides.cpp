// SPDX-License-Identifier: Apache-2.0
#include "analysis/body_sides.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "analysis/workpiece.hpp"

namespace kerf {
namespace {

constexpr double least_reach = 4.0;    // jet widths
constexpr double least_intact = 0.5;   // of the mass of a layer
constexpr double least_excess = 1.01;  // thickness of a layer over the length of the longest bond

using Labels = std::vector<std::uint32_t>;  // ascending

BodySides divide(const Workpiece& workpiece, std::uint16_t body, const KerfAxes& axes,
                 const SideLayers& layers, double angle) {
  BodySides sides;
  const double c = std::cos(angle), s = std::sin(angle);
  for (std::uint32_t slot = 0; slot < workpiece.position.size(); ++slot) {
    if (workpiece.body[slot] != body) continue;
    const auto x = axes.local(workpiece.position[slot]);
    const double across = c * x[0] + s * x[1];
    const double beside = std::abs(across) - axes.jet.width / 2.0;
    if (beside <= 0.0 || beside > layers.reach) continue;
    const auto layer = static_cast<std::uint16_t>(beside / layers.thickness);
    const std::uint16_t side = across > 0.0 ? 1 : 0;
    sides.members.push_back({slot, side, layer});
    auto& mass = sides.mass[side];
    if (mass.size() <= layer) mass.resize(layer + std::size_t(1), 0.0);
    mass[layer] += workpiece.mass[slot];
  }
  return sides;
}

Labels common(const Labels& a, const Labels& b) {
  Labels both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

// Returns the pieces in each layer of a side that counts and has a piece that reaches the jet, that
// is, the nearest layer that counts.
std::vector<Labels> labels_of(const BodySides& sides, const Workpiece& workpiece,
                              const std::vector<std::uint32_t>& body_piece, std::size_t side) {
  std::vector<Labels> labels(sides.mass[side].size());
  std::vector<double> intact(labels.size(), 0.0);
  for (const BodySides::Member& member : sides.members) {
    if (member.side != side || body_piece[member.slot] == Workpiece::none) continue;
    labels[member.layer].push_back(body_piece[member.slot]);
    intact[member.layer] += workpiece.mass[member.slot];
  }
  std::vector<Labels> counted;
  for (std::size_t layer = 0; layer < labels.size(); ++layer) {
    if (intact[layer] <= 0.0 || intact[layer] < least_intact * sides.mass[side][layer]) continue;
    std::sort(labels[layer].begin(), labels[layer].end());
    labels[layer].erase(std::unique(labels[layer].begin(), labels[layer].end()),
                        labels[layer].end());
    if (counted.empty() || !common(labels[layer], counted.front()).empty())
      counted.push_back(std::move(labels[layer]));
  }
  return counted;
}

Labels all_of(const std::vector<Labels>& layers) {
  std::set<std::uint32_t> labels;
  for (const Labels& layer : layers) labels.insert(layer.begin(), layer.end());
  return {labels.begin(), labels.end()};
}

}  // namespace

SideLayers side_layers(const Workpiece& workpiece, std::uint16_t body, const KerfAxes& axes) {
  double top = std::numeric_limits<double>::infinity(), bottom = -top, largest = 0.0;
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot) {
    if (workpiece.body[slot] != body) continue;
    const auto x = axes.local(workpiece.position[slot]);
    const double size = workpiece.size[slot];
    largest = std::max(largest, size);
    if (std::hypot(x[0], x[1]) > std::max(axes.jet.width / 2.0, size)) continue;
    top = std::min(top, x[2] - size / 2.0);
    bottom = std::max(bottom, x[2] + size / 2.0);
  }
  return {least_excess * workpiece.interaction_range * largest,
          std::max(bottom - top, least_reach * axes.jet.width), std::max(bottom - top, 0.0)};
}

std::vector<BodySides> find_sides(const Workpiece& workpiece, std::uint16_t body,
                                  const KerfAxes& axes,
                                  const std::vector<std::uint32_t>& body_piece) {
  const SideLayers layers = side_layers(workpiece, body, axes);
  std::vector<BodySides> all;
  const int directions = workpiece.dimension == 3 ? 4 : 1;
  for (int n = 0; n < directions; ++n) {
    BodySides sides = divide(workpiece, body, axes, layers, n * std::numbers::pi / directions);
    if (joint_of(sides, workpiece, body_piece) == Joint::joined) all.push_back(std::move(sides));
  }
  return all;
}

Joint joint_of(const BodySides& sides, const Workpiece& workpiece,
               const std::vector<std::uint32_t>& body_piece) {
  std::array<std::vector<Labels>, 2> layers;
  for (std::size_t side = 0; side < 2; ++side)
    layers[side] = labels_of(sides, workpiece, body_piece, side);
  if (layers[0].empty() || layers[1].empty()) return Joint::unknown;
  // Only pieces that both sides have can join a pair of layers.
  const Labels shared = common(all_of(layers[0]), all_of(layers[1]));
  std::array<std::set<Labels>, 2> different;
  for (std::size_t side = 0; side < 2; ++side)
    for (const Labels& layer : layers[side]) different[side].insert(common(layer, shared));
  for (const Labels& a : different[0])
    for (const Labels& b : different[1])
      if (common(a, b).empty()) return Joint::parted;
  return Joint::joined;
}

}  // namespace kerf
