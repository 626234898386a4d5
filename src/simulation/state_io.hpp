// SPDX-License-Identifier: Apache-2.0
// Particle fields to and from an archive, driven by the field table.
#pragma once

#include <string>
#include <type_traits>

#include "core/error.hpp"
#include "particles/fields.hpp"
#include "simulation/archive.hpp"

namespace kerf {

// The plain numbers a field's entries are made of.
template <class T>
struct Scalars {
  using type = T;
};
template <int D, class T>
struct Scalars<Vector<D, T>> {
  using type = T;
};
template <int D, class T>
struct Scalars<SymmetricTensor<D, T>> {
  using type = T;
};

// Entries made of nothing but `Scalar`s, as plain numbers and back.
template <class Scalar, class Entry>
std::vector<Scalar> flat(const std::vector<Entry>& entries) {
  static_assert(std::is_trivially_copyable_v<Entry> && sizeof(Entry) % sizeof(Scalar) == 0);
  const auto* first = reinterpret_cast<const Scalar*>(entries.data());
  return {first, first + entries.size() * (sizeof(Entry) / sizeof(Scalar))};
}
template <class Entry, class Scalar>
std::vector<Entry> unflat(const std::vector<Scalar>& numbers) {
  static_assert(std::is_trivially_copyable_v<Entry> && sizeof(Entry) % sizeof(Scalar) == 0);
  const auto* first = reinterpret_cast<const Entry*>(numbers.data());
  return {first, first + numbers.size() * sizeof(Scalar) / sizeof(Entry)};
}
template <class Field>
using ScalarOf = typename Scalars<typename Field::value_type>::type;

template <int D, class P>
void save_fields(const Particles<D, P>& particles, Archive& archive) {
  particles.for_each_state([&](const char* name, const auto& field) {
    using Entry = typename std::decay_t<decltype(field)>::value_type;
    using Scalar = ScalarOf<std::decay_t<decltype(field)>>;
    archive.arrays[std::string("particles/") + name] =
        flat<Scalar>(std::vector<Entry>(to_host(field)));
  });
}

template <class Scalar>
const std::vector<Scalar>& find_array(const Archive& archive, const std::string& name) {
  const auto found = archive.arrays.find(name);
  if (found == archive.arrays.end() || !std::holds_alternative<std::vector<Scalar>>(found->second))
    throw UserError("the checkpoint does not hold '" + name +
                        "' in the precision of this case; start the run again without --resume",
                    exit_files);
  return std::get<std::vector<Scalar>>(found->second);
}

template <int D, class P>
void restore_fields(const Archive& archive, Particles<D, P>& particles) {
  particles.resize(static_cast<Index>(find_array<std::uint32_t>(archive, "particles/id").size()));
  particles.for_each_state([&](const char* name, auto& field) {
    using Entry = typename std::decay_t<decltype(field)>::value_type;
    using Scalar = ScalarOf<std::decay_t<decltype(field)>>;
    const auto& numbers = find_array<Scalar>(archive, std::string("particles/") + name);
    if (numbers.size() * sizeof(Scalar) != field.size() * sizeof(Entry))
      throw UserError(std::string("the checkpoint's field '") + name +
                          "' has another length than its particles; start the run again without "
                          "--resume",
                      exit_files);
    to_device(unflat<Entry>(numbers), field);
  });
  particles.regroup();
}

}  // namespace kerf
