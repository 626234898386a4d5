// SPDX-License-Identifier: Apache-2.0
// Messages between ranks with all that is known of some particles of a solid: their numbers, then
// field by field all fields, the bits of their bonds, and what they held before the last break.
#pragma once

#include "solid/bond_break_energy.hpp"
#include "solid/bond_halo.hpp"

namespace kerf {

template <int D, class P>
struct SolidRecords {
  SolidFields<D, P>& fields;
  Array<BondBreakRecord>& breaks;

  // Sends all about the particles to[r] to rank r, and takes what the others send.
  void exchange(const std::vector<typename BondHalo<D>::Numbers>& to) const {
    std::vector<ranks::Bytes> messages(to.size());
    for (std::size_t r = 0; r < to.size(); ++r)
      if (r != static_cast<std::size_t>(ranks::number())) put(to[r], messages[r]);
    for (const ranks::Bytes& message : ranks::exchange(messages)) take(message);
  }

 private:
  void put(const typename BondHalo<D>::Numbers& which, ranks::Bytes& message) const {
    message = ranks::to_bytes(which);
    fields.for_each_field([&](const auto& field) { put_entries(field, which, message); });
    put_entries(breaks, which, message);
    put_entries(fields.bond_intact, words_of(which), message);
  }
  void take(const ranks::Bytes& message) const {
    if (message.empty()) return;
    typename BondHalo<D>::Numbers which(message.size() / bytes_of_one());
    std::memcpy(which.data(), message.data(), which.size() * sizeof(Index));
    const std::byte* from = message.data() + which.size() * sizeof(Index);
    fields.for_each_field([&](auto& field) { take_entries(from, which, field); });
    take_entries(from, which, breaks);
    take_entries(from, words_of(which), fields.bond_intact);
  }
  typename BondHalo<D>::Numbers words_of(const typename BondHalo<D>::Numbers& which) const {
    typename BondHalo<D>::Numbers words;
    for (const Index s : which)
      for (Index k = 0; k < fields.words; ++k) words.push_back(s * fields.words + k);
    return words;
  }
  std::size_t bytes_of_one() const {
    std::size_t bytes = sizeof(Index) + fields.words * sizeof(std::uint32_t);
    const auto add = [&](const auto& field) {
      if (!field.empty()) bytes += sizeof(field[0]);
    };
    fields.for_each_field(add);
    add(breaks);
    return bytes;
  }
};

}  // namespace kerf
