// SPDX-License-Identifier: Apache-2.0
// A run that is resumed from a case file of another name goes on under the name of its files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "app/run_loop.hpp"
#include "core/error.hpp"
#include "input/write_used.hpp"
#include "output/checkpoint.hpp"
#include "support/fake_simulation.hpp"
#include "support/results.hpp"
#include "support/temporary_folder.hpp"

namespace kerf::renamed_case_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class RenamedCase : public testing::Test {
 protected:
  void run(const std::string& folder, const std::string& file, Existing existing,
           std::uint64_t stop_at = 0) {
    RunLoopSettings settings = settings_of_case(test::fake_case(), file, folder_ / folder);
    settings.existing = existing;
    settings.quiet = true;
    const auto before_step = [stop_at](std::uint64_t now) {
      if (now == stop_at) std::raise(SIGTERM);
    };
    RunLoop(settings, [&](const Case& description) {
      return std::make_unique<test::FakeSimulation>(description, before_step);
    }).run();
  }
  test::TemporaryFolder folder_;
};

TEST_F(RenamedCase, GoesOnUnderTheNameWithWhichItBegan) {
  run("full", "first.toml", Existing::refuse);
  run("a", "first.toml", Existing::refuse, 200);
  run("a", "renamed.toml", Existing::resume, 300);  // this part saves a checkpoint, too
  run("a", "another.toml", Existing::resume);
  test::expect_same_results(folder_ / "full", folder_ / "a");
  EXPECT_THAT(read_file(folder_ / "a/log.txt"),
              HasSubstr("renamed: the run keeps the name with which it began, first"));
}

TEST_F(RenamedCase, ANameThatLeadsOutOfTheFolderIsRefused) {
  run("a", "first.toml", Existing::refuse, 200);
  const auto file = folder_ / "a/checkpoint.h5";
  const std::string text = write_used(test::fake_case());
  Checkpoint checkpoint = read_checkpoint(file, text);
  checkpoint.run.texts["case_name"] = "../../other";
  write_checkpoint(file, text, checkpoint);
  EXPECT_THAT(test::message_of<UserError>([&] { run("a", "first.toml", Existing::resume); }),
              AllOf(HasSubstr("checkpoint.h5 is damaged"), HasSubstr("no name of a file")));
}

}  // namespace
}  // namespace kerf::renamed_case_test
