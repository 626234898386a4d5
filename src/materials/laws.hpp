// SPDX-License-Identifier: Apache-2.0
// The laws of materials that a case chooses among, and the words it chooses them by.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kerf {

enum class ElasticLaw : std::uint8_t { neo_hookean, st_venant_kirchhoff };
inline constexpr std::array<std::string_view, 2> elastic_law_words{"neo_hookean",
                                                                   "st_venant_kirchhoff"};

enum class EquationOfState : std::uint8_t { tait, shock_hugoniot };
inline constexpr std::array<std::string_view, 2> equation_of_state_words{"tait", "shock_hugoniot"};

enum class PlasticLaw : std::uint8_t { none, von_mises, johnson_cook, drucker_prager };
inline constexpr std::array<std::string_view, 4> plastic_law_words{
    "none", "von_mises", "johnson_cook", "drucker_prager"};

enum class BondCriterion : std::uint8_t {
  principal_strain,
  equivalent_strain,
  principal_stress,
  strain_energy,
  crack_band,
  grady_kipp
};
inline constexpr std::array<std::string_view, 6> bond_criterion_words{
    "principal_strain", "equivalent_strain", "principal_stress",
    "strain_energy",    "crack_band",        "grady_kipp"};

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
