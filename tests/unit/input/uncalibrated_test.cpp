// SPDX-License-Identifier: Apache-2.0
// Values of the library that are known within an interval only, and the criterion of a base.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "core/error.hpp"
#include "input/material_library.hpp"
#include "input/read.hpp"
#include "input/write_used.hpp"
#include "model/case.hpp"
#include "model/material_laws.hpp"

namespace kerf::test::uncalibrated_test {
namespace {

using testing::HasSubstr;
using testing::Not;

Case block_case(const std::string& top, const std::string& keys) {
  return parse_case(top +
                        "title = \"a block\"\ndimension = 2\n[time]\nend = \"1 ms\"\n"
                        "[materials.stuff]\n" +
                        keys +
                        "[[body]]\nname = \"block\"\nmaterial = \"stuff\"\nspacing = \"1 mm\"\n"
                        "shape = { type = \"box\", minimum = [\"0 mm\", \"0 mm\"], maximum = "
                        "[\"20 mm\", \"20 mm\"] }\n",
                    "block.toml");
}

Material based(const std::string& keys, const std::string& top = "") {
  const Case read = block_case(top, keys);
  return read.materials.at(static_cast<std::size_t>(read.bodies.at(0).material));
}

TEST(Uncalibrated, ValuesAreThoseThatTheCaseLeaves) {
  const std::string skin = "base = \"skin\"\n";
  EXPECT_EQ(based(skin).uncalibrated,
            "youngs_modulus 70.6 MPa to 160.8 MPa, failure_strain 0.17 to 0.22, fracture_energy "
            "1136 J/m2 to 30.4 kJ/m2");
  const Material measured = based(skin + "failure_strain = 0.2\nyoungs_modulus = \"100 MPa\"\n");
  EXPECT_EQ(measured.uncalibrated, "fracture_energy 1136 J/m2 to 30.4 kJ/m2");
  EXPECT_EQ(measured.fracture_energy, 1800.0);
  EXPECT_EQ(measured.criterion, BondCriterion::crack_band);
  EXPECT_EQ(based(skin + "uncalibrated = \"\"\n").uncalibrated, "");
  EXPECT_EQ(based("base = \"pmma\"\n").uncalibrated, "");
}

TEST(Uncalibrated, IsKeptByTheCaseThatIsWritten) {
  for (const std::string base : {"skin", "muscle", "gelatin-10", "pmma"}) {
    const Case read = block_case("", "base = \"" + base + "\"\n");
    EXPECT_EQ(parse_case(write_used(read), "used.toml"), read) << base;
  }
  const Case other = block_case("",
                                "base = \"muscle\"\ncriterion = \"brittle_band\"\n"
                                "fracture_energy = \"850 J/m2\"\n");
  EXPECT_EQ(parse_case(write_used(other), "used.toml"), other);
}

// Values of the criterion of the base do not outlive it; of two limits one is left.
TEST(Uncalibrated, AnotherCriterionReplacesThatOfTheBase) {
  const Material rock = based(
      "base = \"granite\"\ncriterion = \"brittle_band\"\n"
      "fracture_energy = \"60 J/m2\"\n");
  EXPECT_EQ(rock.laws->principal_stress.tensile_strength, 0.0);
  EXPECT_EQ(rock.uncalibrated, "");
  const std::string simple = "base = \"skin\"\ncriterion = \"principal_strain\"\n";
  const Material by_energy = based(simple), by_strain = based(simple + "failure_strain = 0.3\n");
  EXPECT_EQ(by_energy.failure_strain, 0.0);
  EXPECT_EQ(by_energy.fracture_energy, 1800.0);
  EXPECT_EQ(by_strain.failure_strain, 0.3);
  EXPECT_EQ(by_strain.fracture_energy, 0.0);
  EXPECT_THAT(by_strain.uncalibrated, Not(HasSubstr("fracture_energy")));
}

// That formulation knows a strain alone.
TEST(Uncalibrated, TheFormulationOfThePaperHasTheStrain) {
  const Material skin = based("base = \"skin\"\n", "formulation = \"shinohara2004\"\n");
  EXPECT_EQ(skin.failure_strain, 0.2);
  EXPECT_EQ(skin.fracture_energy, 0.0);
  EXPECT_THAT(skin.uncalibrated, Not(HasSubstr("fracture_energy")));
}

const std::string file =
    "title = \"gum\"\nkind = \"elastic\"\ncriterion = \"principal_stress\"\n"
    "[[values]]\nkey = \"density\"\nvalue = \"1 g/cm3\"\nsource = \"weighed\"\n"
    "[[values]]\nkey = \"youngs_modulus\"\nvalue = \"2 kPa\"\nsource = \"pulled\"\n"
    "[[values]]\nkey = \"poisson_ratio\"\nvalue = 0.25\nsource = \"pulled\"\n"
    "[[values]]\nkey = \"tensile_strength\"\nvalue = \"3 Pa\"\nsource = \"torn\"\n"
    "interval = { low = \"2 Pa\", high = \"4 Pa\", sources = \"two tests\" }\n";

TEST(IntervalOfAFile, IsRead) {
  const LibraryMaterial gum = read_library_material("gum", file);
  const LibraryValue& strength = *gum.find("tensile_strength");
  EXPECT_EQ(strength.interval->low, 2.0);
  EXPECT_EQ(strength.interval->high, 4.0);
  EXPECT_EQ(strength.interval->sources, "two tests");
  EXPECT_EQ(strength.interval_text(), "tensile_strength 2 Pa to 4 Pa");
  EXPECT_EQ(gum.find("density")->interval_text(), "");
  EXPECT_TRUE(gum.has_intervals());
  EXPECT_TRUE(gum.material().can_break());
}

void expect_refused_interval(const std::string& from, const std::string& to,
                             const std::string& because) {
  std::string text = file;
  text.replace(text.find(from), from.size(), to);
  try {
    read_library_material("gum", text);
    ADD_FAILURE() << "read with " << to;
  } catch (const std::logic_error& error) {
    EXPECT_THAT(error.what(), HasSubstr(because));
  }
}

TEST(IntervalOfAFile, IsRefusedWhereItDoesNotHoldTheValue) {
  const std::string outside = "tensile_strength = 3 Pa is not between ";
  expect_refused_interval("\"4 Pa\"", "\"2.5 Pa\"", outside);
  expect_refused_interval("\"2 Pa\"", "\"3.5 Pa\"", outside);
  expect_refused_interval("\"2 Pa\"", "\"2 J\"", "not the unit of a");
  expect_refused_interval(", sources = \"two tests\"", "", "sources must be a text");
  expect_refused_interval("{ low = \"2 Pa\", high = \"4 Pa\", sources = \"two tests\" }", "2",
                          "the interval of tensile_strength must be a table");
  expect_refused_interval("\"principal_stress\"", "\"luck\"", "unknown criterion \"luck\"");
}

}  // namespace
}  // namespace kerf::test::uncalibrated_test
