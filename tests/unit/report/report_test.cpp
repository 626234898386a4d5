// SPDX-License-Identifier: Apache-2.0
#include "report/report.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "app/run_loop.hpp"
#include "core/error.hpp"
#include "input/write_used.hpp"
#include "report/html.hpp"
#include "report/viewer_files.hpp"
#include "support/fake_run.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using test::message_of;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// A complete run of the fake simulation, and its report.
class Report : public testing::Test {
 protected:
  void SetUp() override {
    description_.title = "Cut <of> & \"tofu\"";
    test::run_fake(description_, out_);
    page_ = read_file(out_ / "report.html");
  }
  test::TemporaryFolder folder_;
  std::filesystem::path out_ = folder_ / "out";
  Case description_ = test::fake_case();
  std::string page_;
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
    ++found;
  return found;
}

TEST_F(Report, HasResultPicturesCurvesAndTables) {
  const auto result = nlohmann::json::parse(read_file(out_ / "result.json"));
  EXPECT_THAT(page_, AllOf(HasSubstr(result.at("verdict").get<std::string>()),
                           HasSubstr("Cut &lt;of&gt; &amp; &quot;tofu&quot;"),
                           HasSubstr("Abrasive is not modelled."), HasSubstr("mass_initial"),
                           HasSubstr("acoustic (water)"), HasSubstr("Pressure at the probes"),
                           HasSubstr("Taken away, as laid out")));
  EXPECT_EQ(count(page_, "src=\"data:image/png;base64,iVBOR"), 3u);
  EXPECT_EQ(count(page_, "<svg"), 9u);
  EXPECT_EQ(count(page_, "<table>"), 9u);
}

TEST_F(Report, HasNoExternalResources) {
  EXPECT_FALSE(std::regex_search(page_, std::regex("<(link|iframe|script[^>]*src)")));
  // Names of formats (xmlns) are not loaded; every other address must be inside the page.
  const std::regex address("(src|href)=\"[^d#][^\"]{0,60}");
  std::string outside;
  for (std::sregex_iterator it(page_.begin(), page_.end(), address), end; it != end; ++it)
    outside += it->str() + "\n";
  EXPECT_EQ(outside, "");
}

TEST_F(Report, IdsAreUnique) {
  std::set<std::string> ids;
  std::size_t found = 0;
  const std::regex id("\\sid=\"([^\"]+)\"");
  for (std::sregex_iterator it(page_.begin(), page_.end(), id), end; it != end; ++it, ++found)
    ids.insert((*it)[1]);
  EXPECT_EQ(ids.size(), found);
  EXPECT_GT(found, 0u);
}

TEST_F(Report, ContainsTheUsedCase) {
  const std::size_t begin = page_.find("<details class=\"case\">");
  ASSERT_NE(begin, std::string::npos);
  const std::string part = page_.substr(begin, page_.find("</details>", begin) - begin);
  EXPECT_THAT(part, HasSubstr("<pre>" + html::escape(write_used(description_)) + "</pre>"));
  EXPECT_THAT(part, HasSubstr("Cut &lt;of&gt; &amp;"));
}

// Sets chosen numbers in the result of that run.
class ChangedReport : public Report {
 protected:
  void SetUp() override {
    Report::SetUp();
    result_ = nlohmann::ordered_json::parse(read_file(out_ / "result.json"));
  }
  std::string page() {
    write_file(out_ / "result.json", result_.dump());
    return report_page(out_, description_, {});
  }
  nlohmann::ordered_json result_;
};

TEST_F(ChangedReport, DistinguishesACrackFromAKerf) {
  const std::string words = "parted without loss of material";
  result_["cut_through"] = true;
  result_["cut_through_time"] = 0.003;
  auto& kerf = result_["kerf"];
  kerf["thickness"] = 0.01;
  kerf["depth"] = 0.00534;
  kerf["through"] = true;
  EXPECT_THAT(page(), Not(HasSubstr(words)));
  kerf["through"] = false;
  kerf["through_share"] = 0.0;
  EXPECT_THAT(page(), AllOf(HasSubstr("Below 5.34\u202fmm it " + words + "."),
                            HasSubstr("data-line=\"crack\""), HasSubstr("crack, without loss"),
                            HasSubstr("below it " + words)));
  kerf["removed_below"] = 0.76;
  kerf["middle"]["width"] = nullptr;
  const std::string loss = "with loss of 76\u202f% of the material in the way of the jet";
  EXPECT_THAT(page(),
              AllOf(HasSubstr("it parted " + loss + "."), HasSubstr("below it parted " + loss),
                    HasSubstr("crack, " + loss), Not(HasSubstr(words))));
  result_["cut_through"] = false;
  EXPECT_THAT(page(), AllOf(Not(HasSubstr(words)), Not(HasSubstr(loss))));
}

// The depth of the ring beside a body that is whole is not that in the way of the jet.
TEST_F(ChangedReport, NamesABodyThatStandsWhereTheKerfIsDeeper) {
  result_["kerf"]["depth"] = 0.008;
  result_["kerf"]["layers"] = {{{"name", "bone"},
                                {"verdict", "whole"},
                                {"cut_through", false},
                                {"unbroken", 0.0035},
                                {"face", 0.002},
                                {"left", -0.0025},
                                {"right", 0.0025},
                                {"depth", 0.0},
                                {"through", false},
                                {"thickness", 0.005},
                                {"middle", {{"width", 0.0}}},
                                {"volume", 1.0},
                                {"removed_volume", 0.0}}};
  EXPECT_THAT(page(), HasSubstr("where material is gone, beside bone, which is not cut through"));
  result_["kerf"]["layers"][0]["face"] = 0.008;
  EXPECT_THAT(page(), Not(HasSubstr("where material is gone, beside")));
}

TEST_F(ChangedReport, LabelsEveryDepthAndWidth) {
  result_["front_depth"] = 0.00626;
  result_["kerf"]["depth"] = 0.00534;
  result_["kerf"]["middle"]["width"] = 0.00119;
  result_["kerf_width"] = 0.0103;
  const auto figure = [](const char* name, const char* key, const char* value) {
    return fmt::format("<dt>{}</dt><dd data-key=\"{}\">{}\u202fmm</dd>", name, key, value);
  };
  EXPECT_THAT(
      page(),
      AllOf(HasSubstr(figure("depth of the water front", "front_depth", "6.26")),
            HasSubstr(figure("depth of the kerf", "kerf.depth", "5.34")),
            HasSubstr(figure("width of the kerf in the middle", "kerf.middle.width", "1.19")),
            HasSubstr(figure("width of the opening", "kerf_width", "10.3"))));
}

TEST_F(ChangedReport, StatesThatTheViewerIsMissing) {
  const std::string without = report_page(out_, description_, {});
  const char* words =
      "This Kerf was built without the viewer: pictures instead of the moving scene";
  EXPECT_EQ(count(without, words), 1u);
  EXPECT_EQ(without.find("kerf-run"), std::string::npos);
  EXPECT_EQ(count(without, "src=\"data:image/png;base64,iVBOR"), 3u);
  EXPECT_EQ(count(page_, words), viewer_text("script").empty() ? 1u : 0u);
}

// With very many pictures the page shows some, evenly spaced, and states so.
TEST_F(ChangedReport, LimitsTheNumberOfPictures) {
  const std::string png(900'000, 'x');
  auto& list = result_["pictures"];
  list.clear();
  for (int i = 0; i < 40; ++i) {
    const std::string name = fmt::format("pictures/fake_{:02}.png", i);
    write_file(out_ / name, png);
    list.push_back({{"file", name}, {"time", 1e-3 * i}});
  }
  const std::string text = page();
  EXPECT_LT(text.size(), report_limit);
  EXPECT_EQ(count(text, "<img "), 5u);
  EXPECT_THAT(text, AllOf(HasSubstr("The particles at 0 ms"), HasSubstr("The particles at 39 ms"),
                          HasSubstr("Some of 40 pictures")));
}

// All numbers of the machine in result.json are in the report.
TEST(MachineReport, ShowsAllSettings) {
  std::string text = test::fake_case_text;
  const std::size_t begin = text.find("[[jet]]"), end = text.find("[[probe]]");
  text.replace(begin, end - begin, R"([machine]
pressure = "0.05 MPa"
orifice_diameter = "4 mm"
standoff = "6 mm"
position = ["-5 mm", "10 mm"]
spacing = "1 mm"
lead_angle = "15 deg"
traverse_speed = "100 mm/s"
dwell = "2 ms"
pulse_frequency = "300 Hz"
duty = 0.5
)");
  const Case description = parse_case(text, "fake.toml");
  const test::TemporaryFolder folder;
  test::run_fake(description, folder / "out");
  const std::string page = read_file(folder / "out/report.html");
  const auto result = nlohmann::json::parse(read_file(folder / "out/result.json"));
  for (const auto& [key, value] : result.at("machine").items()) {
    if (!value.is_number()) continue;
    EXPECT_EQ(count(page, "data-key=\"machine." + key + "\""), 1u) << key;
  }
  const std::string thin = "\u202f";
  EXPECT_THAT(page,
              AllOf(HasSubstr(">15°<"), HasSubstr(">300" + thin + "Hz<"), HasSubstr("L/min/m<"),
                    HasSubstr("L/min per mm of depth"), HasSubstr(">100" + thin + "mm/s<"),
                    HasSubstr("<th scope=\"row\">block</th><td>tofu</td>"),
                    HasSubstr("15° from the vertical")));
}

TEST_F(Report, IsReproducible) {
  std::filesystem::remove(out_ / "report.html");
  write_report(out_, description_);
  EXPECT_EQ(read_file(out_ / "report.html"), page_);
}

TEST_F(Report, NamesMissingOrDamagedFiles) {
  const auto refusal = [&] {
    return message_of<UserError>([&] { write_report(out_, description_); });
  };
  const std::string result = read_file(out_ / "result.json");
  write_file(out_ / "result.json", result.substr(0, result.size() / 2));
  EXPECT_THAT(refusal(), AllOf(HasSubstr("result.json is damaged"), HasSubstr("--resume")));
  std::filesystem::remove(out_ / "result.json");
  EXPECT_THAT(refusal(), AllOf(HasSubstr("has not ended yet"), HasSubstr("--resume")));
  write_file(out_ / "result.json", result);
  std::filesystem::remove(out_ / "pictures/fake_01.png");
  EXPECT_THAT(refusal(), HasSubstr("fake_01.png"));
}

}  // namespace
}  // namespace kerf
