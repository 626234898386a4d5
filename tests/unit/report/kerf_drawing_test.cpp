// SPDX-License-Identifier: Apache-2.0
// The drawing of a kerf carries the numbers it was given, and is as wide as they say.
#include "report/kerf_drawing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace kerf {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

Json slot(double top, double bottom, bool through) {
  return {{"thickness", 0.01},
          {"depth", through ? 0.01 : 0.006},
          {"through", through},
          {"top", {{"below", 0.0005}, {"width", top}}},
          {"middle", {{"below", 0.003}, {"width", 0.5 * (top + bottom)}}},
          {"bottom", {{"below", 0.0055}, {"width", bottom}}}};
}

TEST(KerfDrawing, NamesItsDimensions) {
  const std::string svg = draw_kerf(slot(0.002, 0.001, false));
  EXPECT_THAT(svg, HasSubstr("depth 6\u202fmm"));
  EXPECT_THAT(svg, HasSubstr("thickness 10\u202fmm"));
  for (const char* width : {">2\u202fmm at", ">1.5\u202fmm at", ">1\u202fmm at"})
    EXPECT_THAT(svg, HasSubstr(width));
}

// The two halves of the solid face each other across the top width, at the scale of the thickness.
TEST(KerfDrawing, IsToScale) {
  const std::string svg = draw_kerf(slot(0.004, 0.002, true));
  const std::regex half(
      "<path d=\"M([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)L[^\"]*L[0-9.]+ "
      "([0-9.]+)Z\"");
  std::vector<double> face, top, bottom;
  for (std::sregex_iterator it(svg.begin(), svg.end(), half), end; it != end; ++it) {
    face.push_back(std::stod((*it)[3]));
    top.push_back(std::stod((*it)[2]));
    bottom.push_back(std::stod((*it)[5]));
  }
  ASSERT_EQ(face.size(), 2u);
  EXPECT_NEAR((face[1] - face[0]) / (bottom[0] - top[0]), 0.004 / 0.01, 0.002);
}

TEST(KerfDrawing, IsEmptyWithoutAKerf) {
  Json nothing = slot(0.0, 0.0, false);
  nothing["depth"] = 0.0;
  EXPECT_EQ(draw_kerf(nothing), "");
}

}  // namespace
}  // namespace kerf
