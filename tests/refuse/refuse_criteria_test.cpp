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

// A copper whose damage has coefficients; the library's has none.
std::string damaged_copper(const std::string& keys) {
  std::string text = good_case;
  text.replace(text.find(paper), paper.size(),
               "formulation = \"standard\"\n[materials.alloy]\nbase = \"copper\"\n" + keys);
  return text;
}

// The damage of Johnson & Cook grows where a least plastic strain at failure is stated.
TEST(Refuse, DamageThatNothingSwitchesOn) {
  for (const std::string key : {"damage_d1", "damage_d2", "damage_d3", "damage_d4", "damage_d5"}) {
    const std::string message = message_of(damaged_copper(key + " = 0.5\n"));
    EXPECT_NE(message.find("materials.alloy." + key +
                           " = 0.5: without a least_plastic_failure no damage grows."),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("Add least_plastic_failure"), std::string::npos) << message;
    EXPECT_EQ(message_of(damaged_copper(key + " = 0.5\nleast_plastic_failure = 0.01\n"))
                  .find("least_plastic_failure no damage"),
              std::string::npos);
    EXPECT_EQ(message_of(damaged_copper(key + " = 0\n")).find("no damage grows"),
              std::string::npos);
  }
}

// A limit that cannot be read has one problem.
TEST(Refuse, ALimitThatIsNoNumber) {
  std::string text = good_case;
  text.replace(text.find(paper), paper.size(), "formulation = \"standard\"");
  text.insert(text.find("[materials.gel]"),
              "[materials.curd]\nbase = \"tofu\"\ncriterion = \"crack_band\"\n"
              "failure_strain = \"5 %\"\nfracture_energy = \"2 J/m2\"\n");
  const std::string message = message_of(text);
  EXPECT_NE(message.find("failure_strain = \"5 %\": this is a text, not a number"),
            std::string::npos);
  EXPECT_EQ(message.find("needs it"), std::string::npos) << message;
}

// The valid case with a block of this material, 40 mm long with E = 60 kPa.
std::string block_with(const std::string& keys) {
  std::string text = good_case;
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace(block_material, "material = \"curd\"");
  replace(paper, "formulation = \"standard\"");
  replace("[time]",
          "[materials.curd]\nkind = \"elastic\"\ndensity = \"1000 kg/m3\"\n"
          "youngs_modulus = \"60 kPa\"\npoisson_ratio = 0.3\n" +
              keys + "\n[time]");
  return text;
}

void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << message;
}

// A crack would have to open by 2 Gc / (E e_0), 67 mm and 33 mm.
TEST(Refuse, CracksThatOpenWiderThanTheSolids) {
  const std::string keys = "criterion = \"crack_band\"\nfracture_energy = \"2 J/m2\"\n";
  expect_parts(message_of(block_with(keys + "failure_strain = 0.001")),
               {"materials.curd.failure_strain = 0.001: a crack", "opened by 0.0667 m",
                "Allowed: 0.00167 or more", "tensile test"});
  EXPECT_EQ(message_of(block_with(keys + "failure_strain = 0.002")), "(no error)");
}

// Below what single precision resolves: a strain; a fracture energy at the spacing of 2 mm, with
// Gc = 3.2 d M e^2 / 2 and M = 81 kPa; a strength.
TEST(Refuse, LimitsThatAreTooSmall) {
  expect_parts(message_of(block_with("failure_strain = 1e-40")),
               {"materials.curd.failure_strain = 1e-40: the material would break at a strain of "
                "1e-40",
                "Allowed: 0 (never), or 1e-06 or more", "its unit"});
  expect_parts(
      message_of(block_with("criterion = \"principal_strain\"\nfracture_energy = \"1e-12 J/m2\"")),
      {"materials.curd.fracture_energy = \"1e-12 J/m2\": the material would break at",
       "Allowed: 2.58e-10 J/m2 or more"});
  expect_parts(message_of(block_with("fracture_energy = \"1e-12 J/m2\"")),
               {"materials.curd.fracture_energy = \"1e-12 J/m2\": the material would break at",
                "Allowed: 9.54e-10 J/m2 or more"});
  expect_parts(
      message_of(block_with("criterion = \"principal_stress\"\ntensile_strength = \"0.001 Pa\"")),
      {"materials.curd.tensile_strength = \"0.001 Pa\": the material would break at a strain of",
       "Allowed: 0.06 Pa or more"});
  EXPECT_EQ(message_of(block_with("failure_strain = 1e-5")), "(no error)");
}

}  // namespace
}  // namespace kerf
