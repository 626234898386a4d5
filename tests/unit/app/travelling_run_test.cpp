// SPDX-License-Identifier: Apache-2.0
// A run in a frame that travels ends where its cut is stationary, and says whether it came to that.
#include "app/run_loop.hpp"
#include "engine/device.hpp"
#include "input/write_used.hpp"
#include "output/files.hpp"
#include "support/temporary_folder.hpp"
#include "support/travelling.hpp"

namespace kerf {
namespace {

nlohmann::json result_of_travel(const test::TemporaryFolder& folder, const std::string& time) {
  test::TravellingText text;
  text.time = time;
  RunLoopSettings settings;
  settings.description = text.read();
  settings.case_name = "travelling";
  settings.case_text = write_used(settings.description);
  settings.folder = folder / "run";
  settings.existing = Existing::replace;
  settings.quiet = true;
  RunLoop(settings, make_simulation).run();
  return nlohmann::json::parse(read_file(settings.folder / "result.json"));
}

// Any change is at most the larger of both values, so that a tolerance of 1 ends the run as soon as
// there are two stretches of a cut, of four jet widths each.
TEST(TravellingRun, EndsWhereTheCutIsStationary) {
  const test::TemporaryFolder folder;
  const auto result =
      result_of_travel(folder, "stop = \"stationary\"\nstop_tolerance = 1\nend = \"8 ms\"");
  const double width = result["machine"]["width_at_workpiece"].get<double>();
  EXPECT_TRUE(result["stationary"]["reached"].get<bool>());
  const double travelled = result["stationary"]["travelled"].get<double>();
  EXPECT_GE(travelled, 8.0 * width);
  EXPECT_LT(travelled, 14.0 * width);
  EXPECT_NEAR(result["end_time"].get<double>(), travelled / 10.0, 1e-9);
  EXPECT_GT(result["stationary"]["depth"].get<double>(), 0.0);
  EXPECT_GT(result["stationary"]["force"].get<double>(), 0.0);
  EXPECT_GT(result["balance"]["mass_fed"].get<double>(), 0.0);
  EXPECT_NE(result["verdict"].get<std::string>().find("The cut is stationary after"),
            std::string::npos);
  EXPECT_NE(read_file(folder / "run/log.txt").find("The cut is stationary at"), std::string::npos);
}

TEST(TravellingRun, SaysThatItDidNotBecomeStationary) {
  const test::TemporaryFolder folder;
  const auto result =
      result_of_travel(folder, "stop = \"stationary\"\nstop_tolerance = 1e-6\nend = \"3 ms\"");
  EXPECT_FALSE(result["stationary"]["reached"].get<bool>());
  EXPECT_NEAR(result["end_time"].get<double>(), 3e-3, 1e-15);
  EXPECT_GT(result["stationary"]["change"].get<double>(), 1e-6);
  EXPECT_NE(result["verdict"].get<std::string>().find("did not become stationary within"),
            std::string::npos);
}

}  // namespace
}  // namespace kerf
