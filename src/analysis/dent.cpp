// SPDX-License-Identifier: Apache-2.0
#include "analysis/dent.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "analysis/kerf_sections.hpp"

namespace kerf {
namespace {

using Vector3 = std::array<double, 3>;
using LinePlace = std::pair<long, long>;  // across the jet, in spacings

Vector3 difference(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double product(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length(const Vector3& v) {
  return std::hypot(v[0], v[1], v[2]);
}

// A material line through one set of joined bodies: the slots of its ends.
struct MaterialLine {
  std::uint32_t first = Workpiece::none, last = Workpiece::none;
};

// What became of the lines at one place, over all sets of bodies.
struct LineChange {
  double shortening = 0.0;  // m
  double motion = 0.0;      // m, the greatest
  double sag = 0.0;         // m, the greatest along the jet
  double aside = 0.0;       // m, the greatest across the jet
};

// Returns the sets of joined bodies of which the jet meets one.
std::set<std::uint16_t> sets_in_way(const Workpiece& workpiece) {
  std::set<std::uint16_t> sets;
  for (std::size_t slot = 0; slot < workpiece.body.size(); ++slot)
    for (const WorkpieceBody& body : workpiece.bodies)
      if (body.is_in_way && body.body == workpiece.body[slot])
        sets.insert(workpiece.material_piece[slot]);
  return sets;
}

// Returns whether a line is in the way of the jet: the distance of its place from the path is at
// most that of a particle in its way, and half a spacing, because a particle is somewhere in its
// place.
bool is_in_way(const LinePlace& place, const KerfScene& scene) {
  const double spacing = scene.view.workpiece.axis_spacing;
  const std::array<double, 2> x{(static_cast<double>(place.first) + 0.5) * spacing,
                                (static_cast<double>(place.second) + 0.5) * spacing};
  double along = 0.0, square = 0.0;
  for (std::size_t a = 0; a < 2; ++a) {
    const double way = scene.path.end[a] - scene.path.begin[a];
    along += (x[a] - scene.path.begin[a]) * way;
    square += way * way;
  }
  const double part = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
  std::array<double, 2> from{};
  for (std::size_t a = 0; a < 2; ++a)
    from[a] = x[a] - scene.path.begin[a] - part * (scene.path.end[a] - scene.path.begin[a]);
  if (scene.view.frame.dimension == 2) from[1] = 0.0;
  return std::hypot(from[0], from[1]) <=
         in_way_reach(scene.axes.jet.width, spacing) + spacing / 2.0;
}

using LineKey = std::tuple<LinePlace, std::uint16_t>;  // its place and its set of joined bodies

// Returns the lines in the way of the jet.
std::map<LineKey, MaterialLine> find_lines(const KerfScene& scene) {
  const Workpiece& workpiece = scene.view.workpiece;
  const JetAxis& jet = scene.axes.jet;
  const std::set<std::uint16_t> sets = sets_in_way(workpiece);
  const auto depth_at = [&](std::uint32_t slot) { return jet.depth(workpiece.position[slot]); };
  std::map<LineKey, MaterialLine> lines;
  for (std::uint32_t slot = 0; slot < workpiece.position.size(); ++slot) {
    const Vector3& x = workpiece.position[slot];
    if (!scene.view.standing[slot] || scene.view.rows[slot] == Workpiece::none ||
        jet.depth(x) < -jet.standoff || sets.count(workpiece.material_piece[slot]) == 0)
      continue;
    const Vector3 local = scene.axes.local(x);
    const LinePlace place{std::lround(std::floor(local[0] / workpiece.axis_spacing)),
                          std::lround(std::floor(local[1] / workpiece.axis_spacing))};
    if (!is_in_way(place, scene)) continue;
    MaterialLine& line = lines[{place, workpiece.material_piece[slot]}];
    if (line.first == Workpiece::none || depth_at(slot) < depth_at(line.first)) line.first = slot;
    if (line.last == Workpiece::none || depth_at(slot) > depth_at(line.last)) line.last = slot;
  }
  return lines;
}

// Returns the changes of the lines in the way of the jet, by their place.
std::map<LinePlace, LineChange> find_changes(const KerfScene& scene) {
  const Workpiece& workpiece = scene.view.workpiece;
  const auto now = [&](std::uint32_t slot) {
    return scene.view.frame.position[scene.view.rows[slot]];
  };
  std::map<LinePlace, LineChange> changes;
  for (const auto& [key, line] : find_lines(scene)) {
    const Vector3 &first = workpiece.position[line.first], &last = workpiece.position[line.last];
    LineChange& change = changes[std::get<LinePlace>(key)];
    change.shortening +=
        length(difference(last, first)) - length(difference(now(line.last), now(line.first)));
    const Vector3 moved = difference(now(line.last), last);
    const double along = product(moved, scene.axes.jet.along);
    change.motion = std::max(change.motion, length(moved));
    change.sag = std::max(change.sag, along);
    change.aside =
        std::max(change.aside, std::sqrt(std::max(0.0, product(moved, moved) - along * along)));
  }
  return changes;
}

}  // namespace

const MetricList<Dent>& Dent::metrics() {
  static const MetricList<Dent> list{
      {"dent", "m", "depth of the dent",
       "Loss of thickness of the standing solid in the way of the jet, along the jet; motion and "
       "bending of the workpiece do not count.",
       &Dent::depth},
      {"motion", "m", "motion of the workpiece",
       "Distance by which the far face in the way of the jet has moved since the start, in any "
       "direction: by bending or as a whole.",
       &Dent::motion},
      {"sag", "m", "sag of the workpiece",
       "Distance by which the far face in the way of the jet has moved along the jet since the "
       "start: by bending or as a whole. The sides of a cut that slide apart do not count.",
       &Dent::sag}};
  return list;
}

Dent Dent::measure(const KerfScene& scene) {
  const double spacing = scene.view.workpiece.axis_spacing;
  const std::map<LinePlace, LineChange> changes = find_changes(scene);
  const long reach =
      std::max(1L, std::lround(depth_breadth_fraction * scene.axes.jet.width / spacing / 2));
  Dent dent;
  for (const auto& [place, unused] : changes) {
    double count = 0.0, shortening = 0.0, motion = 0.0, sag = 0.0, aside = 0.0;
    for (long i = place.first - reach; i <= place.first + reach; ++i)
      for (auto near = changes.lower_bound({i, place.second - reach});
           near != changes.end() && near->first <= LinePlace{i, place.second + reach}; ++near) {
        count += 1.0;
        shortening += near->second.shortening;
        motion += near->second.motion;
        sag += near->second.sag;
        aside += near->second.aside;
      }
    dent.depth = std::max(dent.depth, shortening / count);
    dent.motion = std::max(dent.motion, motion / count);
    dent.sag = std::max(dent.sag, sag / count);
    dent.aside = std::max(dent.aside, aside / count);
  }
  return dent;
}

}  // namespace kerf
