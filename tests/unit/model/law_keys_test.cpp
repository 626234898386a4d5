// SPDX-License-Identifier: Apache-2.0
// The lists of laws with their words, sentences and keys, and whether a material can break.
#include "model/law_keys.hpp"

#include <gtest/gtest.h>

#include <set>

#include "model/material_laws.hpp"
#include "model/medium.hpp"

namespace kerf {
namespace {

// A word is a condition under which keys apply, whichever kind of law it belongs to.
TEST(LawKeys, EveryLawHasAWordOfItsOwnAndASentence) {
  std::set<std::string_view> words;
  for (const LawText& law : law_texts()) {
    EXPECT_TRUE(words.insert(law.word).second) << law.word;
    EXPECT_GT(law.sentence.size(), 10u) << law.word;
    EXPECT_NE(law.sentence.back(), '.') << law.word;
  }
  EXPECT_EQ(words.size(), elastic_law_words.size() + plastic_law_words.size() +
                              bond_criterion_words.size() + equation_of_state_words.size());
}

std::vector<Key> keys_of_all_laws() {
  std::vector<Key> all;
  for (const char* chosen_by : {"elasticity", "plasticity", "criterion", "equation_of_state"})
    for (const Key& key : law_keys(chosen_by)) all.push_back(key);
  return all;
}
double& number_of(const Key& key, Material& material) {
  return *std::get<double*>(key.member.of(&material));
}

// No two keys share a member.
TEST(LawKeys, EveryKeyHasItsOwnNumber) {
  Material material;
  double value = 0.0;
  for (const Key& key : keys_of_all_laws()) number_of(key, material) = value += 1.0;
  value = 0.0;
  for (const Key& key : keys_of_all_laws()) {
    EXPECT_EQ(number_of(key, material), value += 1.0) << key.name << " of " << key.applies;
  }
  EXPECT_GT(value, 20.0);
}

TEST(LawKeys, HeatKeysBelongToMetals) {
  for (const Key& key : law_keys("plasticity")) {
    if (key.name == "heat_capacity") {
      EXPECT_EQ(key.applies, "von_mises johnson_cook");
    } else if (key.name == "temperature") {
      EXPECT_EQ(key.applies, "johnson_cook");
    }
  }
}

TEST(LawKeys, MaterialsAreComparedAndCopiedWithTheirLaws) {
  Material one;
  one.laws->tait.exponent = 5.0;
  Material other = one;
  EXPECT_EQ(one, other);
  other.laws->tait.exponent = 6.0;
  EXPECT_NE(one, other);
  EXPECT_EQ(one.laws->tait.exponent, 5.0);
}

struct Limits {
  double failure_strain = 0.0, fracture_energy = 0.0, tensile_strength = 0.0, ductile = 0.0;
};
// A solid of 1 GPa.
Material limited(BondCriterion criterion, const Limits& limits) {
  Material material;
  material.kind = MaterialKind::elastic;
  material.youngs_modulus = 1e9;
  material.criterion = criterion;
  material.failure_strain = limits.failure_strain;
  material.fracture_energy = limits.fracture_energy;
  material.laws->principal_stress.tensile_strength = limits.tensile_strength;
  material.laws->damage.least_failure_strain = limits.ductile;
  if (limits.ductile > 0.0) material.plasticity = PlasticLaw::von_mises;
  return material;
}
// The result equals that of the loops over bonds.
Medium<float> medium_of(const Material& material) {
  Medium<double> medium;
  medium.criterion = material.criterion;
  static_cast<BondCriterionSet<double>&>(medium) = *material.laws;
  medium.failure_strain = fracture_limits(material, 1e-3).end;
  medium.plastic = plastic_parameters(material);
  return Medium<float>::from(medium);
}

TEST(CanBreak, IsEqualForAMaterialAndItsMedium) {
  const struct {
    BondCriterion criterion;
    Limits limits;
    bool breaks;
  } table[] = {{BondCriterion::principal_strain, {}, false},
               {BondCriterion::principal_strain, {.failure_strain = 0.1}, true},
               {BondCriterion::equivalent_strain, {.fracture_energy = 2.0}, true},
               {BondCriterion::strain_energy, {.tensile_strength = 1e6}, false},
               {BondCriterion::principal_stress, {.tensile_strength = 1e6}, true},
               {BondCriterion::principal_stress, {.failure_strain = 0.1}, false},
               {BondCriterion::crack_band, {.failure_strain = 0.1, .fracture_energy = 2.0}, true},
               {BondCriterion::brittle_band, {.fracture_energy = 2.0}, true},
               {BondCriterion::grady_kipp, {}, true},
               {BondCriterion::principal_strain, {.ductile = 0.2}, true}};
  for (const auto& row : table) {
    const Material material = limited(row.criterion, row.limits);
    const auto word = word_of(row.criterion, bond_criterion_words);
    EXPECT_EQ(material.can_break(), row.breaks) << word;
    EXPECT_EQ(medium_of(material).can_break(), row.breaks) << word;
  }
}

}  // namespace
}  // namespace kerf
