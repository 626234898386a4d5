// SPDX-License-Identifier: Apache-2.0
// How a field of the particles is shown: as a column of frames with a name, a label and an SI unit.
#pragma once

#include "core/tensor.hpp"
#include "model/medium.hpp"

namespace kerf {

struct Hidden {};
inline constexpr Hidden hidden;

// `Value` has operator()(entry, medium), which returns what the column holds: a number, a vector or
// a symmetric tensor.
template <class Value>
struct ShownField {
  const char *column, *label, *unit;
  Value value{};
};
template <class Value>
constexpr ShownField<Value> shown(const char* column, const char* label, const char* unit) {
  return {column, label, unit};
}

// Shows the entries of a field themselves.
struct AsStored {
  template <class Entry>
  const Entry& operator()(const Entry& entry, const Medium<double>&) const {
    return entry;
  }
};

}  // namespace kerf
