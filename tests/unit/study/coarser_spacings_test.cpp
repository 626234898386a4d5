// SPDX-License-Identifier: Apache-2.0
// The coarser spacings of a case with symmetry planes are ones that a run accepts.
#include "study/coarser_spacings.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "input/read.hpp"
#include "input/refine.hpp"
#include "input/write_used.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

// A round jet in the line in which two planes meet, on a block that reaches beyond them; or the
// whole of it, without planes.
Case quarter(double across, double half, const std::string& grading = "",
             const std::string& planes = R"("x-", "z-")") {
  return parse_case(fmt::format(R"(title = "quarter"
dimension = 3
[time]
end = "1 ms"
[domain]
minimum = ["{3} mm", "-10 mm", "{3} mm"]
maximum = ["40 mm", "40 mm", "40 mm"]
symmetry = [{4}]
[[jet]]
name = "j"
speed = "12 m/s"
diameter = "6 mm"
spacing = "{0} mm"
position = ["0 mm", "8 mm", "0 mm"]
standoff = "6 mm"
[[body]]
name = "b"
material = "tofu"
shape = {{ type = "box", minimum = ["-{1} mm", "0 mm", "-{1} mm"], maximum = ["{1} mm", "8 mm", "{1} mm"] }}
spacing = "1 mm"
{2}
)",
                                6.0 / across, half, grading, planes.empty() ? -40 : 0, planes),
                    "quarter.toml");
}

void expect_accepted(const Case& description, double ratio) {
  const std::string text = write_used(refined(description, 1.0 / ratio));
  EXPECT_NO_THROW(parse_case(text, "coarser.toml")) << ratio;
}

TEST(CoarserSpacings, SuitTheirPlanes) {
  for (const double across : {4.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0})
    for (const double half : {7.0, 12.0, 16.0, 19.0, 24.0}) {
      SCOPED_TRACE(fmt::format("{} columns, {} mm", across, half));
      const Case description = quarter(across, half);
      const CoarserSpacings spacings = convergence_spacings(description);
      EXPECT_GE(spacings.ratio, 1.26);
      EXPECT_LE(spacings.ratio, 2.0);
      expect_accepted(description, spacings.ratio);
      if (spacings.count > 1) {
        expect_accepted(description, spacings.ratio * spacings.ratio);
        EXPECT_GE(std::lround(across / spacings.ratio / spacings.ratio), 4);
      }
      const double draft = draft_ratio(description);
      EXPECT_GE(draft, 1.26);
      EXPECT_LE(draft, 2.5);
      expect_accepted(description, draft);
    }
}

// Six columns have the even numbers 4 and 2 below them, of which 2 are too few: one spacing.
TEST(CoarserSpacings, SixColumnsHaveOne) {
  EXPECT_EQ(convergence_spacings(quarter(6.0, 12.0)).count, 1);
  EXPECT_EQ(convergence_spacings(quarter(16.0, 12.0)).count, 2);
}

// Whole coarsest cells, here of 4 mm, are to lie on either side of a plane: 3 of them are 16 mm at
// 1.33 times the spacing.
TEST(CoarserSpacings, SuitGradedBodies) {
  const Case description = quarter(8.0, 16.0, "grading = { levels = 2, width = \"6 mm\" }");
  const CoarserSpacings spacings = convergence_spacings(description);
  EXPECT_NEAR(spacings.ratio, 4.0 / 3.0, 1e-9);
  expect_accepted(description, spacings.ratio);
}

TEST(CoarserSpacings, WithoutPlanesTheJetAloneDecides) {
  for (const double across : {6.0, 8.0, 10.0}) {
    const Case description = quarter(across, 12.0, "", "");
    const CoarserSpacings spacings = convergence_spacings(description);
    EXPECT_EQ(spacings.count, 2);
    EXPECT_DOUBLE_EQ(spacings.ratio, std::clamp(std::sqrt(across / 5.0), 1.26, std::sqrt(2.0)));
    EXPECT_DOUBLE_EQ(draft_ratio(description), across < 10.0 ? std::sqrt(2.0) : 2.0);
  }
}

}  // namespace
}  // namespace kerf
