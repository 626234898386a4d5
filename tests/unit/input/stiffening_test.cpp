// SPDX-License-Identifier: Apache-2.0
// A solid that stiffens with stretch is judged by its strain: a strength that is taken by Young's
// modulus at small strains would be passed too late.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"
#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf::test::stiffening_test {
namespace {

// The message of a refusal, empty where the case is read.
std::string refusal(const std::string& keys) {
  try {
    parse_case(
        "title = \"a strip\"\ndimension = 2\n[time]\nend = \"1 ms\"\n[materials.stuff]\n"
        "kind = \"elastic\"\ndensity = \"1100 kg/m3\"\nyoungs_modulus = \"10 MPa\"\n"
        "poisson_ratio = 0.49\nsource = \"test\"\n" +
            keys +
            "[[body]]\nname = \"strip\"\nmaterial = \"stuff\"\nspacing = \"1 mm\"\n"
            "shape = { type = \"box\", minimum = [\"0 mm\", \"0 mm\"], maximum = [\"60 mm\", "
            "\"20 mm\"] }\n",
        "strip.toml");
    return "";
  } catch (const UserError& error) {
    return error.what();
  }
}

TEST(Stiffening, OnlyStrainsJudgeASolidOfOgden) {
  const std::string ogden = "elasticity = \"ogden\"\nogden_exponent = 8.7\n";
  const std::string strain = "failure_strain = 0.4\n", energy = "fracture_energy = \"900 J/m2\"\n";
  const std::string bands[] = {"criterion = \"crack_band\"\n" + strain + energy,
                               "criterion = \"brittle_band\"\n" + energy, energy,
                               "criterion = \"strain_energy\"\n" + strain,
                               "criterion = \"principal_stress\"\ntensile_strength = \"2 MPa\"\n"};
  for (const std::string& keys : bands) {
    EXPECT_THAT(refusal(ogden + keys), testing::HasSubstr("materials.stuff.criterion")) << keys;
    EXPECT_THAT(refusal(ogden + keys), testing::HasSubstr("principal_strain")) << keys;
    EXPECT_EQ(refusal(keys), "") << keys;
    EXPECT_EQ(refusal("elasticity = \"ogden\"\nogden_exponent = 2\n" + keys), "") << keys;
  }
  for (const char* word : {"principal_strain", "equivalent_strain"})
    EXPECT_EQ(refusal(ogden + strain + "criterion = \"" + word + "\"\n"), "") << word;
  EXPECT_EQ(refusal(ogden), "");
}

}  // namespace
}  // namespace kerf::test::stiffening_test
