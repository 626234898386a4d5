// SPDX-License-Identifier: Apache-2.0
// When the ghosts of a rank are fetched anew, each is another particle in the arrays. GhostNames
// gives the lists of neighbours that are kept their new indices.
#pragma once

#include "particles/fields.hpp"

namespace kerf {

// Finds the new index of each ghost; no_index: it is none any more.
struct FindGhost {
  const std::uint32_t *before, *id;  // of the ghosts before, and of those now in ascending order
  const Index* index;                // of those
  Index count;                       // of those
  Index* name;                       // out, of each ghost before

  KERF_FUNCTION void operator()(Index k) const {
    Index low = 0, high = count;
    while (low < high) {
      const Index middle = low + (high - low) / 2;
      if (id[middle] < before[k])
        low = middle + 1;
      else
        high = middle;
    }
    name[k] = low < count && id[low] == before[k] ? index[low] : no_index;
  }
};

// Gives the ghosts in the lists without a mark their names.
template <int D>
struct NameGhosts {
  const Index *begin, *end;
  const std::uint8_t* listed_anew;  // marks
  MirrorPlanes<D> mirrors;
  const Index* name;  // of each ghost
  Index first;        // the first of the ghosts before
  Index* neighbour;   // indices, with a mirror code in the highest bits

  KERF_FUNCTION void operator()(Index i) const {
    if (listed_anew[i] != 0) return;
    for (Index k = begin[i]; k < end[i]; ++k)
      if (const Index j = mirrors.particle(neighbour[k]); j >= first)
        neighbour[k] = name[j - first] | mirrors.code(neighbour[k]);
  }
};

class GhostNames {
 public:
  // Must be called before the ghosts are dropped.
  template <int D, class P>
  void note(const Particles<D, P>& particles) {
    first_ = particles.ghosts.first;
    copy_ids(particles, before_);
  }
  // Finds the names of the ghosts that have been fetched since then.
  template <int D, class P>
  void find(const Particles<D, P>& particles) {
    copy_ids(particles, id_);
    index_.resize(id_.size());
    thrust::sequence(loop_policy(), index_.begin(), index_.end(), particles.ghosts.first);
    thrust::sort_by_key(loop_policy(), id_.begin(), id_.end(), index_.begin());
    name_.resize(before_.size());
    for_each_index(static_cast<Index>(before_.size()),
                   FindGhost{pointer(before_), pointer(id_), pointer(index_),
                             static_cast<Index>(id_.size()), pointer(name_)});
  }
  Index first() const { return first_; }
  const Index* names() const { return pointer(name_); }

 private:
  template <int D, class P>
  static void copy_ids(const Particles<D, P>& particles, Array<std::uint32_t>& ids) {
    const auto first = particles.id.begin() + particles.ghosts.first;
    ids.assign(first, first + particles.ghosts.count);
  }

  Index first_ = 0;
  Array<std::uint32_t> before_, id_;
  Array<Index> index_, name_;
};

}  // namespace kerf
