// SPDX-License-Identifier: Apache-2.0
// Cuts whose faces lie on rows of particles are wider than drawn, which a warning tells.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "app/check_warnings.hpp"
#include "geometry/fill.hpp"
#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf::check_cuts_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Returns a bar of 120 x 20 mm at 1 mm, from which a part is cut.
Case bar_without(const std::string& part, const std::string& more = "") {
  return parse_case(fmt::format(R"(title = "bar"
dimension = 2
[time]
end = "1 ms"
[[body]]
name = "bar"
material = "tofu"
spacing = "1 mm"
shape = {{ type = "difference", parts = [
  {{ type = "box", minimum = ["0 mm", "-10 mm"], maximum = ["120 mm", "10 mm"] }}, {} ] }}
{})",
                                part, more),
                    "bar.toml");
}

std::string slit(double low, double high) {
  return fmt::format(
      "{{ type = \"box\", minimum = [\"-1 mm\", \"{} mm\"], maximum = [\"40 mm\", \"{} mm\"] }}",
      low, high);
}

TEST(CheckCuts, ASlitBetweenRowsOfParticlesIsTold) {
  const Case bar = bar_without(slit(-0.5, 0.5));
  // Two rows of 40 go, of which the slit of 1 mm has room for one: 2320 of 2360 mm2.
  ASSERT_EQ(fill(bar.bodies.front(), 2).size(), 2320u);
  EXPECT_THAT(cut_warnings(bar),
              ElementsAre(AllOf(HasSubstr("about 80 particles of \"bar\""),
                                HasSubstr("wider by half a spacing at each such face"),
                                HasSubstr("1.7% less than the shape"),
                                HasSubstr("body.bar.spacing = 500 um"))));
}

TEST(CheckCuts, OneFaceOnARowIsToldToo) {
  EXPECT_THAT(cut_warnings(bar_without(slit(-0.5, 1.0))), ElementsAre(HasSubstr("about 40 ")));
  const std::string polygon =
      "{ type = \"polygon\", vertices = [[\"-1 mm\", \"-0.5 mm\"], [\"40 mm\", \"-0.5 mm\"], "
      "[\"40 mm\", \"1 mm\"], [\"-1 mm\", \"1 mm\"]] }";
  EXPECT_THAT(cut_warnings(bar_without(polygon)), ElementsAre(HasSubstr("about 40 ")));
}

TEST(CheckCuts, TheRemediesHelp) {
  EXPECT_THAT(cut_warnings(bar_without(slit(-1.0, 1.0))), IsEmpty());
  Case finer = bar_without(slit(-0.5, 0.5));
  finer.bodies.front().spacing *= 0.5;
  EXPECT_THAT(cut_warnings(finer), IsEmpty());
  EXPECT_EQ(fill(finer.bodies.front(), 2).size(), 4u * 2360u);
}

TEST(CheckCuts, AFewParticlesOrThoseOfAnInclusionAreNotTold) {
  EXPECT_THAT(cut_warnings(bar_without(
                  "{ type = \"disc\", centre = [\"60 mm\", \"0 mm\"], radius = \"5 mm\" }")),
              IsEmpty());
  const Case filled = bar_without(slit(4.5, 5.5),
                                  "[[body]]\nname = \"layer\"\nmaterial = \"gelatin-10\"\n"
                                  "spacing = \"1 mm\"\ninclusion_of = \"bar\"\n"
                                  "shape = { type = \"box\", minimum = [\"50 mm\", \"-2.5 mm\"], "
                                  "maximum = [\"90 mm\", \"1.5 mm\"] }\n");
  EXPECT_THAT(cut_warnings(filled), ElementsAre(HasSubstr("about 80 ")));
}

}  // namespace
}  // namespace kerf::check_cuts_test
