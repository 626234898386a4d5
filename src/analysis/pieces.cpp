// SPDX-License-Identifier: Apache-2.0
#include "analysis/pieces.hpp"

#include <algorithm>
// Boost.Geometry includes a header of Boost.Core by a deprecated name, which causes a warning.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>

namespace kerf {
namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::point<double, 3, bg::cs::cartesian>;
using TreeBox = bg::model::box<TreePoint>;
using TreeEntry = std::pair<TreePoint, std::uint32_t>;

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

TreePoint shifted(const std::array<double, 3>& x, double by) {
  return {x[0] + by, x[1] + by, x[2] + by};
}

// Collects the intact slots by the root of their piece.
std::vector<Fragment> gather_fragments(const Workpiece& workpiece, const Frame& frame,
                                       const std::vector<std::uint32_t>& rows,
                                       const std::vector<std::size_t>& root) {
  std::vector<Fragment> of_root(root.size());
  for (std::size_t slot = 0; slot < root.size(); ++slot) {
    if (!is_intact(frame, rows[slot])) continue;
    Fragment& fragment = of_root[root[slot]];
    const double mass = workpiece.mass[slot];
    fragment.mass += mass;
    fragment.volume += workpiece.volume[slot];
    ++fragment.particles;
    for (std::size_t a = 0; a < 3; ++a) {
      fragment.centre[a] += mass * frame.position[rows[slot]][a];
      fragment.velocity[a] += mass * frame.velocity[rows[slot]][a];
    }
  }
  std::erase_if(of_root, [](const Fragment& fragment) { return fragment.particles == 0; });
  for (Fragment& fragment : of_root)
    for (std::size_t a = 0; a < 3; ++a) {
      fragment.centre[a] /= fragment.mass;
      fragment.velocity[a] /= fragment.mass;
    }
  std::stable_sort(of_root.begin(), of_root.end(),
                   [](const Fragment& a, const Fragment& b) { return a.mass > b.mass; });
  return of_root;
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> find_bonds(const Workpiece& workpiece) {
  const auto slots = static_cast<std::uint32_t>(workpiece.position.size());
  std::vector<TreeEntry> entries;
  entries.reserve(slots);
  for (std::uint32_t slot = 0; slot < slots; ++slot)
    entries.emplace_back(shifted(workpiece.position[slot], 0.0), slot);
  const bg::index::rtree<TreeEntry, bg::index::linear<8>> tree(entries);

  std::vector<std::pair<std::uint32_t, std::uint32_t>> bonds;
  for (std::uint32_t slot = 0; slot < slots; ++slot) {
    const double reach = bond_reach * workpiece.spacing;
    const auto keep = [&](const TreeEntry& entry) {
      const std::uint32_t other = entry.second;
      if (other <= slot || workpiece.material_piece[other] != workpiece.material_piece[slot])
        return;
      const double larger = std::max(workpiece.size[slot], workpiece.size[other]);
      if (distance(workpiece.position[slot], workpiece.position[other]) > bond_reach * larger)
        return;
      bonds.emplace_back(slot, other);
    };
    const TreeBox box(shifted(workpiece.position[slot], -reach),
                      shifted(workpiece.position[slot], reach));
    tree.query(bg::index::intersects(box), boost::make_function_output_iterator(keep));
  }
  return bonds;
}

Pieces find_pieces(const Workpiece& workpiece, const Frame& frame,
                   const std::vector<std::uint32_t>& rows) {
  const std::size_t slots = workpiece.position.size();
  boost::disjoint_sets_with_storage<> sets(slots);
  for (std::size_t slot = 0; slot < slots; ++slot) sets.make_set(slot);
  for (const auto& [a, b] : workpiece.bonds) {
    if (!is_intact(frame, rows[a]) || !is_intact(frame, rows[b])) continue;
    const double larger = std::max(workpiece.size[a], workpiece.size[b]);
    if (distance(frame.position[rows[a]], frame.position[rows[b]]) > bond_limit * larger) continue;
    sets.union_set(a, b);
  }
  std::vector<double> mass(slots, 0.0);
  for (std::size_t slot = 0; slot < slots; ++slot)
    if (is_intact(frame, rows[slot])) mass[sets.find_set(slot)] += workpiece.mass[slot];

  std::vector<std::size_t> root(slots);
  for (std::size_t slot = 0; slot < slots; ++slot) root[slot] = sets.find_set(slot);
  Pieces pieces;
  pieces.fragments = gather_fragments(workpiece, frame, rows, root);
  pieces.in_piece.resize(slots, 0);
  const double least = piece_mass_fraction * workpiece.total_mass;
  for (std::size_t slot = 0; slot < slots; ++slot) {
    if (mass[slot] > least) ++pieces.count;
    if (is_intact(frame, rows[slot]) && mass[sets.find_set(slot)] > least)
      pieces.in_piece[slot] = 1;
  }
  return pieces;
}

}  // namespace kerf
