// SPDX-License-Identifier: Apache-2.0
#include "report/html.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>

#include "report/plot.hpp"

namespace kerf {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// The vectors of RFC 4648, section 10.
TEST(Html, PngUrlIsBase64) {
  const std::string start = "data:image/png;base64,";
  EXPECT_EQ(html::png_address(""), start);
  EXPECT_EQ(html::png_address("f"), start + "Zg==");
  EXPECT_EQ(html::png_address("fo"), start + "Zm8=");
  EXPECT_EQ(html::png_address("foo"), start + "Zm9v");
  EXPECT_EQ(html::png_address("foobar"), start + "Zm9vYmFy");
  EXPECT_EQ(html::png_address(std::string("\xff\x00\xfe", 3)), start + "/wD+");
}

TEST(Html, TextIsEscaped) {
  EXPECT_EQ(html::escape("<b> & \"c\""), "&lt;b&gt; &amp; &quot;c&quot;");
}

// Neither the end of the element nor what makes the parser look past it is in it.
TEST(Html, DataOfAScriptHasNoMarkup) {
  const std::string data = html::data_script("run", R"({"title":"</script><!--<script>"})");
  EXPECT_EQ(data,
            "<script type=\"application/json\" id=\"run\">{\"title\":\"\\u003c/script>"
            "\\u003c!--\\u003cscript>\"}</script>\n");
}

TEST(Html, NumbersAreFormatted) {
  const std::string thin = "\u202f";
  EXPECT_EQ(html::quantity(0.0224, "s"), "22.4" + thin + "ms");
  EXPECT_EQ(html::quantity(59.0, "s"), "59" + thin + "s");
  EXPECT_EQ(html::quantity(2604.8, "s"), "43" + thin + "min 25" + thin + "s");
  EXPECT_EQ(html::quantity(3900.0, "s"), "1" + thin + "h 05" + thin + "min");
  EXPECT_EQ(html::quantity(12500.0, "Pa"), "12.5" + thin + "kPa");
  EXPECT_EQ(html::quantity(0.0, "m"), "0" + thin + "m");
  EXPECT_EQ(html::quantity(0.005, "kg"), "0.005" + thin + "kg");
  EXPECT_EQ(html::quantity(std::numeric_limits<double>::quiet_NaN(), "s"), "—");
  EXPECT_EQ(html::number(0.84284), "0.8428");
  EXPECT_EQ(html::number(1.26e9), "1.26 · 10<sup>9</sup>");
  EXPECT_EQ(html::number(-8e-15), "-8 · 10<sup>-15</sup>");
  EXPECT_EQ(html::count(1234567), "1" + thin + "234" + thin + "567");
  EXPECT_EQ(html::count(123), "123");
  EXPECT_EQ(html::count(8e155), html::number(8e155, 3));
}

// The power would apply to a prefix too.
TEST(Html, UnitsThatBeginWithAPowerGetNoPrefix) {
  const std::string thin = "\u202f";
  EXPECT_EQ(html::quantity(0.011976, "m²/s"), "0.01198" + thin + "m²/s");
  EXPECT_EQ(html::quantity(2e-7, "m³"), "2 · 10<sup>-7</sup>" + thin + "m³");
  EXPECT_EQ(html::quantity(4000.0, "m2"), "4000" + thin + "m2");
  EXPECT_EQ(html::quantity(4000.0, "J/m³"), "4" + thin + "kJ/m³");
  EXPECT_EQ(html::quantity(0.004, "N s/m"), "4" + thin + "mN s/m");
}

TEST(Html, FlowIsInLitresPerMinute) {
  const std::string thin = "\u202f";
  EXPECT_EQ(html::flow_rate(0.011976, 2), "718.6" + thin + "L/min/m");
  EXPECT_EQ(html::flow_rate(1e-4, 3), "6" + thin + "L/min");
  EXPECT_EQ(html::flow_rate(2e-7, 3), "12" + thin + "mL/min");
}

TEST(Html, NumbersThatRoundUpHaveNoExponent) {
  const std::string thin = "\u202f";
  EXPECT_EQ(html::quantity(0.9996e-3, "m", 3), "1" + thin + "mm");
  EXPECT_EQ(html::quantity(0.9994e-3, "m", 3), "999" + thin + "µm");
  EXPECT_EQ(html::number(12345.0), "12345");
  EXPECT_EQ(html::number(99999.9), "1 · 10<sup>5</sup>");
}

TEST(Prefix, BringsNumbersBetweenOneAndAThousand) {
  for (double size = 1e-9; size < 1e14; size *= 3.7) {
    const double shown = size * prefix_for(size).factor;
    EXPECT_GE(shown, 1.0) << size;
    EXPECT_LT(shown, 1000.0) << size;
  }
  EXPECT_EQ(prefix_for(0.02).symbol, "m");
  EXPECT_EQ(prefix_for(0.0).symbol, "");
}

Plot some_plot() {
  Plot plot{{"time", "s"}, {"depth", "m"}, {}, {}, {}, 0.005};
  plot.curves.push_back({"a", {}, palette::curves[0], Stroke::full});
  for (int i = 0; i < 50; ++i) {
    plot.x.push_back(2e-4 * i);
    plot.curves[0].y.push_back(i == 20 ? std::nan("") : 1e-3 * i);
  }
  return plot;
}

TEST(Plot, InterruptsACurveAtMissingValues) {
  const std::string svg = draw_plot(some_plot());
  EXPECT_TRUE(svg.starts_with("<svg"));
  EXPECT_THAT(svg, AllOf(HasSubstr("</svg>"), HasSubstr("viewBox"), HasSubstr(">depth / mm</text>"),
                         HasSubstr(">time / ms</text>"), Not(HasSubstr("nan"))));
  const std::regex curve("<path d=\"([^\"]*)\"[^>]*#0072b2");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(svg, found, curve));
  const std::string commands = found[1];
  EXPECT_EQ(std::count(commands.begin(), commands.end(), 'M'), 2);
  EXPECT_EQ(std::count(commands.begin(), commands.end(), 'L'), 47);
}

// The grid lines are at the numbers below them: a value at 20 mm is on the line "20".
TEST(Plot, DrawsValuesAtTheirCoordinates) {
  Plot plot{{"time", "s"}, {"depth", "m"}, {0.0, 0.010}, {{"a", {0.0, 0.020}}}};
  const std::string svg = draw_plot(plot);
  std::smatch last, tick;
  ASSERT_TRUE(std::regex_search(svg, last,
                                std::regex("L([0-9.]+) ([0-9.]+)\" fill=\"none\" "
                                           "stroke=\"#0072b2\"")));
  ASSERT_TRUE(std::regex_search(svg, tick, std::regex("y=\"([0-9.]+)\"[^>]*>20</text>")));
  EXPECT_NEAR(std::stod(tick[1]) - std::stod(last[2]), 5.0,
              0.11);  // half of the height of the digits
  ASSERT_TRUE(std::regex_search(svg, tick, std::regex("x=\"([0-9.]+)\"[^>]*>10</text>")));
  EXPECT_NEAR(std::stod(tick[1]), std::stod(last[1]), 0.11);
}

TEST(Plot, LinksItsPoints) {
  Plot plot{{"speed in m/s", "1"}, {"width in mm", "1"}};
  plot.points = {{1.0, 4.0, Mark::filled, "cut <through>", "runs/a/report.html"},
                 {5.0, 6.0, Mark::crossed, "failed", ""}};
  EXPECT_THAT(draw_plot(plot),
              AllOf(HasSubstr("<a href=\"runs/a/report.html\"><circle"),
                    HasSubstr("<title>cut &lt;through&gt;</title>"),
                    HasSubstr("<title>failed</title>"), HasSubstr(">speed in m/s</text>")));
}

TEST(Plot, DrawsAnEmptyFrameWithoutData) {
  Plot plot{{"time", "s"}, {"depth", "m"}, {}, {}, {}, -1.0};
  EXPECT_TRUE(draw_plot(plot).starts_with("<svg"));
  plot.x = {0.0};
  plot.curves.push_back({"a", {std::nan("")}, palette::curves[0], Stroke::dashed});
  EXPECT_TRUE(draw_plot(plot).starts_with("<svg"));
  plot.curves[0].y = {-3.0};
  EXPECT_TRUE(draw_plot(plot).starts_with("<svg"));
}

}  // namespace
}  // namespace kerf
