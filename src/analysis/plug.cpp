// SPDX-License-Identifier: Apache-2.0
#include "analysis/plug.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>
#include <vector>

#include "analysis/body_sides.hpp"
#include "analysis/kerf_sections.hpp"
#include "analysis/pieces.hpp"
#include "analysis/workpiece.hpp"

namespace kerf {
namespace {

constexpr double least_of_rim = 0.5;     // of the mass laid out: intact, in counted pieces
constexpr double least_of_sector = 0.5;  // of the mass of the fullest sector
constexpr double least_of_row = 0.5;     // of the mass of a row of particles as high as at the jet
constexpr std::size_t sectors = 8;       // around the axis, in 3D
constexpr int plug_directions = 16;      // across the jet, in 3D

using PieceSet = std::set<std::uint32_t>;

// A particle of the body as laid out, and its piece now.
struct PlugPoint {
  double across = 0.0, aside = 0.0;       // m, from the axis
  double mass = 0.0;                      // kg (2D: kg/m)
  std::uint32_t piece = Workpiece::none;  // none where it is not intact
  bool is_counted = false;                // in a counted piece
  double radius() const { return std::hypot(across, aside); }
};

struct PlugScene {
  std::vector<PlugPoint> points;
  double half_width = 0.0;  // m, of the jet
  double core = 0.0;        // m, the distance within which solid is on the axis
  double limit = 0.0;       // m, beyond the jet, within which a plug ends
  double band = 0.0;        // m, the breadth of a rim that is looked at
  double spacing = 0.0;     // m

  // Returns the mass of the points with distance(point) of at most `reach` (m), kg.
  template <class Distance>
  double mass_within(double reach, const Distance& distance) const {
    double sum = 0.0;
    for (const PlugPoint& point : points) sum += distance(point) <= reach ? point.mass : 0.0;
    return sum;
  }
  double breadth_at_jet() const { return std::max(half_width, 2.0 * spacing); }
};

// Returns whether two pieces of the body count: a plug and a rim, or two rims. It is quick.
bool has_two_counted(const Workpiece& workpiece, std::uint16_t body, const Pieces& pieces) {
  std::uint32_t first = Workpiece::none;
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot) {
    const std::uint32_t piece = pieces.body_piece[slot];
    if (workpiece.body[slot] != body || piece == Workpiece::none || pieces.in_piece[slot] == 0)
      continue;
    if (first != Workpiece::none && piece != first) return true;
    first = piece;
  }
  return false;
}

// Returns the points of the body that the initial layout joins with those on the axis.
PlugScene make_plug_scene(const Workpiece& workpiece, std::uint16_t body, const KerfAxes& axes,
                          const Pieces& pieces) {
  PlugScene scene;
  const SideLayers layers = side_layers(workpiece, body, axes);
  const double width = axes.jet.width;
  scene.half_width = width / 2.0;
  scene.core = std::max(depth_breadth_fraction * width, 2.0 * workpiece.axis_spacing) / 2.0;
  scene.limit = std::max(layers.body_thickness, width);
  scene.band = layers.thickness;
  scene.spacing = workpiece.axis_spacing;
  PieceSet on_axis;
  const auto for_body = [&](const auto& visit) {
    for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot)
      if (workpiece.body[slot] == body) visit(slot, axes.local(workpiece.position[slot]));
  };
  for_body([&](std::size_t slot, const KerfAxes::Vector3& x) {
    if (std::hypot(x[0], x[1]) <= scene.core) on_axis.insert(workpiece.initial_body_piece[slot]);
  });
  on_axis.erase(Workpiece::none);
  for_body([&](std::size_t slot, const KerfAxes::Vector3& x) {
    if (on_axis.count(workpiece.initial_body_piece[slot]) != 0)
      scene.points.push_back(
          {x[0], x[1], workpiece.mass[slot], pieces.body_piece[slot], pieces.in_piece[slot] != 0});
  });
  return scene;
}

PlugState state_of(const PlugScene& scene, const PieceSet& plug) {
  const bool counts = std::any_of(
      scene.points.begin(), scene.points.end(),
      [&](const PlugPoint& point) { return point.is_counted && plug.count(point.piece) != 0; });
  return counts ? PlugState::apart : PlugState::crumbs;
}

// The mass of a part of a rim, kg.
struct RimMass {
  double laid_out = 0.0, intact = 0.0;
  void add(const PlugPoint& point) {
    laid_out += point.mass;
    if (point.piece != Workpiece::none && point.is_counted) intact += point.mass;
  }
  bool stands() const { return laid_out > 0.0 && intact >= least_of_rim * laid_out; }
};

// Calls has_rim(begin) for each band that begins between the end of the plug and the limit, until
// one has.
template <class HasRim>
bool find_rim(const PlugScene& scene, double end_of_plug, const HasRim& has_rim) {
  for (double begin = end_of_plug; begin <= scene.limit; begin += scene.band)
    if (has_rim(begin)) return true;
  return false;
}

// The two sides of the jet in a direction across it.
class PlugSides {
 public:
  PlugSides(const PlugScene& scene, double angle)
      : scene_(scene), c_(std::cos(angle)), s_(std::sin(angle)) {}

  // Returns the pieces with particles on both sides.
  PieceSet joining() const {
    std::array<PieceSet, 2> pieces;
    for (const PlugPoint& point : scene_.points)
      if (point.piece != Workpiece::none && beside(point) > 0.0)
        pieces[side(point)].insert(point.piece);
    PieceSet both;
    std::set_intersection(pieces[0].begin(), pieces[0].end(), pieces[1].begin(), pieces[1].end(),
                          std::inserter(both, both.end()));
    return both;
  }
  bool have_rims(const PieceSet& plug) const {
    std::array<double, 2> end{};
    for (const PlugPoint& point : scene_.points)
      if (plug.count(point.piece) != 0)
        end[side(point)] = std::max(end[side(point)], beside(point));
    return has_rim(0, end[0]) && has_rim(1, end[1]);
  }

 private:
  double across(const PlugPoint& point) const { return c_ * point.across + s_ * point.aside; }
  double beside(const PlugPoint& point) const {
    return std::abs(across(point)) - scene_.half_width;
  }
  std::size_t side(const PlugPoint& point) const { return across(point) > 0.0 ? 1 : 0; }
  bool has_rim(std::size_t of_side, double end_of_plug) const {
    const double breadth = scene_.breadth_at_jet();
    const double at_jet = scene_.mass_within(
        breadth, [this](const PlugPoint& point) { return std::abs(across(point)); });
    const double row = at_jet * scene_.spacing / (2.0 * breadth);
    return find_rim(scene_, end_of_plug, [&](double begin) {
      RimMass rim;
      for (const PlugPoint& point : scene_.points)
        if (side(point) == of_side && beside(point) > begin && beside(point) <= begin + scene_.band)
          rim.add(point);
      return rim.stands() && rim.laid_out >= least_of_row * row;
    });
  }

  const PlugScene& scene_;
  double c_, s_;
};

// Returns the pieces on the axis.
PieceSet pieces_on_axis(const PlugScene& scene) {
  PieceSet core;
  for (const PlugPoint& point : scene.points)
    if (point.piece != Workpiece::none && point.radius() <= scene.core) core.insert(point.piece);
  return core;
}

// Returns whether a rim stands all around the plug.
bool has_rim_around(const PlugScene& scene, const PieceSet& plug) {
  double end = 0.0;
  for (const PlugPoint& point : scene.points)
    if (plug.count(point.piece) != 0) end = std::max(end, point.radius() - scene.half_width);
  const double breadth = scene.breadth_at_jet();
  const double at_jet =
      scene.mass_within(breadth, [](const PlugPoint& point) { return point.radius(); });
  return find_rim(scene, end, [&](double begin) {
    const double ring = 2.0 * (scene.half_width + begin) * scene.spacing / (breadth * breadth);
    double laid_out = 0.0;
    std::array<RimMass, sectors> rims;
    for (const PlugPoint& point : scene.points) {
      const double beside = point.radius() - scene.half_width;
      if (beside <= begin || beside > begin + scene.band) continue;
      laid_out += point.mass;
      const double turns = std::atan2(point.aside, point.across) / (2.0 * std::numbers::pi) + 1.0;
      rims[static_cast<std::size_t>(turns * double(sectors)) % sectors].add(point);
    }
    const double most =
        std::max_element(rims.begin(), rims.end(), [](const RimMass& a, const RimMass& b) {
          return a.laid_out < b.laid_out;
        })->laid_out;
    if (laid_out < least_of_row * ring * at_jet) return false;
    return std::all_of(rims.begin(), rims.end(), [most](const RimMass& rim) {
      return rim.stands() && rim.laid_out >= least_of_sector * most;
    });
  });
}

}  // namespace

PlugState find_plug(const Workpiece& workpiece, std::uint16_t body, const KerfAxes& axes,
                    const Pieces& pieces) {
  if (!has_two_counted(workpiece, body, pieces)) return PlugState::held;
  const PlugScene scene = make_plug_scene(workpiece, body, axes, pieces);
  const int directions = workpiece.dimension == 3 ? plug_directions : 1;
  for (int n = 0; n < directions; ++n) {
    const PlugSides sides(scene, n * std::numbers::pi / directions);
    const PieceSet plug = sides.joining();
    if (!plug.empty() && sides.have_rims(plug)) return state_of(scene, plug);
  }
  if (workpiece.dimension != 3) return PlugState::held;
  const PieceSet core = pieces_on_axis(scene);
  // What has crumbled on the axis is a hole.
  if (core.empty() || state_of(scene, core) != PlugState::apart) return PlugState::held;
  return has_rim_around(scene, core) ? PlugState::apart : PlugState::held;
}

}  // namespace kerf
