// SPDX-License-Identifier: Apache-2.0
// Warnings of spacings that are too coarse.
#include "app/check_warnings.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

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

}  // namespace
}  // namespace kerf
