// SPDX-License-Identifier: Apache-2.0
#include "analysis/united_bodies.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "analysis/workpiece.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

// Of the lines through the smaller of two bodies: more pass the other, too, where one lies above
// it.
constexpr double most_shared = 0.5;

// The lines along the jet that pass a body, by their place across it in spacings; rising.
using Lines = std::vector<std::pair<long, long>>;

// A body of the workpiece, and the set of joined bodies to which it belongs.
struct Part {
  Lines lines;
  std::uint16_t joined = 0;
};

std::map<std::uint16_t, Part> find_parts(const Workpiece& workpiece) {
  std::map<std::uint16_t, std::set<std::pair<long, long>>> lines;
  std::map<std::uint16_t, Part> parts;
  const auto place = [&](double across) { return std::lround(across / workpiece.spacing); };
  for (std::size_t slot = 0; slot < workpiece.position.size(); ++slot) {
    const auto& x = workpiece.position[slot];
    lines[workpiece.body[slot]].emplace(place(workpiece.jet->offset(x)),
                                        place(workpiece.jet->side(x)));
    parts[workpiece.body[slot]].joined = workpiece.material_piece[slot];
  }
  for (auto& [body, part] : parts) part.lines.assign(lines[body].begin(), lines[body].end());
  return parts;
}

bool lie_side_by_side(const Lines& a, const Lines& b) {
  Lines both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return static_cast<double>(both.size()) <
         most_shared * static_cast<double>(std::min(a.size(), b.size()));
}

}  // namespace

void unite_bodies(const Case& description, Workpiece& workpiece) {
  const std::map<std::uint16_t, Part> parts = find_parts(workpiece);
  workpiece.is_united.assign(description.bodies.size(), 0);
  boost::disjoint_sets_with_storage<> sets(description.bodies.size());
  for (std::size_t body = 0; body < description.bodies.size(); ++body) sets.make_set(body);
  for (auto a = parts.begin(); a != parts.end(); ++a)
    for (auto b = std::next(a); b != parts.end(); ++b) {
      if (a->second.joined != b->second.joined ||
          description.bodies[a->first].material != description.bodies[b->first].material ||
          !lie_side_by_side(a->second.lines, b->second.lines))
        continue;
      sets.union_set(a->first, b->first);
      workpiece.is_united[a->first] = workpiece.is_united[b->first] = 1;
    }
  std::map<std::size_t, std::uint16_t> least;  // of each set
  for (const auto& [body, unused] : parts) least.try_emplace(sets.find_set(body), body);
  for (std::uint16_t& body : workpiece.body) body = least.at(sets.find_set(body));
}

}  // namespace kerf
