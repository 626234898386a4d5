// SPDX-License-Identifier: Apache-2.0
// The lists of bonds as loops see them. Particles laid out alike have lists that are alike but for
// where they start from, as those of one row of a block: such particles share one
// (share_lists.hpp). So an entry says how far the other particle is from the list's own; of a bond
// to a mirror image (core/mirror_planes.hpp), which is in nobody else's list, it names that image
// as a list of neighbours does.
#pragma once

#include "core/mirror_planes.hpp"
#include "exec/exec.hpp"

namespace kerf {

// Both ways between an entry and the particle j, with a mirror code in the highest bits, that
// particle i is bound to.
template <int D>
struct BondEntry {
  static constexpr int shift = MirrorPlanes<D>::shift;
  static constexpr Index all_codes = (Index(1) << (2 * D)) - 1;
  // How far apart two numbers may be where there are planes: the codes take up the rest.
  static constexpr Index most_apart = Index(1) << (shift - 1);

  KERF_FUNCTION static Index pack(Index i, Index end, const MirrorPlanes<D>& mirrors) {
    return mirrors.code(end) == 0 ? end - i : end;
  }
  // No code names both faces of an axis: highest bits that are all set are those of a number less
  // than zero.
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
  // What bond k of particle i leads to: j, with a mirror code in the highest bits. Along a list
  // they ascend.
  KERF_FUNCTION Index end(Index i, Index k) const {
    return BondEntry<D>::unpack(i, entry[k], mirrors);
  }
};

inline constexpr Index no_bond = 0xffffffffu;

// The bond of particle i to `end`, broken or not; or no_bond.
template <int D>
KERF_FUNCTION Index bond_between(const BondTable<D>& bonds, Index i, Index end) {
  Index low = bonds.first(i), high = bonds.last(i);
  while (low < high) {
    const Index middle = low + (high - low) / 2;
    if (bonds.end(i, middle) < end)
      low = middle + 1;
    else
      high = middle;
  }
  return low < bonds.last(i) && bonds.end(i, low) == end ? low : no_bond;
}

}  // namespace kerf
