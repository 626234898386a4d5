// SPDX-License-Identifier: Apache-2.0
// Runs that a program drives, against the loop of the command.
#include "library/run.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/run_loop.hpp"
#include "core/error.hpp"
#include "input/read.hpp"
#include "support/temporary_folder.hpp"

namespace kerf::test {
namespace {

using testing::HasSubstr;

Case bouncing_block(double end_ms) {
  return parse_case(fmt::format(R"(title = "A block on a plate"
dimension = 2
[time]
end = "{} ms"
[[body]]
name = "block"
material = "tofu"
spacing = "2 mm"
velocity = ["0 m/s", "-1 m/s"]
shape = {{ type = "box", minimum = ["-10 mm", "2 mm"], maximum = ["10 mm", "14 mm"] }}
[[body]]
name = "plate"
role = "rigid"
spacing = "2 mm"
shape = {{ type = "box", minimum = ["-20 mm", "-6 mm"], maximum = ["20 mm", "0 mm"] }}
)",
                                end_ms),
                    "block.toml");
}

RunOptions options_in(const TemporaryFolder& folder, const char* name) {
  RunOptions options;
  options.folder = folder / name;
  options.threads = 1;
  return options;
}

TEST(LibraryRun, StepByStepHasTheBitsOfTheLoop) {
  const TemporaryFolder folder;
  const Case description = bouncing_block(4.0);
  RunLoopSettings settings = settings_of_case(description, "block.toml", folder / "loop");
  settings.quiet = true;
  RunLoop(settings, make_simulation).run();

  {
    kerf::Run stopped(description, "block.toml", options_in(folder, "steps"));
    stopped.step(7);
    EXPECT_EQ(stopped.simulation().step(), 7u);
    stopped.until(0.002);
    const double dt = stopped.simulation().last_step().dt;
    EXPECT_GE(stopped.simulation().time(), 0.002);
    EXPECT_LT(stopped.simulation().time(), 0.002 + dt);
    EXPECT_EQ(stopped.frame().id.size(), stopped.simulation().particles());
    EXPECT_TRUE(nlohmann::json::parse(stopped.result()).contains("verdict"));
    EXPECT_EQ(stopped.picture().substr(1, 3), "PNG");
    EXPECT_FALSE(stopped.is_over());
    stopped.save();
  }
  RunOptions options = options_in(folder, "steps");
  options.resume = true;
  kerf::Run resumed(description, "block.toml", options);
  EXPECT_GE(resumed.simulation().time(), 0.002);
  resumed.finish();
  EXPECT_TRUE(resumed.has_finished());
  EXPECT_TRUE(resumed.is_over());
  EXPECT_EQ(read_file(folder / "steps/series.csv"), read_file(folder / "loop/series.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "steps/report.html"));
  EXPECT_THAT(message_of<UserError>([&] { resumed.step(); }), HasSubstr("has finished"));
  // A run that had finished before has no further steps.
  EXPECT_TRUE(kerf::Run(description, "block.toml", options).has_finished());
}

TEST(LibraryRun, ACaseMadeInAProgramIsCheckedAsAFileIs) {
  const TemporaryFolder folder;
  Case wrong = bouncing_block(4.0);
  wrong.bodies[0].spacing = -1.0;
  EXPECT_THAT(
      message_of<UserError>([&] { kerf::Run(wrong, "mine.toml", options_in(folder, "wrong")); }),
      testing::AllOf(HasSubstr("mine.toml"), HasSubstr("spacing")));
  EXPECT_FALSE(std::filesystem::exists(folder / "wrong"));
}

TEST(LibraryRun, ARunBeyondTheMemoryIsRefused) {
  const TemporaryFolder folder;
  Case large = bouncing_block(4.0);
  large.dimension = 3;
  large.bodies[0].shape.box.minimum = {-10.0, 0.002, -10.0};
  large.bodies[0].shape.box.maximum = {10.0, 0.5, 10.0};
  large.domain = {{-20.0, -1.0, -20.0}, {20.0, 2.0, 20.0}};
  large.bodies.pop_back();
  large.bodies[0].spacing = 0.01;
  EXPECT_THAT(
      message_of<UserError>([&] { kerf::Run(large, "large.toml", options_in(folder, "large")); }),
      testing::AllOf(HasSubstr("the run needs about"), HasSubstr("RunOptions::ignores_memory")));
}

TEST(LibraryRun, AFolderWithARunIsNotReplacedUnasked) {
  const TemporaryFolder folder;
  const Case description = bouncing_block(0.5);
  RunOptions options = options_in(folder, "run");
  kerf::Run(description, "block.toml", options).finish();
  EXPECT_THAT(message_of<UserError>([&] { kerf::Run(description, "block.toml", options); }),
              HasSubstr("run"));
  options.replace = true;
  kerf::Run again(description, "block.toml", options);
  EXPECT_EQ(again.simulation().step(), 0u);
}

}  // namespace
}  // namespace kerf::test
