// SPDX-License-Identifier: Apache-2.0
#include "app/run_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/progress.hpp"
#include "app/run_record.hpp"
#include "app/schedule.hpp"
#include "core/error.hpp"
#include "output/readable.hpp"
#include "support/results.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;
using test::message_of;
using testing::AllOf;
using testing::HasSubstr;

class Folder : public testing::Test {
 protected:
  std::string refusal(Existing existing, const std::string& case_text = "the case\n") {
    return message_of<UserError>([&] { RunFolder(path_, case_text, existing); });
  }
  void fill() {
    for (const char* name : {"case.used.toml", "series.csv", "result.json", "log.txt",
                             "a.vtkhdf.series", "frames/a_00000.vtkhdf", "pictures/a_00.png"}) {
      fs::create_directories((path_ / name).parent_path());
      write_file(path_ / name, "the case\n");
    }
  }
  test::TemporaryFolder folder_;
  fs::path path_ = folder_ / "out/deep";
};

TEST_F(Folder, IsCreatedIfMissing) {
  EXPECT_FALSE(RunFolder(path_, "the case\n", Existing::refuse).has_checkpoint());
  EXPECT_TRUE(fs::is_directory(path_));
}

TEST_F(Folder, WithARunIsRefusedWithoutForce) {
  fill();
  EXPECT_THAT(refusal(Existing::refuse), AllOf(HasSubstr(path_.string()), HasSubstr("--resume"),
                                               HasSubstr("--force"), HasSubstr("--out")));
  EXPECT_TRUE(fs::exists(path_ / "result.json"));
}

TEST_F(Folder, ForceRemovesResultsOnly) {
  fill();
  write_file(path_ / "notes.txt", "mine");
  write_file(path_ / "photo.png", "mine");
  EXPECT_EQ(refusal(Existing::replace), "");
  EXPECT_EQ(test::names_in(path_),
            (std::set<std::string>{"notes.txt", "photo.png", "frames", "pictures"}));
  EXPECT_TRUE(fs::is_empty(path_ / "frames"));
}

TEST_F(Folder, WithForeignFilesIsNotChanged) {
  fs::create_directories(path_);
  write_file(path_ / "thesis.tex", "years of work");
  for (const Existing existing : {Existing::refuse, Existing::resume, Existing::replace})
    EXPECT_THAT(refusal(existing), HasSubstr("contains no run of Kerf"));
  EXPECT_TRUE(fs::exists(path_ / "thesis.tex"));
}

TEST_F(Folder, WithTemporaryFilesOnlyIsEmpty) {
  fs::create_directories(path_ / "frames");
  write_file(path_ / ".case.used.toml.tmp", "half a ca");
  EXPECT_EQ(refusal(Existing::refuse), "");
}

TEST_F(Folder, OfAnotherCaseIsNotRestarted) {
  fill();
  EXPECT_THAT(refusal(Existing::resume, "another case\n"), HasSubstr("another case"));
  EXPECT_TRUE(fs::exists(path_ / "result.json"));
  EXPECT_EQ(refusal(Existing::resume, "the case\n"), "");
  EXPECT_FALSE(fs::exists(path_ / "result.json"));
}

TEST_F(Folder, IsLockedByOneRun) {
  const RunFolder first(path_, "the case\n", Existing::refuse);
  EXPECT_THAT(refusal(Existing::refuse), HasSubstr("in use by another run"));
}

TEST(Schedule, IsDueOnceForCoincidentTimes) {
  Schedule schedule(std::vector<double>{0.0, 1.0, 1.5, 4.0});
  EXPECT_TRUE(schedule.due(0.0));
  EXPECT_FALSE(schedule.due(0.999));
  EXPECT_TRUE(schedule.due(2.0));
  EXPECT_FALSE(schedule.due(3.999));
  EXPECT_TRUE(schedule.due(4.0));
  EXPECT_FALSE(schedule.due(1e9));
}

TEST(Schedule, RepeatsAndResumes) {
  Schedule schedule(0.1);
  EXPECT_TRUE(schedule.due(0.0));
  EXPECT_FALSE(schedule.due(0.05));
  EXPECT_TRUE(schedule.due(0.1));
  EXPECT_TRUE(schedule.due(0.35));
  Schedule resumed(0.1);
  resumed.restore(schedule.passed());
  EXPECT_FALSE(resumed.due(0.39));
  EXPECT_TRUE(resumed.due(0.4));
  Schedule never(0.0);
  EXPECT_FALSE(never.due(1e9));
}

CutState written_state() {
  CutState state;
  state.is_touched = true;
  state.time = 0.1;
  state.front_depth = 0.2;
  state.cut_depth = 0.15;
  state.pieces = 3;
  state.fractured_fraction = 0.4;
  state.fractured_mass = 0.5;
  state.fractured_width = 0.6;
  state.kerf_width = 0.7;
  state.void_width = 0.05;
  state.cut_through = true;
  state.bodies = {{true, true, false, true}, {true, false}};
  state.wake = {0.8, 0.9, 1.1};
  state.water_impulse = 1.2;
  return state;
}

TEST(RunRecord, IsRestoredFromAnArchive) {
  RunRecord record;
  record.case_name = "tofu";
  record.finished = true;
  record.wall_time = 1.0 / 3.0;
  record.frame_times = {0.0, 0.1};
  record.picture_times = {0.2};
  record.frames_due = 1;
  record.pictures_due = 2;
  record.rows_due = 3;
  record.rows = 4;
  record.limits = {{"acoustic (water)", 5}, {"end of run", 1}};
  record.stage_times = {{"rates", 0.1}};
  record.cut_history = {written_state(), {}};
  record.cut_history[1].bodies.resize(2);
  record.cut_history[1].bodies[0].left = true;
  record.cut_traces = {1, 0, 2};
  record.most_stored = {2.5, 0.25};
  const RunRecord back = record_from(to_archive(record));
  EXPECT_EQ(back.case_name, record.case_name);
  EXPECT_TRUE(back.finished);
  EXPECT_EQ(back.cut_traces, record.cut_traces);
  EXPECT_EQ(back.most_stored.energy, 2.5);
  EXPECT_EQ(back.most_stored.hourglass, 0.25);
  EXPECT_TRUE(back.cut_history.at(1).bodies.at(0).left);
  EXPECT_EQ(back.wall_time, record.wall_time);
  EXPECT_EQ(back.frame_times, record.frame_times);
  EXPECT_EQ(back.picture_times, record.picture_times);
  EXPECT_EQ(back.frames_due, 1u);
  EXPECT_EQ(back.pictures_due, 2u);
  EXPECT_EQ(back.rows_due, 3u);
  EXPECT_EQ(back.rows, 4u);
  EXPECT_EQ(back.limits, record.limits);
  ASSERT_EQ(back.stage_times.size(), 1u);
  EXPECT_EQ(back.stage_times[0].seconds, 0.1);
  ASSERT_EQ(back.cut_history.size(), 2u);
  const CutState& state = back.cut_history[0];
  EXPECT_EQ(state.time, 0.1);
  EXPECT_EQ(state.front_depth, 0.2);
  EXPECT_EQ(state.cut_depth, 0.15);
  EXPECT_EQ(state.pieces, 3);
  EXPECT_EQ(state.fractured_fraction, 0.4);
  EXPECT_EQ(state.fractured_mass, 0.5);
  EXPECT_EQ(state.fractured_width, 0.6);
  EXPECT_EQ(state.kerf_width, 0.7);
  EXPECT_EQ(state.void_width, 0.05);
  EXPECT_EQ(state.wake.depth, 0.8);
  EXPECT_EQ(state.wake.lag, 0.9);
  EXPECT_EQ(state.wake.width, 1.1);
  EXPECT_EQ(state.water_impulse, 1.2);
  EXPECT_TRUE(state.cut_through);
  EXPECT_TRUE(state.is_touched);
  EXPECT_FALSE(back.cut_history[1].cut_through || back.cut_history[1].is_touched);
  ASSERT_EQ(state.bodies.size(), 2u);
  EXPECT_TRUE(state.bodies[0].through && state.bodies[0].severed);
  EXPECT_TRUE(state.bodies[1].through && !state.bodies[1].severed);
  EXPECT_TRUE(state.bodies[0].punched && !state.bodies[1].punched);
  ASSERT_EQ(back.cut_history[1].bodies.size(), 2u);
  EXPECT_FALSE(back.cut_history[1].bodies[0].through);
}

TEST(Progress, LabelsItsNumbers) {
  ProgressNumbers numbers;
  numbers.time = 0.0126;
  numbers.end = 0.03;
  numbers.step = 5120;
  numbers.last_step = {2.5e-6, "acoustic (water)", 1};
  numbers.cut.front_depth = 0.0213;
  numbers.cut.fractured_fraction = 0.0304;
  numbers.energy_drift = -0.001;
  EXPECT_EQ(progress_line(numbers, 200.0),
            " 42.0% | left 3 min 20 s | t 12.6 ms | step 5120 | dt 2.5 us, acoustic (water) | "
            "front 21.3 mm | fractured 3.04% | energy -0.10%");
  EXPECT_EQ(duration_text(12.4), "12 s");
  EXPECT_EQ(duration_text(2.345), "2.3 s");
  EXPECT_EQ(duration_text(200.0), "3 min 20 s");
  EXPECT_EQ(duration_text(3900.0), "1 h 05 min");
  EXPECT_EQ(duration_text(12.3 * 86400.0), "12 days");
  EXPECT_EQ(duration_text(2.5 * 365.25 * 86400.0), "2.5 years");
  EXPECT_EQ(readable(59.5, "s"), "59.5 s");
  EXPECT_EQ(readable(1200.0, "s"), "20 min 00 s");
  EXPECT_EQ(readable(1200.0, "m"), "1.2 km");
  EXPECT_EQ(readable(0.99998e-3, "m"), "1 mm");
  EXPECT_EQ(readable(0.9999e-3, "m"), "999.9 um");
  EXPECT_EQ(duration_text(std::numeric_limits<double>::infinity()), "?");
}

}  // namespace
}  // namespace kerf
