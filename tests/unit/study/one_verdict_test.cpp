// SPDX-License-Identifier: Apache-2.0
// The headline, result.json, the report and a study say the same of a run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/files.hpp"
#include "report/report_parts.hpp"
#include "study/metrics.hpp"
#include "study/run_table.hpp"
#include "support/fake_run.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

// How the block of the fake simulation ends.
enum class Ending { cut, layer_left, cracked, whole };

// The fake simulation with bonds: its lowest layer is left, and has been pushed ahead to five times
// its length; or it breaks no particle, and a crack parts it from half of the run on, or not.
class BondedFake : public test::FakeSimulation {
 public:
  BondedFake(const Case& description, Ending ending)
      : FakeSimulation(description), end_(description.time.end), ending_(ending) {}

  Frame frame() const override {
    Frame frame = FakeSimulation::frame();
    const bool is_parted = ending_ == Ending::cracked && time() > 0.5 * end_;
    for (std::size_t k = 0; k < frame.id.size(); ++k) {
      const auto& x = frame.position[k];
      const bool is_solid = frame.source[k] == 0;
      if (is_solid && (ending_ == Ending::cracked || ending_ == Ending::whole ||
                       (ending_ == Ending::layer_left && x[1] < 4e-3)))
        frame.category[k] = Category::solid;
      const bool is_bonded = frame.category[k] == Category::solid;
      const bool is_right = (is_parted || ending_ == Ending::cut) &&
                            frame.category[k] == Category::solid && has_parted() && x[0] > 0.0;
      frame.piece.push_back(is_bonded ? (is_right ? 1u : 0u) : frame.id[k] + 2u);
    }
    frame.body_piece = frame.piece;
    if (ending_ == Ending::layer_left)
      for (std::size_t k = 0; k < frame.id.size(); ++k)
        if (frame.category[k] == Category::solid && std::abs(frame.position[k][0]) < 2e-3)
          frame.position[k][1] -= 2e-2 * time() / end_;
    return frame;
  }

 private:
  bool has_parted() const {
    return ending_ == Ending::cracked ? time() > 0.5 * end_ : 1.2e-2 * time() / end_ > 1e-2;
  }
  double end_;
  Ending ending_;
};

struct Expected {
  Ending ending;
  bool is_cut, is_through;
  const char* headline;
};

void run(const Case& description, Ending ending, const std::filesystem::path& folder) {
  RunLoopSettings settings;
  settings.description = description;
  settings.case_name = "fake";
  settings.case_text = write_used(description);
  settings.folder = folder;
  settings.quiet = true;
  RunLoop(settings, [ending](const Case& of) {
    return std::make_unique<BondedFake>(of, ending);
  }).run();
}

TEST(OneVerdict, IsSaidByHeadlineResultReportAndStudy) {
  const test::TemporaryFolder folder;
  int number = 0;
  for (const Expected& expected :
       {Expected{Ending::cut, true, true, "The jet cuts through after .*in 2 pieces\\."},
        Expected{
            Ending::layer_left, false, false,
            "The jet does not cut through within .* deep, and .* of the thickness is "
            "unbroken; the workpiece has bent or moved by .*; the run ended while solid still tore "
            "or the front went deeper\\."},
        Expected{
            Ending::cracked, true, false,
            "The workpiece is parted after 5.* by a crack without loss of material in its way; "
            "at the end the workpiece is in 2 pieces\\."},
        Expected{Ending::whole, false, false, "The jet breaks nothing within .*"}}) {
    SCOPED_TRACE(expected.headline);
    const auto out = folder / std::to_string(number++);
    run(test::fake_case(), expected.ending, out);
    const auto result = nlohmann::ordered_json::parse(read_file(out / "result.json"));
    const auto headline = result.at("verdict").get<std::string>();
    EXPECT_THAT(headline, MatchesRegex(expected.headline));
    EXPECT_EQ(result.at("cut_through").get<bool>(), expected.is_cut);
    EXPECT_EQ(result.at("cut_through_time").is_null(), !expected.is_cut);
    EXPECT_EQ(result.at("cut_through_by").is_null(), !expected.is_cut);
    EXPECT_EQ(result.at("kerf").at("through").get<bool>(), expected.is_through);
    EXPECT_LE(result.at("opening").at("through").get<bool>(), expected.is_cut);
    const double margin = result.at("kerf").at("margin").get<double>();
    EXPECT_EQ(margin > 0.0, expected.is_cut);
    EXPECT_EQ(result.at("kerf").at("unbroken").get<double>() > 0.0, !expected.is_cut);
    const std::string page = read_file(out / "report.html");
    EXPECT_THAT(page, HasSubstr(expected.is_cut ? "<p class=\"verdict yes\"><b>✓</b>"
                                                : "<p class=\"verdict no\"><b>✗</b>"));
    EXPECT_THAT(page, HasSubstr(headline));
    EXPECT_EQ(is_parted(result), expected.is_cut && !expected.is_through);
    RunRow row;
    row.state = RunState::done;
    row.metrics = read_metrics(read_file(out / "result.json"));
    // The front goes deeper until the run ends, which decides nothing of a cut that is not through.
    EXPECT_EQ(verdict_of(row), expected.is_cut ? RunVerdict::cut_through
                               : expected.ending == Ending::layer_left
                                   ? RunVerdict::undecided
                                   : RunVerdict::not_cut_through);
    EXPECT_EQ(row.metrics.at("kerf.margin"), margin);
  }
}

// The same block of a material without a limit is never cut through.
TEST(OneVerdict, OfAMaterialWithoutALimitIsNeverCutThrough) {
  Case description = test::fake_case();
  for (Material& material : description.materials) material.failure_strain = 0.0;
  const test::TemporaryFolder folder;
  for (const Ending ending : {Ending::cut, Ending::layer_left, Ending::cracked, Ending::whole}) {
    const auto out = folder / std::to_string(static_cast<int>(ending));
    run(description, ending, out);
    const auto result = nlohmann::ordered_json::parse(read_file(out / "result.json"));
    EXPECT_FALSE(result.at("cut_through").get<bool>());
    EXPECT_FALSE(result.at("kerf").at("through").get<bool>());
    EXPECT_FALSE(result.at("opening").at("through").get<bool>());
    EXPECT_THAT(result.at("verdict").get<std::string>(), Not(HasSubstr("cuts through")));
    EXPECT_THAT(read_file(out / "report.html"), HasSubstr("<p class=\"verdict no\">"));
  }
}

}  // namespace
}  // namespace kerf
