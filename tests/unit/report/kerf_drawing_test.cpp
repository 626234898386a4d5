// SPDX-License-Identifier: Apache-2.0
// The drawing of a kerf has the given numbers and dimensions to scale.
#include "report/kerf_drawing.hpp"
#include "model/case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
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

// The two halves of the solid are separated by the top width, at the scale of the thickness.
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

// A body that stands on the axis, whose ring the kerf has passed, is drawn in its place; one below
// the kerf, or cut through, is part of what is drawn already.
TEST(KerfDrawing, ShowsABodyThatStandsInTheKerf) {
  Json kerf = slot(0.008, 0.006, false);
  const Json bone = {{"name", "bone"},  {"cut_through", false}, {"unbroken", 0.002},
                     {"face", 0.002},   {"depth", 0.0},         {"thickness", 0.003},
                     {"left", -0.0025}, {"right", 0.0025}};
  kerf["layers"] = {bone};
  const std::string svg = draw_kerf(kerf);
  std::smatch found;
  const std::regex part(
      "<path d=\"M([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)L([0-9.]+) "
      "([0-9.]+)L[^>]*data-standing=\"bone\"");
  ASSERT_TRUE(std::regex_search(svg, found, part)) << svg;
  const double breadth = std::stod(found[3]) - std::stod(found[1]);
  const double height = std::stod(found[6]) - std::stod(found[2]);
  EXPECT_NEAR(breadth / height, 5.0 / 3.0, 0.02);
  EXPECT_THAT(svg, HasSubstr(">bone</text>"));
  kerf["layers"][0]["face"] = 0.006;
  EXPECT_THAT(draw_kerf(kerf), testing::Not(HasSubstr("data-standing")));
  kerf["layers"][0] = bone;
  kerf["layers"][0]["cut_through"] = true;
  EXPECT_THAT(draw_kerf(kerf), testing::Not(HasSubstr("data-standing")));
}

// Ends of the lines whose style holds `style`: x1 y1 x2 y2.
std::vector<std::array<double, 4>> lines(const std::string& svg, const std::string& style) {
  const std::regex line(
      "<path d=\"M([-0-9.]+) ([-0-9.]+)L([-0-9.]+) ([-0-9.]+)\" fill=\"none\" ([^>]*)/>");
  std::vector<std::array<double, 4>> found;
  for (std::sregex_iterator it(svg.begin(), svg.end(), line), end; it != end; ++it)
    if ((*it)[5].str().find(style) != std::string::npos)
      found.push_back(
          {std::stod((*it)[1]), std::stod((*it)[2]), std::stod((*it)[3]), std::stod((*it)[4])});
  return found;
}
constexpr const char* crack = "data-line=\"crack\"";
constexpr const char* jet = "12 3 2 3";

// 4 mm of the 10 mm separated by a crack, which extends from the bottom of the kerf to the far
// face.
TEST(KerfDrawing, ShowsTheCrackOfAPartedWorkpiece) {
  const Json kerf = slot(0.002, 0.001, false);
  EXPECT_TRUE(lines(draw_kerf(kerf), crack).empty());
  EXPECT_TRUE(lines(draw_kerf(slot(0.002, 0.001, true), {0.0, true}), crack).empty());
  const std::string svg = draw_kerf(kerf, {0.0, true});
  const auto cracks = lines(svg, crack), axes = lines(svg, jet);
  ASSERT_EQ(cracks.size(), 1u);
  ASSERT_EQ(axes.size(), 1u);
  const auto [x, y, end_x, end_y] = cracks[0];
  EXPECT_EQ(x, end_x);
  EXPECT_EQ(y, axes[0][3]);
  EXPECT_NEAR((end_y - y) / (end_y - 40.0), 0.4, 0.002);
}

TEST(KerfDrawing, ShowsTheInclinationOfTheJet) {
  const double lean = 0.3;
  const auto axes = lines(draw_kerf(slot(0.002, 0.001, false), {lean, false}), jet);
  ASSERT_EQ(axes.size(), 1u);
  const auto [x, y, end_x, end_y] = axes[0];
  EXPECT_NEAR(std::atan2(end_x - x, end_y - y), lean, 0.001);
  EXPECT_LT(y, 40.0);  // from above the workpiece
}

TEST(KerfDrawing, ShowsTheInclinationInTheViewAlongTheTraverse) {
  Jet leaning;
  leaning.angle = 0.4;
  EXPECT_EQ(lean_of(leaning, 2), 0.4);
  EXPECT_EQ(lean_of(leaning, 3), 0.4);  // at rest: in the plane of the jet
  leaning.traverse = {2.0, 0.0, 0.0};
  EXPECT_NEAR(lean_of(leaning, 3), 0.0, 1e-15);  // forwards
  leaning.azimuth = 0.5 * std::numbers::pi;      // towards z, the right of x
  EXPECT_NEAR(lean_of(leaning, 3), 0.4, 1e-15);
  leaning.traverse = {-2.0, 0.0, 0.0};
  EXPECT_NEAR(lean_of(leaning, 3), -0.4, 1e-15);
}

// Where the label of the depth stands, and the text.
struct DepthLabel {
  double x = 0.0, y = 0.0;
};
DepthLabel depth_label(const std::string& svg) {
  const std::regex text("<text x=\"([0-9.]+)\" y=\"([0-9.]+)\"[^>]*>depth ");
  std::smatch found;
  EXPECT_TRUE(std::regex_search(svg, found, text));
  return {std::stod(found[1]), std::stod(found[2])};
}

// The label of the depth is beside a narrow kerf, below one that is wide, and below the workpiece
// where a wide kerf goes through: no edge of the solid crosses it.
TEST(KerfDrawing, TheLabelOfTheDepthCrossesNoEdge) {
  const std::string narrow = draw_kerf(slot(0.002, 0.001, false));
  const double end_narrow = lines(narrow, "#5b6470\" stroke-width=\"1\"")[3][3];
  EXPECT_LT(depth_label(narrow).y, end_narrow);
  const std::string wide = draw_kerf(slot(0.03, 0.02, false));
  const auto depth_line = lines(wide, "#5b6470\" stroke-width=\"1\"").back();
  EXPECT_GT(depth_label(wide).y, depth_line[3] + 10.0);
  const std::string through = draw_kerf(slot(0.03, 0.03, true));
  const auto whole_line = lines(through, "#5b6470\" stroke-width=\"1\"").back();
  EXPECT_GT(depth_label(through).y, whole_line[3] + 15.0);
  EXPECT_LT(depth_label(through).x, whole_line[0]);
}

TEST(KerfDrawing, WritesALevelOnce) {
  Json flat = slot(0.002, 0.002, false);
  flat["middle"] = flat["bottom"] = flat["top"];
  const std::string svg = draw_kerf(flat), words = ">2\u202fmm at";
  EXPECT_NE(svg.find(words), std::string::npos);
  EXPECT_EQ(svg.find(words), svg.rfind(words));
}

TEST(KerfDrawing, IsEmptyWithoutAKerf) {
  Json nothing = slot(0.0, 0.0, false);
  nothing["depth"] = 0.0;
  EXPECT_EQ(draw_kerf(nothing), "");
  EXPECT_NE(draw_kerf(nothing, {0.0, true}), "");  // separated by a crack alone
}

}  // namespace
}  // namespace kerf
