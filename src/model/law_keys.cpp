// SPDX-License-Identifier: Apache-2.0
#include "model/law_keys.hpp"

#include <string>

#include "model/material_laws.hpp"

namespace kerf {

namespace {

// Returns the part of the laws of a material that has the given type.
template <auto law>
struct OfMaterial {
  static void* part(void* material) { return &((*static_cast<Material*>(material)->laws).*law); }
};
template <auto law>
struct OfPlasticity {
  static void* part(void* material) {
    return &(static_cast<Material*>(material)->laws->plastic.*law);
  }
};

// Adds the rows of a law, which apply where one of `words` is chosen unless they say otherwise.
template <class Way>
void add_rows(std::vector<Key> rows, std::string_view words, std::vector<Key>& keys) {
  for (Key& row : rows) {
    row.member.structure = &structure_id<Material>;
    row.member.part = &Way::part;
    if (row.applies.empty()) row.applies = words;
    keys.push_back(row);
  }
}

template <class T, auto law>
using LawOf = std::remove_reference_t<decltype(std::declval<T&>().*law)>;

template <class Set, template <auto> class Way>
std::vector<Key> keys_of_laws() {
  std::vector<Key> keys;
  Set::for_each([&]<auto law>(std::string_view word) {
    if constexpr (requires { LawOf<Set, law>::rows(); })
      add_rows<Way<law>>(LawOf<Set, law>::rows(), word, keys);
  });
  return keys;
}

template <class Set>
void add_texts(std::string_view chosen_by, std::vector<LawText>& texts) {
  Set::for_each([&]<auto law>(std::string_view word) {
    texts.push_back({chosen_by, word, LawOf<Set, law>::sentence});
  });
}

// The laws of a set for which `holds`, as words separated by blanks.
template <class Set, class Condition>
std::string words_of_laws(const Condition& holds) {
  std::string words;
  Set::for_each([&]<auto law>(std::string_view word) {
    if (!holds(LawOf<Set, law>{})) return;
    if (!words.empty()) words += ' ';
    words += word;
  });
  return words;
}
template <class Condition>
std::string plastic_laws(const Condition& holds) {
  return words_of_laws<PlasticLawSet<double>>([&]<class Law>(const Law& law) {
    return !std::is_same_v<Law, NoPlasticity<double>> && holds(law);
  });
}

// Returns the keys of the fracture criteria, of the compressive strength of those that soften, and
// of the rate of strain, on which the limits of those depend that have no law of it of their own.
std::vector<Key> keys_of_criteria() {
  using Set = BondCriterionSet<double>;
  static const std::string with_limits = words_of_laws<Set>([]<class Law>(const Law&) {
    return !requires {
      Law::has_own_rate;
    };
  });
  static const std::string softening = words_of_laws<Set>([]<class Law>(const Law&) {
    return requires {
      Law::softens;
    };
  });
  std::vector<Key> keys = keys_of_laws<Set, OfMaterial>();
  add_rows<OfMaterial<&MaterialLaws::compression>>(CompressiveStrength<double>::rows(), softening,
                                                   keys);
  add_rows<OfMaterial<&MaterialLaws::strength_rate>>(StrengthRate<double>::rows(), with_limits,
                                                     keys);
  return keys;
}

// Returns the keys of the plastic laws, and of heat and ductile damage, which several laws share.
std::vector<Key> keys_of_plasticity() {
  static const std::string metals = plastic_laws([](const auto& law) { return law.is_metal; });
  static const std::string warm =
      plastic_laws([](const auto& law) { return law.depends_on_temperature; });
  std::vector<Key> keys = keys_of_laws<PlasticLawSet<double>, OfPlasticity>();
  add_rows<OfMaterial<&MaterialLaws::heat>>(PlasticHeat<double>::rows(), metals, keys);
  add_rows<OfMaterial<&MaterialLaws::heat>>(PlasticHeat<double>::temperature_rows(), warm, keys);
  add_rows<OfMaterial<&MaterialLaws::damage>>(JohnsonCookDamage<double>::rows(), metals, keys);
  return keys;
}

}  // namespace

std::vector<Key> law_keys(std::string_view chosen_by) {
  if (chosen_by == "elasticity") return keys_of_laws<ElasticLawSet<double>, OfMaterial>();
  if (chosen_by == "plasticity") return keys_of_plasticity();
  if (chosen_by == "criterion") return keys_of_criteria();
  if (chosen_by == "equation_of_state")
    return keys_of_laws<EquationOfStateSet<double>, OfMaterial>();
  return {};
}

std::span<const LawText> law_texts() {
  static const std::vector<LawText> all = [] {
    std::vector<LawText> texts;
    add_texts<ElasticLawSet<double>>("elasticity", texts);
    add_texts<PlasticLawSet<double>>("plasticity", texts);
    add_texts<BondCriterionSet<double>>("criterion", texts);
    add_texts<EquationOfStateSet<double>>("equation_of_state", texts);
    return texts;
  }();
  return all;
}

CriterionKeys keys_of(BondCriterion criterion) {
  const BondCriterionSet<double> criteria;
  return BondCriterionSet<double>::visit(criteria, criterion,
                                         []<class Law>(const Law&) { return Law::keys; });
}

}  // namespace kerf
