// SPDX-License-Identifier: Apache-2.0
#include "analysis/opening_width.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/cell_share.hpp"
#include "analysis/kerf_axes.hpp"
#include "analysis/kerf_sections.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

using Vector3 = std::array<double, 3>;

constexpr int lines_around = 8;          // over half a turn
constexpr std::size_t most_places = 16;  // on the path of a nozzle

// A particle of a layer across the jet.
struct LayerPoint {
  Vector3 from_aim{};  // m
  double size = 0.0;   // m
  double share = 1.0;  // 1, of it that lies in the layer
};

// The particles that determine an opening at a depth.
struct OpeningLayer {
  std::vector<LayerPoint> gone;      // as laid out, of the fractured and what has left
  std::vector<LayerPoint> laid_out;  // as laid out, of all
  std::vector<LayerPoint> at_first;  // as laid out, of counted pieces
  std::vector<LayerPoint> standing;  // now, of counted pieces
  double thickness = 0.0;            // m, in which `gone` is counted
};

LayerPoint point_of(const JetAxis& jet, const Vector3& x, double size) {
  return {{x[0] - jet.aim[0], x[1] - jet.aim[1], x[2] - jet.aim[2]}, size};
}

OpeningLayer layer_at(const Workpiece& workpiece, const Frame& frame,
                      const std::vector<std::uint32_t>& rows,
                      const std::vector<std::uint8_t>& in_piece, const OpeningProbe& probe) {
  const JetAxis& jet = *workpiece.jet;
  OpeningLayer layer;
  layer.thickness = std::max(jet.width / 2.0, 2.0 * workpiece.axis_spacing);
  for (std::size_t slot = 0; slot < rows.size(); ++slot) {
    const Vector3& x = workpiece.position[slot];
    LayerPoint point = point_of(jet, x, workpiece.size[slot]);
    const double below = jet.depth(x) - probe.depth;
    if (std::abs(below) <= point.size) {
      layer.laid_out.push_back(point);
      if (workpiece.initially_in_piece[slot]) layer.at_first.push_back(point);
    }
    point.share = cell_share(below, point.size, layer.thickness);
    if (point.share > 0.0 && !is_intact(frame, rows[slot])) layer.gone.push_back(point);
    if (!in_piece[slot]) continue;
    const Vector3& now = frame.position[rows[slot]];
    if (std::abs(jet.depth(now) - probe.depth_now) <= point.size)
      layer.standing.push_back(point_of(jet, now, point.size));
  }
  return layer;
}

// A section of the opening: a line across the axis at a place.
struct OpeningSection {
  const OpeningLine& line;
  const Vector3& place;

  double offset(const LayerPoint& point) const { return project(point, line.along); }
  double side(const LayerPoint& point) const { return project(point, line.aside); }
  bool holds(const LayerPoint& point) const { return std::abs(side(point)) <= point.size; }

 private:
  double project(const LayerPoint& point, const Vector3& direction) const {
    double sum = 0.0;
    for (std::size_t a = 0; a < 3; ++a) sum += (point.from_aim[a] - place[a]) * direction[a];
    return sum;
  }
};

// Lengths on both sides of the axis, m.
struct BothSides {
  double left = 0.0, right = 0.0;
};

double fractured_width(const OpeningLayer& layer, const OpeningSection& section, bool is_plane) {
  double area = 0.0;
  for (const LayerPoint& point : layer.gone) {
    // The section across a round jet is a strip of that thickness through the axis.
    const double strip = is_plane ? 1.0
                                  : cell_share(section.side(point), point.size, layer.thickness) *
                                        point.size / layer.thickness;
    area += point.size * point.size * point.share * strip;
  }
  return area / layer.thickness;
}

// Returns the distances of the nearest faces of the particles; infinite on a side without any.
BothSides nearest_faces(const std::vector<LayerPoint>& points, const OpeningSection& section) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  BothSides nearest{endless, endless};
  for (const LayerPoint& point : points) {
    if (!section.holds(point)) continue;
    const double offset = section.offset(point);
    double& side = offset >= 0.0 ? nearest.right : nearest.left;
    side = std::min(side, std::max(0.0, std::abs(offset) - point.size / 2.0));
  }
  return nearest;
}

// Extends the edges to the faces of a particle in the section.
void extend(BothSides& edges, const LayerPoint& point, const OpeningSection& section) {
  if (!section.holds(point)) return;
  edges.right = std::max(edges.right, section.offset(point) + point.size / 2.0);
  edges.left = std::max(edges.left, -section.offset(point) + point.size / 2.0);
}

// Returns the distances of the edges of the workpiece as laid out: in the layer, and where a void
// leaves this empty on a side, at any depth.
BothSides edges_of(const Workpiece& workpiece, const OpeningLayer& layer,
                   const OpeningSection& section) {
  BothSides edges, whole;
  for (const LayerPoint& point : layer.laid_out) extend(edges, point, section);
  if (edges.left > 0.0 && edges.right > 0.0) return edges;
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot)
    extend(whole, point_of(*workpiece.jet, workpiece.position[slot], workpiece.size[slot]),
           section);
  return {edges.left > 0.0 ? edges.left : whole.left,
          edges.right > 0.0 ? edges.right : whole.right};
}

OpeningWidths widths_in(const Workpiece& workpiece, const OpeningLayer& layer,
                        const OpeningSection& section) {
  BothSides now = nearest_faces(layer.standing, section);
  BothSides before = nearest_faces(layer.at_first, section);
  const double endless = std::numeric_limits<double>::infinity();
  if (std::max({now.left, now.right, before.left, before.right}) == endless) {
    const BothSides edges = edges_of(workpiece, layer, section);
    for (BothSides* sides : {&now, &before}) {
      if (sides->left == endless) sides->left = edges.left;
      if (sides->right == endless) sides->right = edges.right;
    }
  }
  // Between the particles of a lattice the axis is up to one spacing from the nearest.
  const auto empty = [&](double side) { return side > workpiece.axis_spacing ? side : 0.0; };
  return {fractured_width(layer, section, workpiece.dimension == 2), now.left + now.right,
          empty(before.left) + empty(before.right)};
}

// Whether solid is laid out in the way of the jet at a place of its axis.
bool meets_solid(const Workpiece& workpiece, const Vector3& place) {
  JetAxis jet = *workpiece.jet;
  for (std::size_t a = 0; a < 3; ++a) jet.aim[a] += place[a];
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot)
    if (jet.distance(workpiece.position[slot]) <= in_way_reach(jet.width, workpiece.size[slot]))
      return true;
  return false;
}

}  // namespace

std::vector<OpeningLine> opening_lines(const Case& description, const JetAxis& jet) {
  if (description.dimension == 2) return {{jet.across, {}}};
  const KerfAxes path(jet, description.jets.front().traverse, description.dimension);
  if (path.moves()) return {{path.unit_crosswise, path.unit_lengthwise}};
  if (description.machine && description.machine->traverse_speed > 0.0) {
    const KerfAxes feed(jet, description.machine->traverse_direction, description.dimension);
    if (feed.moves()) return {{feed.unit_lengthwise, feed.unit_crosswise}};
  }
  std::vector<OpeningLine> lines(lines_around);
  for (int n = 0; n < lines_around; ++n) {
    const double turn = n * std::numbers::pi / lines_around;
    const double c = std::cos(turn), s = std::sin(turn);
    for (std::size_t a = 0; a < 3; ++a) {
      lines[std::size_t(n)].along[a] = c * jet.across[a] + s * jet.sideways[a];
      lines[std::size_t(n)].aside[a] = c * jet.sideways[a] - s * jet.across[a];
    }
  }
  return lines;
}

std::vector<Vector3> opening_places(const Workpiece& workpiece, double from, double until) {
  const JetAxis& jet = *workpiece.jet;
  const double speed = std::hypot(jet.travel[0], jet.travel[1], jet.travel[2]);
  if (workpiece.dimension == 2 || !(speed > 0.0)) return {{}};
  const double first = std::max(0.0, from - jet.moves_from);
  const double last = std::max(first, until - jet.moves_from);
  const double steps = std::ceil(speed * (last - first) / workpiece.axis_spacing);
  const auto count = static_cast<std::size_t>(std::clamp(steps, 1.0, double(most_places)));
  std::vector<Vector3> places(count);
  for (std::size_t n = 0; n < count; ++n)
    for (std::size_t a = 0; a < 3; ++a)
      places[n][a] = (first + (n + 0.5) / count * (last - first)) * jet.travel[a];
  if (count > 1)
    std::erase_if(places, [&](const Vector3& x) { return !meets_solid(workpiece, x); });
  return places;
}

OpeningWidths measure_opening(const Workpiece& workpiece, const Frame& frame,
                              const std::vector<std::uint32_t>& rows,
                              const std::vector<std::uint8_t>& in_piece,
                              const OpeningProbe& probe) {
  const OpeningLayer layer = layer_at(workpiece, frame, rows, in_piece, probe);
  const auto count = static_cast<double>(probe.lines.size());
  std::vector<double> fractured, open, laid_out;
  for (const Vector3& place : probe.places) {
    OpeningWidths mean;
    for (const OpeningLine& line : probe.lines) {
      const OpeningWidths widths = widths_in(workpiece, layer, {line, place});
      mean.fractured += widths.fractured / count;
      mean.open += widths.open / count;
      mean.laid_out += widths.laid_out / count;
    }
    fractured.push_back(mean.fractured);
    open.push_back(mean.open);
    laid_out.push_back(mean.laid_out);
  }
  return {median(std::move(fractured)), median(std::move(open)), median(std::move(laid_out))};
}

}  // namespace kerf
