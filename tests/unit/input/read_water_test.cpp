// SPDX-License-Identifier: Apache-2.0
// The equation of state and sound speed of a water, and its numerical scheme.
#include <gtest/gtest.h>

#include <string>

#include "analysis/derived.hpp"
#include "core/error.hpp"
#include "input/read.hpp"
#include "input/schema.hpp"
#include "input/write_used.hpp"
#include "model/case.hpp"
#include "model/material_laws.hpp"

namespace kerf {
namespace {

std::string jet_of(const std::string& speed, const std::string& top, const std::string& more = "") {
  return "title = \"jet\"\ndimension = 2\n" + top + "\n[time]\nend = \"1 ms\"\n" + more +
         R"([[body]]
name = "plate"
role = "rigid"
shape = { type = "box", minimum = ["-40 mm", "-4 mm"], maximum = ["40 mm", "0 mm"] }
spacing = "1 mm"
[[jet]]
name = "jet"
width = "10 mm"
position = ["0 mm", "0 mm"]
standoff = "20 mm"
spacing = "1 mm"
speed = ")" +
         speed + "\"\n" + (more.empty() ? "" : "material = \"own\"\n");
}

const std::string standard = "formulation = \"standard\"",
                  paper = "formulation = \"shinohara2004\"";

Case read(const std::string& text) {
  const Case description = parse_case(text, "jet.toml");
  EXPECT_EQ(parse_case(write_used(description), "case.used.toml"), description);
  return description;
}

TEST(ReadWater, SlowJetsAreWeaklyCompressible) {
  const Case slow = read(jet_of("150 m/s", standard));
  EXPECT_EQ(slow.materials[0].equation_of_state, EquationOfState::tait);
  EXPECT_EQ(slow.materials[0].sound_speed, 1500.0);
}

TEST(ReadWater, FastJetsHaveTheRealSoundSpeed) {
  for (const std::string own : {"", "[materials.own]\nbase = \"water\"\n"}) {
    const Case fast = read(jet_of("600 m/s", standard, own));
    EXPECT_EQ(fast.materials[0].equation_of_state, EquationOfState::shock_hugoniot);
    EXPECT_EQ(fast.materials[0].sound_speed, 1481.0);
    EXPECT_EQ(fast.materials[0].laws->shock_hugoniot.slope, 1.975);
    const DerivedNumbers numbers = derive(fast);
    EXPECT_FALSE(numbers.water_is_weakly_compressible);
    EXPECT_NEAR(numbers.hammer_pressure_numerical, 1000.0 * (1481.0 + 1.975 * 600.0) * 600.0, 1.0);
  }
}

// An explicit sound speed, factor, exponent or law is used.
TEST(ReadWater, ExplicitValuesAreKept) {
  const struct {
    const char* key;
    EquationOfState law;
    double sound_speed;
  } table[] = {{"sound_speed = \"1481 m/s\"", EquationOfState::tait, 1481.0},
               {"sound_speed_factor = 8", EquationOfState::tait, 4800.0},
               {"tait_exponent = 6.5", EquationOfState::tait, 6000.0},
               {"equation_of_state = \"tait\"", EquationOfState::tait, 6000.0},
               {"equation_of_state = \"shock_hugoniot\"", EquationOfState::shock_hugoniot, 1481.0}};
  for (const auto& row : table) {
    const Case fast = read(jet_of(
        "600 m/s", standard, std::string("[materials.own]\nbase = \"water\"\n") + row.key + "\n"));
    EXPECT_EQ(fast.materials[0].equation_of_state, row.law) << row.key;
    EXPECT_EQ(fast.materials[0].sound_speed, row.sound_speed) << row.key;
  }
}

TEST(ReadWater, TheShinoharaFormulationHasTaitOnly) {
  const Case fast = read(jet_of("600 m/s", paper));
  EXPECT_EQ(fast.materials[0].equation_of_state, EquationOfState::tait);
  EXPECT_EQ(fast.materials[0].sound_speed, 6000.0);
}

TEST(ReadWater, Numerics) {
  EXPECT_EQ(read(jet_of("5 m/s", standard)).numerics, Numerics{});
  const Case other = read(jet_of("5 m/s", standard,
                                 "[numerics]\nwater = \"delta_sph\"\nshifting = false\n"
                                 "[materials.own]\nbase = \"water\"\n"));
  EXPECT_EQ(other.numerics.water, WaterScheme::delta_sph);
  EXPECT_FALSE(other.numerics.shifting);
}

std::string refusal(const std::string& text) {
  try {
    parse_case(text, "jet.toml");
  } catch (const UserError& error) {
    return error.what();
  }
  return "(no error)";
}

TEST(ReadWater, RefusesKeysOfAnotherLaw) {
  const std::string own = "[materials.own]\nbase = \"water\"\n";
  const std::string shocks = own + "equation_of_state = \"shock_hugoniot\"\n";
  const struct {
    std::string text, key;
  } table[] = {
      {jet_of("600 m/s", standard, own + "hugoniot_slope = 2\n"), "hugoniot_slope = 2"},
      {jet_of("600 m/s", standard, shocks + "tait_exponent = 7\n"), "tait_exponent = 7"},
      {jet_of("600 m/s", standard, shocks + "sound_speed_factor = 9\n"), "sound_speed_factor = 9"},
      {jet_of("600 m/s", standard, shocks + "hugoniot_slope = 0\n"), "hugoniot_slope = 0"},
      {jet_of("600 m/s", paper, shocks), "equation_of_state"},
      {jet_of("600 m/s", standard, own + "equation_of_state = \"ice\"\n"), "shock_hugoniot"},
      {jet_of("5 m/s", paper, "[numerics]\nshifting = true\n" + own), "numerics"},
      {jet_of("5 m/s", standard, "[numerics]\nwater = \"mps\"\n" + own), "delta_sph"}};
  for (const auto& row : table)
    EXPECT_NE(refusal(row.text).find(row.key), std::string::npos) << refusal(row.text);
}

}  // namespace
}  // namespace kerf
