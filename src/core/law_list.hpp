// SPDX-License-Identifier: Apache-2.0
// These macros turn a list of laws into the enumeration that a medium chooses by, the words of the
// case file, and a structure with the parameters of every law. A list is a macro with one line
// LAW(word, Class) per law; `Class<T>` holds the parameters of the law, with
//   sentence               what the law is, without the full stop: a static std::string_view
//   from(other)            static; the parameters in another precision, as far as loops need them
//   operator==             defaulted
//   rows()                 optional, static: the keys of a case file (core/case_key.hpp)
//   derive(body)           optional: derives parameters from the body (materials/law_arguments.hpp)
// and the functions that its kind of law requires.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/host_device.hpp"

#define KERF_LAW_ENUMERATOR(word, Class) word,
#define KERF_LAW_WORD(word, Class) std::string_view(#word),
#define KERF_LAW_MEMBER(word, Class) Class<T> word;
#define KERF_LAW_CONVERT(word, Class) to.word = Class<T>::from(other.word);
#define KERF_LAW_CASE(word, Class) \
  case Kind::word:                 \
    return action(self.word);
#define KERF_LAW_EACH(word, Class) \
  action.template operator()<&Parameters::word>(std::string_view(#word));

// The enumeration of LIST and the array of its words.
#define KERF_DEFINE_LAW_ENUM(Enum, words_of, LIST)              \
  enum class Enum : std::uint8_t { LIST(KERF_LAW_ENUMERATOR) }; \
  inline constexpr auto words_of = std::to_array({LIST(KERF_LAW_WORD)});

// `Set`: template <class T> with one member per law of LIST. Set::visit(self, kind, action) returns
// action(law) of the chosen law, on the host or on a device; Set::for_each(action) calls
// action.operator()<pointer to member>(word) for every law.
#define KERF_DEFINE_LAW_SET(Set, Enum, LIST)                                       \
  template <class T>                                                               \
  struct Set {                                                                     \
    using Kind = Enum;                                                             \
    using Parameters = Set;                                                        \
    LIST(KERF_LAW_MEMBER)                                                          \
                                                                                   \
    template <class Self, class Action>                                            \
    KERF_FUNCTION static auto visit(Self& self, Kind kind, const Action& action) { \
      switch (kind) { LIST(KERF_LAW_CASE) }                                        \
      KERF_UNREACHABLE();                                                          \
    }                                                                              \
    template <class Action>                                                        \
    static void for_each(const Action& action) {                                   \
      LIST(KERF_LAW_EACH)                                                          \
    }                                                                              \
    template <class Other>                                                         \
    KERF_FUNCTION static Set from(const Set<Other>& other) {                       \
      Set to;                                                                      \
      LIST(KERF_LAW_CONVERT)                                                       \
      return to;                                                                   \
    }                                                                              \
    bool operator==(const Set&) const = default;                                   \
  };

namespace kerf {

template <class Law, std::size_t N>
constexpr std::string_view word_of(Law law, const std::array<std::string_view, N>& words) {
  return words[static_cast<std::size_t>(law)];
}
// The law of that word; the first when there is none.
template <class Law, std::size_t N>
constexpr Law law_of(std::string_view word, const std::array<std::string_view, N>& words) {
  for (std::size_t k = 0; k < N; ++k)
    if (words[k] == word) return static_cast<Law>(k);
  return Law{};
}

}  // namespace kerf
