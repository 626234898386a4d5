// SPDX-License-Identifier: Apache-2.0
// This header declares the rows of the tables of case keys. A row describes one key of a case file
// completely: its type, unit, default, range and conditions, a sentence for docs/keys.md,
// and the member of the model that stores its value. Reading, checking, writing case.used.toml and
// documenting a key follow from its row (src/input/schema.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace kerf {

struct Faces;  // model/case.hpp

enum class ValueKind {
  text,
  name,         // text of letters, digits, '-' and '_'
  word,         // one of `choices`
  integer,      // an integer
  number,       // pure number
  flag,         // true or false
  quantity,     // "5 m/s", in `unit`
  vector,       // one quantity per dimension, or one number where `unit` is empty
  quantities,   // ascending list of quantities
  vertices,     // list of [x, y] quantities
  expression,   // formula of the variables in `choices`
  expressions,  // one such formula per dimension
  faces,        // list of some of `choices`: sides of a box
  table,
  tables
};

struct Range {
  double minimum;
  double maximum;
  bool open_minimum = false;  // the minimum itself is refused
  bool open_maximum = false;
};

namespace key_range {
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr Range any{-infinity, infinity};
inline constexpr Range positive{0.0, infinity, true};
inline constexpr Range not_negative{0.0, infinity};
constexpr Range up_to(double maximum) {
  return {0.0, maximum, true};
}
constexpr Range from_zero_to(double maximum) {
  return {0.0, maximum};
}
constexpr Range within(double limit) {
  return {-limit, limit};
}
}  // namespace key_range

// The default of a key: a text in the notation of a case file, or a number in SI units.
//   ""       the key must be given
//   "(...)"  the default is computed; the text states how
//   "none"   infinity, which may also be written
struct KeyDefault {
  constexpr KeyDefault(const char* written) : text(written) {}
  constexpr KeyDefault(double value) : number(value) {}

  bool is_text() const { return number != number; }

  std::string_view text;
  double number = std::numeric_limits<double>::quiet_NaN();
};

// An enumeration in the model, by the position of its word among the `choices` of its key.
struct WordReference {
  void* value;
  void (*set)(void* value, std::size_t position);
  std::size_t (*get)(const void* value);
};

// The value of a plain key in a structure of the model.
using ValueReference =
    std::variant<double*, int*, std::uint64_t*, bool*, std::string*, std::array<double, 3>*,
                 std::array<std::string, 3>*, std::vector<double>*,
                 std::vector<std::array<double, 2>>*, Faces*, WordReference>;

template <class Value>
ValueReference reference_to(Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    return WordReference{&value,
                         [](void* to, std::size_t position) {
                           *static_cast<Value*>(to) = static_cast<Value>(position);
                         },
                         [](const void* from) {
                           return static_cast<std::size_t>(*static_cast<const Value*>(from));
                         }};
  } else {
    return &value;
  }
}

// Its address identifies the type of a structure.
template <class Structure>
inline constexpr char structure_id = 0;

// The member that stores the value of a key: the structure that it belongs to, and how to get to it
// from there. `structure` is null where no single member stores the value.
struct Member {
  const void* structure = nullptr;
  ValueReference (*value)(void* structure) = nullptr;
  // Where the structure is a part of another one: the way from that to it; else null.
  void* (*part)(void* whole) = nullptr;

  ValueReference of(void* whole) const { return value(part ? part(whole) : whole); }
};

namespace key_member {

template <class Structure, class Value>
Structure owner_of(Value Structure::*);
template <auto member>
using Owner = decltype(owner_of(member));

template <auto first, auto... rest>
ValueReference value(void* structure) {
  return reference_to(((static_cast<Owner<first>*>(structure)->*first).*....*rest));
}

}  // namespace key_member

// stored_in<&Jet::standoff>, or by way of a member that is a structure itself,
// stored_in<&Case::time, &TimeControl::end>.
template <auto first, auto... rest>
inline constexpr Member stored_in{&structure_id<key_member::Owner<first>>,
                                  &key_member::value<first, rest...>};

// One row. A section may hold several rows of one name: the one whose conditions hold counts.
struct Key {
  std::string_view name;
  ValueKind kind;
  std::string_view unit;  // SI
  KeyDefault standard;
  Range range;
  std::span<const std::string_view> choices;
  // Where the key has a meaning: "" everywhere, else alternatives separated by blanks, each a list
  // of conditions joined by '+', e.g. "disc+3D ring+3D". The dimension (2D, 3D), the formulation
  // and the words that other keys of the same table hold are conditions.
  std::string_view applies;
  std::string_view sentence;
  Member member{};

  bool required() const { return standard.is_text() && standard.text.empty(); }
  bool computed() const { return standard.is_text() && standard.text.starts_with('('); }
  bool may_be_none() const { return standard.is_text() && standard.text == "none"; }
  bool applies_under(const std::set<std::string>& conditions) const;
};

}  // namespace kerf
