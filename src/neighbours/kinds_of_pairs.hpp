// SPDX-License-Identifier: Apache-2.0
// KindsOfPairs keeps, for pairs of two kinds, how far they interact and of which class they are,
// which is the same for all of them, so that a candidate of the search costs one look.
#pragma once

#include "neighbours/pair_range.hpp"

namespace kerf {

class KindsOfPairs {
 public:
  struct Entry {
    // Of the particle, with its variant, and of the candidate; 0: nothing is known yet.
    std::uint32_t own = 0, other = 0;
    double square = 0.0;  // m^2, of the cutoff with the skin; 0: the candidate does not act
    PairClass pair_class = PairClass::other;
  };

  void forget() {
    for (Entry& entry : entries_) entry = {};
  }
  // Returns the entry of two kinds other than 0. If it is not known, `find` must set the last two
  // of its numbers.
  template <class Find>
  const Entry& of(std::uint32_t own, std::uint32_t other, const Find& find) {
    Entry& entry = entries_[(3 * own + other) % most];
    if (entry.own != own || entry.other != other) {
      entry.own = own;
      entry.other = other;
      find(entry);
    }
    return entry;
  }

 private:
  static constexpr std::uint32_t most = 32;
  Entry entries_[most];
};

}  // namespace kerf
