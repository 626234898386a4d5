// SPDX-License-Identifier: Apache-2.0
// The fracture criterion of a material for which neither the case nor its base names one.
#include <gtest/gtest.h>

#include <string>

#include "input/material_library.hpp"
#include "input/read.hpp"
#include "input/write_used.hpp"
#include "model/case.hpp"
#include "model/material_laws.hpp"

namespace kerf::test::default_criterion_test {
namespace {

Case block_case(const std::string& keys) {
  return parse_case(
      "title = \"a block\"\ndimension = 2\n[time]\nend = \"1 ms\"\n[materials.stuff]\n" + keys +
          "[[body]]\nname = \"block\"\nmaterial = \"stuff\"\nspacing = \"1 mm\"\n"
          "shape = { type = \"box\", minimum = [\"0 mm\", \"0 mm\"], maximum = [\"20 mm\", \"20 "
          "mm\"] }\n",
      "block.toml");
}

Material material_of(const std::string& keys) {
  const Case description = block_case(keys);
  EXPECT_EQ(parse_case(write_used(description), "used.toml"), description) << keys;
  return description.materials.at(static_cast<std::size_t>(description.bodies.at(0).material));
}

const std::string own =
    "kind = \"elastic\"\ndensity = \"1000 kg/m3\"\nyoungs_modulus = \"60 kPa\"\n"
    "poisson_ratio = 0.3\n";
const std::string energy = "fracture_energy = \"2 J/m2\"\n", strain = "failure_strain = 0.1\n";

// rubber and tofu of the library name no criterion, skin has crack_band and copper flows.
TEST(DefaultCriterion, AFractureEnergyAloneIsBrittle) {
  using enum BondCriterion;
  const struct {
    std::string keys;
    BondCriterion due;
  } table[] = {
      {own, principal_strain},
      {own + strain, principal_strain},
      {own + energy, brittle_band},
      {own + energy + "failure_strain = 0\n", brittle_band},
      {own + "fracture_energy = \"0 J/m2\"\n", principal_strain},
      {own + energy + "criterion = \"strain_energy\"\n", strain_energy},
      {"base = \"tofu\"\n", principal_strain},
      {"base = \"tofu\"\n" + energy, brittle_band},
      {"base = \"rubber\"\n" + energy, brittle_band},
      {"base = \"skin\"\n" + energy, crack_band},
      {"base = \"copper\"\n" + energy, principal_strain},
      {own + energy + "plasticity = \"von_mises\"\nyield_strength = \"1 kPa\"\n", principal_strain},
  };
  for (const auto& row : table) EXPECT_EQ(material_of(row.keys).criterion, row.due) << row.keys;
  EXPECT_EQ(material_of("base = \"tofu\"\n" + energy).failure_strain, 0.0);
}

TEST(DefaultCriterion, AppliesToFilesOfTheLibrary) {
  const auto value = [](const std::string& key, const std::string& text) {
    return "[[values]]\nkey = \"" + key + "\"\nvalue = " + text + "\nsource = \"test\"\n";
  };
  const std::string gel = "title = \"gel\"\nkind = \"elastic\"\n" +
                          value("density", "\"1 g/cm3\"") + value("youngs_modulus", "\"2 kPa\"") +
                          value("poisson_ratio", "0.25");
  const std::string tough = value("fracture_energy", "\"2 J/m2\"");
  EXPECT_EQ(read_library_material("gel", gel + tough).material().criterion,
            BondCriterion::brittle_band);
  EXPECT_EQ(read_library_material("gel", gel + value("failure_strain", "0.1")).material().criterion,
            BondCriterion::principal_strain);
  EXPECT_EQ(read_library_material("gel", "criterion = \"strain_energy\"\n" + gel + tough)
                .material()
                .criterion,
            BondCriterion::strain_energy);
}

}  // namespace
}  // namespace kerf::test::default_criterion_test
