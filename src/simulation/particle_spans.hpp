// SPDX-License-Identifier: Apache-2.0
// The spans of all fields of the particles, from the table of fields.
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "particles/fields.hpp"
#include "simulation/field_span.hpp"
#include "simulation/state_io.hpp"

namespace kerf {

template <class Scalar>
constexpr FieldSpan::Number number_type() {
  if constexpr (std::is_same_v<Scalar, float>)
    return FieldSpan::Number::float32;
  else if constexpr (std::is_same_v<Scalar, double>)
    return FieldSpan::Number::float64;
  else if constexpr (std::is_same_v<Scalar, std::uint8_t>)
    return FieldSpan::Number::uint8;
  else if constexpr (std::is_same_v<Scalar, std::uint16_t>)
    return FieldSpan::Number::uint16;
  else
    return FieldSpan::Number::uint32;
}

// Returns the state of the particles and their pressure; nothing on a GPU, whose memory the host
// cannot read.
template <int D, class P>
std::vector<FieldSpan> field_spans(const Particles<D, P>& particles) {
  std::vector<FieldSpan> spans;
  if constexpr (!on_gpu) {
    const auto add = [&](const char* name, const auto& field) {
      using Entry = typename std::decay_t<decltype(field)>::value_type;
      using Scalar = ScalarOf<std::decay_t<decltype(field)>>;
      spans.push_back({name, pointer(field), number_type<Scalar>(), field.size(),
                       sizeof(Entry) / sizeof(Scalar)});
    };
    particles.for_each_state(add);
    add("pressure", particles.pressure);
  }
  return spans;
}

}  // namespace kerf
