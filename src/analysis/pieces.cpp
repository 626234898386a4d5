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
#include <unordered_map>

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

// The pieces of the slots: numbers that the members of one piece share, Workpiece::none where a
// slot is not intact.
struct PieceLabels {
  std::vector<std::uint32_t> piece, body_piece;
};

// Of united bodies, bonds to all bodies that are joined to them count.
PieceLabels read_labels(const Workpiece& workpiece, const Frame& frame,
                        const std::vector<std::uint32_t>& rows) {
  PieceLabels labels;
  for (std::size_t slot = 0; slot < rows.size(); ++slot) {
    const std::uint32_t row = rows[slot];
    const bool intact = is_intact(frame, row);
    const auto& within = workpiece.is_in_united(slot) ? frame.piece : frame.body_piece;
    labels.piece.push_back(intact ? frame.piece[row] : Workpiece::none);
    labels.body_piece.push_back(intact ? within[row] : Workpiece::none);
  }
  return labels;
}

// Joins the intact neighbours of the initial layout that still interact.
PieceLabels join_neighbours(const Workpiece& workpiece, const Frame& frame,
                            const std::vector<std::uint32_t>& rows) {
  const std::size_t slots = rows.size();
  boost::disjoint_sets_with_storage<> in_body(slots), all(slots);
  for (std::size_t slot = 0; slot < slots; ++slot) {
    in_body.make_set(slot);
    all.make_set(slot);
  }
  for (const auto& [a, b] : workpiece.bonds) {
    if (!is_intact(frame, rows[a]) || !is_intact(frame, rows[b])) continue;
    const double range =
        workpiece.interaction_range * std::max(workpiece.size[a], workpiece.size[b]);
    if (distance(frame.position[rows[a]], frame.position[rows[b]]) >= range) continue;
    all.union_set(a, b);
    if (workpiece.body[a] == workpiece.body[b]) in_body.union_set(a, b);
  }
  PieceLabels labels{std::vector<std::uint32_t>(slots, Workpiece::none),
                     std::vector<std::uint32_t>(slots, Workpiece::none)};
  for (std::size_t slot = 0; slot < slots; ++slot) {
    if (!is_intact(frame, rows[slot])) continue;
    labels.piece[slot] = static_cast<std::uint32_t>(all.find_set(slot));
    labels.body_piece[slot] = static_cast<std::uint32_t>(in_body.find_set(slot));
  }
  return labels;
}

// Collects the slots by their piece. `number_of`: the number of the fragment of each slot.
std::vector<Fragment> gather_fragments(const Workpiece& workpiece, const Frame& frame,
                                       const std::vector<std::uint32_t>& rows,
                                       const std::vector<std::uint32_t>& number_of) {
  std::vector<Fragment> fragments;
  for (std::size_t slot = 0; slot < number_of.size(); ++slot) {
    if (number_of[slot] == Workpiece::none) continue;
    if (number_of[slot] >= fragments.size()) fragments.resize(number_of[slot] + 1);
    Fragment& fragment = fragments[number_of[slot]];
    const double mass = workpiece.mass[slot];
    fragment.mass += mass;
    fragment.volume += workpiece.volume[slot];
    ++fragment.particles;
    for (std::size_t a = 0; a < 3; ++a) {
      fragment.centre[a] += mass * frame.position[rows[slot]][a];
      fragment.velocity[a] += mass * frame.velocity[rows[slot]][a];
    }
  }
  for (Fragment& fragment : fragments)
    for (std::size_t a = 0; a < 3; ++a) {
      fragment.centre[a] /= fragment.mass;
      fragment.velocity[a] /= fragment.mass;
    }
  return fragments;
}

// Numbers the pieces in the order of their first slots.
std::vector<std::uint32_t> number_pieces(const std::vector<std::uint32_t>& label) {
  std::unordered_map<std::uint32_t, std::uint32_t> numbers;
  std::vector<std::uint32_t> number_of(label.size(), Workpiece::none);
  for (std::size_t slot = 0; slot < label.size(); ++slot) {
    if (label[slot] == Workpiece::none) continue;
    const bool is_as_before = slot > 0 && label[slot] == label[slot - 1];  // as most are
    const auto next = static_cast<std::uint32_t>(numbers.size());
    number_of[slot] =
        is_as_before ? number_of[slot - 1] : numbers.try_emplace(label[slot], next).first->second;
  }
  return number_of;
}

// Marks the slots in pieces within their body that are heavier than piece_mass_fraction of it.
std::vector<std::uint8_t> in_part_of_body(const Workpiece& workpiece,
                                          const std::vector<std::uint32_t>& body_piece) {
  const std::vector<std::uint32_t> number_of = number_pieces(body_piece);
  std::vector<double> mass(body_piece.size(), 0.0), whole;
  for (std::size_t slot = 0; slot < body_piece.size(); ++slot) {
    if (workpiece.body[slot] >= whole.size()) whole.resize(workpiece.body[slot] + 1u, 0.0);
    whole[workpiece.body[slot]] += workpiece.mass[slot];
    if (number_of[slot] != Workpiece::none) mass[number_of[slot]] += workpiece.mass[slot];
  }
  std::vector<std::uint8_t> marks(body_piece.size(), 0);
  for (std::size_t slot = 0; slot < body_piece.size(); ++slot)
    if (number_of[slot] != Workpiece::none &&
        mass[number_of[slot]] > piece_mass_fraction * whole[workpiece.body[slot]])
      marks[slot] = 1;
  return marks;
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
  PieceLabels labels = frame.piece.empty() ? join_neighbours(workpiece, frame, rows)
                                           : read_labels(workpiece, frame, rows);
  const std::vector<std::uint32_t> number_of = number_pieces(labels.piece);
  Pieces pieces;
  pieces.body_piece = std::move(labels.body_piece);
  pieces.fragments = gather_fragments(workpiece, frame, rows, number_of);
  pieces.in_piece = in_part_of_body(workpiece, pieces.body_piece);
  const double least = piece_mass_fraction * workpiece.total_mass;
  for (const Fragment& fragment : pieces.fragments) pieces.count += fragment.mass > least ? 1 : 0;
  for (std::size_t slot = 0; slot < rows.size(); ++slot)
    if (number_of[slot] != Workpiece::none && pieces.fragments[number_of[slot]].mass > least)
      pieces.in_piece[slot] = 1;
  std::stable_sort(pieces.fragments.begin(), pieces.fragments.end(),
                   [](const Fragment& a, const Fragment& b) { return a.mass > b.mass; });
  return pieces;
}

}  // namespace kerf
