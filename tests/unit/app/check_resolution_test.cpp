// SPDX-License-Identifier: Apache-2.0
// Warnings of spacings that are too coarse.
#include "app/check_warnings.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "analysis/derived.hpp"
#include "geometry/graded_fill.hpp"
#include "input/read.hpp"
#include "model/case.hpp"
#include "output/pulse_flag.hpp"

namespace kerf {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Case jet_on_block(const std::string& block_spacing, const std::string& grading,
                  const std::string& jet_spacing = "1 mm") {
  return parse_case(fmt::format(R"(
title = "a jet on a block"
dimension = 2
formulation = "standard"
[time]
end = "1 ms"
[[body]]
name = "block"
material = "tofu"
shape = {{ type = "box", minimum = ["-64 mm", "0 mm"], maximum = ["64 mm", "32 mm"] }}
spacing = "{}"
{}
[[jet]]
name = "jet"
speed = "5 m/s"
width = "10 mm"
position = ["0 mm", "32 mm"]
standoff = "20 mm"
spacing = "{}"
)",
                                block_spacing, grading, jet_spacing),
                    "case.toml");
}

TEST(CheckResolution, AdequateSpacingsGiveNoWarning) {
  EXPECT_THAT(resolution_warnings(jet_on_block("1 mm", "")), IsEmpty());
  EXPECT_THAT(
      resolution_warnings(jet_on_block("1 mm", R"(grading = { levels = 2, width = "16 mm" })")),
      IsEmpty());
}

TEST(CheckResolution, WarnsOfACoarseSolid) {
  EXPECT_THAT(resolution_warnings(jet_on_block("2 mm", "")),
              Contains(AllOf(HasSubstr("body[1].spacing (\"block\") = 0.002 m"),
                             HasSubstr("2 x that of the water"), HasSubstr("at most 0.001 m"))));
}

TEST(CheckResolution, WarnsOfANarrowJet) {
  EXPECT_THAT(resolution_warnings(jet_on_block("1 mm", "", "2 mm")),
              Contains(AllOf(HasSubstr("jet[1].spacing (\"jet\") = 0.002 m"),
                             HasSubstr("5 particles wide"), HasSubstr("0.001 m or less"))));
}

// The width of 2 mm is accepted by the reader, but is below two smoothing lengths of 4 mm.
TEST(CheckResolution, WarnsOfThinLevelsAndACoarseCut) {
  const auto warnings =
      resolution_warnings(jet_on_block("1 mm", R"(grading = { levels = 2, width = "6 mm" })"));
  EXPECT_THAT(warnings, Contains(AllOf(HasSubstr("body[1].grading.width (\"block\") = 0.006 m"),
                                       HasSubstr("0.0104 m or more"))));
  EXPECT_THAT(warnings, Contains(HasSubstr("where the cut will be")));
  EXPECT_THAT(warnings, Contains(HasSubstr("2 x that of the water")));
}

// 128 mm x 32 mm are 4096 cells of 1 mm.
TEST(CheckResolution, ParticlesAreCountedByLevel) {
  const auto uniform = particle_rows(jet_on_block("1 mm", ""));
  ASSERT_EQ(uniform.size(), 1u);
  EXPECT_EQ(uniform[0].first, "particles of \"block\"");
  EXPECT_EQ(uniform[0].second, "4096 of 0.001 m");
  const auto graded =
      particle_rows(jet_on_block("1 mm", R"(grading = { levels = 1, width = "16 mm" })"));
  EXPECT_THAT(graded[0].second, AllOf(HasSubstr(" of 0.001 m, "), HasSubstr(" of 0.002 m: "),
                                      HasSubstr("instead of 4096")));
}

// Beside a jet that is finer than the block the layout of a graded one is counted, as it is laid
// out, and fills what the uniform one does: 600 x 15 x 40 of its cells are 15.35 mm high.
TEST(CheckResolution, AGradedBodyIsCountedAndFillsItsShape) {
  const auto text = [](const std::string& grading) {
    return fmt::format(R"(
title = "a jet on a plate"
dimension = 3
[time]
end = "1 ms"
[[body]]
name = "plate"
material = "tofu"
shape = {{ type = "box", minimum = ["-80 mm", "-15.35 mm", "0 mm"], maximum = ["80 mm", "0 mm", "48 mm"] }}
spacing = "1 mm"
{}
[[jet]]
name = "jet"
speed = "5 m/s"
diameter = "10 mm"
position = ["0 mm", "0 mm", "24 mm"]
standoff = "20 mm"
spacing = "1 mm"
)",
                       grading);
  };
  const Case graded = parse_case(text("grading = { levels = 2, width = \"12 mm\" }"), "case.toml");
  const auto levels = count_levels(graded.bodies.front(), 3);
  EXPECT_THAT(
      particle_rows(graded)[0].second,
      HasSubstr(fmt::format("{} of 0.001 m, {} of 0.002 m, {} of 0.004 m: {} instead of "
                            "115200",
                            levels[0], levels[1], levels[2], levels[0] + levels[1] + levels[2])));
  const Case uniform = parse_case(text(""), "case.toml");
  for (const Case& description : {graded, uniform})
    EXPECT_THAT(check_warnings(description, derive(description)),
                Contains(HasSubstr("the particles of \"plate\" fill 2.3% less")));
}

// A lattice of many nodes is estimated, and the row says so.
TEST(CheckResolution, AnEstimateIsNamed) {
  const Case fine = parse_case(R"(
title = "a fine block"
dimension = 3
[time]
end = "1 us"
[[body]]
name = "block"
material = "tofu"
shape = { type = "box", minimum = ["0 mm", "0 mm", "0 mm"], maximum = ["100 mm", "100 mm", "100 mm"] }
spacing = "1 mm"
grading = { levels = 2, width = "12 mm", around = { type = "sphere", centre = ["0 mm", "0 mm", "0 mm"], radius = "5 mm" } }
)",
                               "case.toml");
  EXPECT_THAT(particle_rows(fine)[0].second, testing::StartsWith("about "));
}

// The jet of a slit has few particles across: the default grading is one that needs no warning, and
// a narrower one is told with the key of the [workpiece].
TEST(CheckResolution, TheDefaultGradingOfAWorkpieceIsWideEnough) {
  const auto warnings_of = [](const std::string& more) {
    return resolution_warnings(parse_case(R"(title = "slit"
dimension = 3
quality = "draft"
[machine]
pressure = "100 kPa"
orifice_type = "slit"
orifice_diameter = "1 mm"
orifice_length = "3 mm"
spacing = "0.153 mm"
standoff = "2 mm"
[workpiece]
material = "tofu"
size = ["14 mm", "2 mm", "14 mm"]
)" + more,
                                          "slit.toml"));
  };
  EXPECT_THAT(warnings_of(""), Not(Contains(HasSubstr("grading"))));
  EXPECT_THAT(warnings_of("grading_width = \"1.3 mm\"\n"),
              Contains(testing::StartsWith("workpiece.grading_width = 0.0013 m")));
}

// The pulses of 0.1 mm of the jet, two of which at 0.5 mm make none.
TEST(CheckResolution, WarnsOfPulsesBelowTheSpacing) {
  Case description = jet_on_block("1 mm", "");
  Jet& jet = description.jets.front();
  jet.pulse_frequency = 250.0;
  jet.duty = 0.5;
  EXPECT_THAT(resolution_warnings(description), IsEmpty());  // 10 mm of water, 10 mm of gap
  jet.pulse_frequency = 25e3;
  EXPECT_THAT(resolution_warnings(description),
              Contains(AllOf(HasSubstr("jet[1].pulse_frequency = 25 kHz: each pulse is 100 um"),
                             HasSubstr("at least 2 spacings"), HasSubstr("20 come as one"),
                             HasSubstr("a jet[1].spacing of at most 50 um"),
                             HasSubstr("a frequency of at most 1.25 kHz"))));
  std::vector<ValidityFlag> flags;
  add_pulse_flag(description, flags);
  ASSERT_EQ(flags.size(), 1u);
  EXPECT_EQ(flags[0].name, "pulses");
  EXPECT_EQ(flags[0].state, ValidityFlag::State::warning);
  EXPECT_DOUBLE_EQ(flags[0].limit.value(), 50e-6);
}

// At three coherent lengths the jet is 3 x as wide and 1/9 of it is water: a drop is 4.508 / 9
// diameters of water, 1.002 of the spacings of a half diameter each.
TEST(CheckResolution, NotesDropsBelowTheSpacing) {
  const auto at = [](double lengths) {
    return parse_case(fmt::format(R"(
title = "drops"
dimension = 3
quality = "draft"
[machine]
pressure = "1 MPa"
orifice_diameter = "0.3 mm"
discharge_coefficient = 0.98
coherent_length = "10 mm"
standoff = "{} mm"
position = ["0 mm", "0 mm", "0 mm"]
[time]
end = "10 us"
[[body]]
name = "p"
role = "rigid"
shape = {{ type = "box", minimum = ["-2 mm", "-1 mm", "-2 mm"], maximum = ["2 mm", "0 mm", "2 mm"] }}
)",
                                  10.0 * lengths),
                      "drops.toml");
  };
  std::vector<ValidityFlag> flags;
  add_pulse_flag(at(1.0), flags);
  add_pulse_flag(at(2.0), flags);
  EXPECT_THAT(flags, IsEmpty());
  add_pulse_flag(at(3.0), flags);
  ASSERT_EQ(flags.size(), 1u);
  EXPECT_EQ(flags[0].state, ValidityFlag::State::note);
  EXPECT_THAT(flags[0].sentence,
              AllOf(HasSubstr("machine.standoff = 30 mm: each drop of the broken jet"),
                    HasSubstr("2 come as one"), HasSubstr("a machine.spacing of at most ")));
}

}  // namespace
}  // namespace kerf
