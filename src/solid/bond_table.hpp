// SPDX-License-Identifier: Apache-2.0
// BondTable holds the lists of bonds. Particles with the same layout around them, as those of one
// row of a block, have the same list relative to their own index and share it
// (solid/share_lists.hpp). So an entry is the index of the other particle minus that of the list's
// own particle. The entry of a bond to a mirror image (core/mirror_planes.hpp), which is in no
// shared list, names that image as a neighbour list does.
#pragma once

#include "core/mirror_planes.hpp"
#include "parallel/loops.hpp"

namespace kerf {

// Converts between an entry and the other end j of a bond of particle i, with a mirror code in the
// highest bits.
template <int D>
struct BondEntry {
  static constexpr int shift = MirrorPlanes<D>::shift;
  static constexpr Index all_codes = (Index(1) << (2 * D)) - 1;
  // The largest difference of two indices where there are planes: the codes take up the rest.
  static constexpr Index most_apart = Index(1) << (shift - 1);

  KERF_FUNCTION static Index pack(Index i, Index end, const MirrorPlanes<D>& mirrors) {
    return mirrors.code(end) == 0 ? end - i : end;
  }
  // No code names both faces of an axis: highest bits that are all set are those of a negative
  // difference.
  KERF_FUNCTION static Index unpack(Index i, Index entry, const MirrorPlanes<D>& mirrors) {
    const Index codes = entry >> shift;
    return mirrors.faces == 0 || codes == 0 || codes == all_codes ? i + entry : entry;
  }
};

template <int D>
struct BondTable {
  const Index* begin;          // of each particle, its list
  const std::uint16_t* count;  // and how long that is
  const Index* entry;
  MirrorPlanes<D> mirrors;

  KERF_FUNCTION Index first(Index i) const { return begin[i]; }
  KERF_FUNCTION Index last(Index i) const { return begin[i] + count[i]; }
  // Returns the other end of bond k of particle i: j, with a mirror code in the highest bits. The
  // ends of a list ascend.
  KERF_FUNCTION Index end(Index i, Index k) const {
    return BondEntry<D>::unpack(i, entry[k], mirrors);
  }
};

inline constexpr Index no_bond = 0xffffffffu;

// Returns the bond of particle i to `end`, broken or not; or no_bond. The search has no branch that
// a processor could guess wrong.
template <int D>
KERF_FUNCTION Index bond_between(const BondTable<D>& bonds, Index i, Index end) {
  Index low = bonds.first(i), left = bonds.last(i) - low;
  if (left == 0) return no_bond;
  while (left > 1) {
    const Index half = left / 2;
    low += bonds.end(i, low + half - 1) < end ? half : 0;
    left -= half;
  }
  return bonds.end(i, low) == end ? low : no_bond;
}

}  // namespace kerf
