// SPDX-License-Identifier: Apache-2.0
// Messages with the fields of some particles, field by field, which follow from the table of
// fields. `Chosen` says which rows of the table a message has.
#pragma once

#include <cstring>
#include <type_traits>
#include <vector>

#include "parallel/entry_messages.hpp"
#include "particles/fields.hpp"

namespace kerf {

struct AllFields {
  template <class Row>
  static constexpr bool has = true;
};
struct StateFields {
  template <class Row>
  static constexpr bool has = Row::is_state;
};
struct PairedFields {
  template <class Row>
  static constexpr bool has = Row::is_paired;
};

// Calls visit(field) for the chosen fields.
template <class Chosen, class AnyParticles, class Visit>
void for_each_chosen(AnyParticles& particles, const Visit& visit) {
  particles.for_each_field([&](const auto& row, auto& field, const auto&) {
    if constexpr (Chosen::template has<std::decay_t<decltype(row)>>) visit(field);
  });
}

template <class Field>
inline constexpr std::size_t entry_size = sizeof(typename std::decay_t<Field>::value_type);

// How many bytes a particle has in a message.
template <class Chosen, int D, class P>
std::size_t bytes_in_message(const Particles<D, P>& particles) {
  std::size_t bytes = 0;
  for_each_chosen<Chosen>(particles,
                          [&](const auto& field) { bytes += entry_size<decltype(field)>; });
  return bytes;
}

template <class Chosen, int D, class P>
void pack(const Particles<D, P>& particles, const std::vector<Index>& which,
          ranks::Bytes& message) {
  message.resize(which.size() * bytes_in_message<Chosen>(particles));
  std::byte* to = message.data();
  for_each_chosen<Chosen>(particles, [&](const auto& field) {
    constexpr std::size_t size = entry_size<decltype(field)>;
    for (const Index i : which) {
      std::memcpy(to, &field[i], size);
      to += size;
    }
  });
}

// Sets the fields of the particles from `first` on, as many as the message has; returns where they
// end.
template <class Chosen, int D, class P>
Index unpack(const ranks::Bytes& message, Particles<D, P>& particles, Index first) {
  const std::size_t count = message.size() / bytes_in_message<Chosen>(particles);
  const std::byte* from = message.data();
  for_each_chosen<Chosen>(particles, [&](auto& field) {
    const std::size_t length = count * entry_size<decltype(field)>;
    if (length > 0) std::memcpy(static_cast<void*>(field.data() + first), from, length);
    from += length;
  });
  return first + static_cast<Index>(count);
}

// Sets the fields of these particles, as many as the message has.
template <class Chosen, int D, class P>
void unpack(const ranks::Bytes& message, Particles<D, P>& particles,
            const std::vector<Index>& which) {
  const std::byte* from = message.data();
  for_each_chosen<Chosen>(particles, [&](auto& field) { take_entries(from, which, field); });
}

}  // namespace kerf
