// SPDX-License-Identifier: Apache-2.0
// A run is continued from a folder whose files are not as it wrote them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <functional>

#include "app/run_loop.hpp"
#include "core/error.hpp"
#include "input/write_used.hpp"
#include "output/checkpoint.hpp"
#include "output/files.hpp"
#include "support/fake_run.hpp"
#include "support/temporary_folder.hpp"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class DamagedRun : public testing::Test {
 protected:
  // Makes the run, or continues it; a signal stops it before that step.
  RunEnd run(Existing existing, std::uint64_t stopped_before = 0) {
    RunLoopSettings settings;
    settings.description = description_;
    settings.case_name = "fake";
    settings.case_text = write_used(description_);
    settings.folder = folder_.path();
    settings.existing = existing;
    settings.quiet = true;
    const auto stop = [=](std::uint64_t step) {
      if (step == stopped_before) std::raise(SIGINT);
    };
    return RunLoop(settings,
                   [&](const Case& of) { return std::make_unique<FakeSimulation>(of, stop); })
        .run();
  }

  TemporaryFolder folder_;
  Case description_ = fake_case();
};

TEST_F(DamagedRun, ResultIsMadeAgain) {
  run_fake(description_, folder_.path());
  const fs::path file = folder_ / "result.json";
  const json whole = json::parse(read_file(file));
  write_file(file, "{ \"verdict\":");
  EXPECT_EQ(run(Existing::resume).signal, 0);
  EXPECT_EQ(json::parse(read_file(file)).at("verdict"), whole.at("verdict"));
}

// A checkpoint with a right checksum may not hold what a run of the case holds.
TEST_F(DamagedRun, CheckpointIsNamed) {
  ASSERT_EQ(run(Existing::refuse, 20).signal, SIGINT);
  const fs::path file = folder_ / "checkpoint.h5";
  const Checkpoint whole = read_checkpoint(file, write_used(description_));
  using Numbers = std::vector<std::uint64_t>;
  struct Change {
    std::function<void(Checkpoint&)> make;
    const char* words;
  };
  for (const auto& [make, words] : std::vector<Change>{
           {[](Checkpoint& c) { c.simulation.arrays.erase("state"); }, "'state' is missing"},
           {[](Checkpoint& c) { c.simulation.arrays["step"] = Numbers{}; }, "another length"},
           {[](Checkpoint& c) {
              c.simulation.arrays["state"] = Numbers{1, 2, 3};
            },
            "another type"},
           {[](Checkpoint& c) { c.simulation.texts.clear(); }, "'limit' is missing"},
           {[](Checkpoint& c) { c.run.arrays.erase("schedule"); }, "schedule"},
           {[](Checkpoint& c) { c.run.arrays["schedule"] = Numbers{1}; }, "damaged"},
           {[](Checkpoint& c) { c.run.texts["limit/x"] = "many"; }, "damaged"}}) {
    Checkpoint changed = whole;
    make(changed);
    write_checkpoint(file, write_used(description_), changed);
    EXPECT_THAT(message_of<UserError>([&] { run(Existing::resume); }),
                AllOf(HasSubstr(file.string()), HasSubstr(words), HasSubstr("--force")));
  }
}

}  // namespace
}  // namespace kerf::test
