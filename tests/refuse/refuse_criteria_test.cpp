// SPDX-License-Identifier: Apache-2.0
// Fracture criteria with missing or contradictory keys are refused.
#include "refuse/bad_case.hpp"

namespace kerf {
namespace {

TEST(Refuse, IncompleteSoftening) {
  expect_refused({
      {"softening without an energy",
       paper,
       "formulation = \"standard\"\n[materials.curd]\nbase = \"tofu\"\n"
       "criterion = \"crack_band\"",
       "[materials.curd]",
       "materials.curd.fracture_energy: the criterion \"crack_band\" needs it.",
       {"greater than 0"}},
      {"softening without a strain",
       paper,
       "formulation = \"standard\"\n[materials.curd]\nbase = \"tofu\"\n"
       "criterion = \"crack_band\"\nfailure_strain = 0\nfracture_energy = \"2 J/m2\"",
       "failure_strain",
       "materials.curd.failure_strain = 0: the criterion \"crack_band\" needs it.",
       {"greater than 0"}},
      {"softening and flow",
       paper,
       "formulation = \"standard\"\n[materials.curd]\nbase = \"copper\"\n"
       "criterion = \"crack_band\"\nfailure_strain = 0.1\nfracture_energy = \"2 J/m2\"",
       "criterion",
       "materials.curd.criterion = \"crack_band\": the material flows.",
       {"plasticity = \"none\""}},
  });
}

// The block is 40 mm long, E = 60 kPa.
const std::string soft =
    "formulation = \"standard\"\n[materials.curd]\nkind = \"elastic\"\n"
    "density = \"1000 kg/m3\"\nyoungs_modulus = \"60 kPa\"\n"
    "poisson_ratio = 0.3\n";

// A crack would have to open by 2 Gc / (E e_0) = 67 mm; 50 mm are too much, 33 mm are not.
TEST(Refuse, CracksThatOpenWiderThanTheSolids) {
  const auto with = [](const std::string& strain) {
    return soft +
           "criterion = \"crack_band\"\nfracture_energy = \"2 J/m2\"\nfailure_strain = " + strain +
           "\n";
  };
  const auto text_with = [&](const std::string& strain) {
    std::string text = good_case;
    text.replace(text.find(block_material), block_material.size(), "material = \"curd\"");
    text.replace(text.find(paper), paper.size(), "");
    text.replace(text.find("\n[time]"), 1, "\n" + with(strain));
    return text;
  };
  const std::string message = message_of(text_with("0.001"));
  EXPECT_NE(message.find("materials.curd.failure_strain = 0.001: a crack"), std::string::npos)
      << message;
  EXPECT_NE(message.find("opened by 0.0667 m"), std::string::npos) << message;
  EXPECT_NE(message.find("Allowed: 0.00167 or more"), std::string::npos) << message;
  EXPECT_EQ(message_of(text_with("0.002")), "(no error)");
}

}  // namespace
}  // namespace kerf
