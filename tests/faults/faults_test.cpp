// SPDX-License-Identifier: Apache-2.0
// Faults of a run with the real program: kill -9, signals, full, read-only and deleted folders,
// damaged and foreign checkpoints. Every fault must end with one clear sentence and a non-zero exit
// code, and a resumed run must end with the same bytes as an uninterrupted one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/error.hpp"
#include "faults/program.hpp"
#include "support/results.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;
using test::Ending;
using test::Program;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// A few hundred particles and about a thousand steps, with a checkpoint every twentieth of a
// second.
const std::string case_text = R"(title = "A small block"
dimension = 2
formulation = "shinohara2004"
[time]
end = "6 ms"
[[body]]
name = "block"
material = "tofu"
shape = { type = "box", minimum = ["-16 mm", "0 mm"], maximum = ["16 mm", "12 mm"] }
spacing = "2 mm"
[[body]]
name = "plate"
role = "rigid"
shape = { type = "box", minimum = ["-20 mm", "-4 mm"], maximum = ["20 mm", "0 mm"] }
spacing = "2 mm"
repulsion = "25 m2/s2"
[[jet]]
name = "jet"
material = "water"
speed = "5 m/s"
width = "4 mm"
position = ["0 mm", "12 mm"]
standoff = "6 mm"
spacing = "1 mm"
[output]
frame_interval = "0.1 ms"
picture_times = ["0 ms", "3 ms", "6 ms"]
series_interval = "0.05 ms"
checkpoint_interval = "0.05 s"
)";

class Faults : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::TemporaryFolder>();
    write_file(case_file(), case_text);
    const Ending ending = Program(run_arguments("full"), output()).wait();
    ASSERT_EQ(ending.exit_code, 0) << ending.output;
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static fs::path path(const std::string& name) { return *folder_ / name; }
  static fs::path case_file() { return path("small.toml"); }
  static fs::path output() { return path("output.txt"); }
  static std::vector<std::string> run_arguments(const std::string& name,
                                                const std::string& more = "") {
    std::vector<std::string> words{"run",   case_file().string(), "--threads", "1",
                                   "--out", path(name).string()};
    if (!more.empty()) words.push_back(more);
    return words;
  }
  static Ending run(const std::string& name, const std::string& more = "") {
    return Program(run_arguments(name, more), output()).wait();
  }
  // Runs until a checkpoint exists, then ends the program by the signal.
  static Ending run_and_stop(const std::string& name, int signal) {
    Program program(run_arguments(name), output());
    EXPECT_TRUE(test::wait_for([&] { return fs::exists(path(name) / "checkpoint.h5"); }));
    return program.end(signal);
  }
  static void expect_as_if_never_stopped(const std::string& name) {
    const Ending ending = run(name, "--resume");
    ASSERT_EQ(ending.exit_code, 0) << ending.output;
    test::expect_same_results(path("full"), path(name));
  }
  static double size_or_zero(const fs::path& file) {
    std::error_code missing;
    const std::uintmax_t size = fs::file_size(file, missing);
    return missing ? 0.0 : static_cast<double>(size);
  }
  static std::uintmax_t size_of(const fs::path& folder) {
    std::uintmax_t sum = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) sum += entry.file_size();
    return sum;
  }

  static inline std::unique_ptr<test::TemporaryFolder> folder_;
};

// Kills the program at the start, when the folder is created, and then at random moments until the
// end. The moments are measured by the growing series, so that they hit a running program on
// machines of any speed.
TEST_F(Faults, KilledRunResumesToTheSameResult) {
  std::mt19937 random(20040110);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const auto full_size = static_cast<double>(fs::file_size(path("full/series.csv")));
  constexpr int rounds = 3, kills = 5;
  for (int round = 0; round < rounds; ++round) {
    const std::string name = "killed" + std::to_string(round);
    for (int place = 0; place < kills; ++place) {
      Program program(run_arguments(name, "--resume"), output());
      const double target = full_size * (place - 1 + 0.9 * share(random)) / (kills - 1);
      EXPECT_TRUE(place == 0 || test::wait_for([&] {
                    return size_or_zero(path(name) / "series.csv") >= target;
                  }));
      std::this_thread::sleep_for(std::chrono::duration<double>(0.03 * share(random)));
      EXPECT_EQ(program.end(SIGKILL).signal, SIGKILL) << "it ended before it was killed";
    }
    expect_as_if_never_stopped(name);
  }
}

TEST_F(Faults, ASignalLeavesACheckpointAndAMessage) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string name = "signal" + std::to_string(signal);
    const Ending ending = run_and_stop(name, signal);
    EXPECT_EQ(ending.exit_code, 128 + signal);
    EXPECT_THAT(ending.output, AllOf(HasSubstr("Stopped by"), HasSubstr("--resume"),
                                     HasSubstr(path(name).string())));
    expect_as_if_never_stopped(name);
  }
}

TEST_F(Faults, AFullDiskKeepsTheLastCheckpoint) {
  const test::SmallDisk disk(path("disk"), size_of(path("full")) * 6 / 10);
  if (!disk.there()) GTEST_SKIP() << "mounting a small disk needs root";
  const Ending ending = run("disk/out");
  EXPECT_EQ(ending.exit_code, exit_files) << ending.output;
  EXPECT_THAT(ending.output, AllOf(HasSubstr("cannot write " + path("disk/out").string()),
                                   HasSubstr("No space left on device"), HasSubstr("Free space"),
                                   HasSubstr("--resume")));
  ASSERT_TRUE(fs::exists(path("disk/out/checkpoint.h5")));
  // The disk is still full: the program fails again, and the checkpoint is still valid.
  EXPECT_EQ(run("disk/out", "--resume").exit_code, exit_files);
  disk.resize(4 * size_of(path("full")));
  expect_as_if_never_stopped("disk/out");
}

TEST_F(Faults, AReadOnlyDiskIsNamed) {
  const test::SmallDisk disk(path("read_only"), 1 << 20);
  if (!disk.there()) GTEST_SKIP() << "mounting a small disk needs root";
  disk.make_read_only();
  const Ending ending = run("read_only/out");
  EXPECT_EQ(ending.exit_code, exit_files);
  EXPECT_THAT(ending.output, AllOf(HasSubstr(path("read_only/out").string()),
                                   HasSubstr("Read-only file system"), HasSubstr("--out")));
}

TEST_F(Faults, AnImpossibleFolderIsNamed) {
  const Ending ending = run("small.toml/out");
  EXPECT_EQ(ending.exit_code, exit_files);
  EXPECT_THAT(ending.output, AllOf(HasSubstr(path("small.toml/out").string()),
                                   HasSubstr("Not a directory"), HasSubstr("choose another")));
}

TEST_F(Faults, ADeletedFolderIsNamedAndNotRecreated) {
  Program program(run_arguments("vanished"), output());
  ASSERT_TRUE(test::wait_for([&] { return fs::exists(path("vanished/checkpoint.h5")); }));
  fs::rename(path("vanished"), path("moved"));
  const Ending ending = program.wait();
  EXPECT_EQ(ending.exit_code, exit_files);
  EXPECT_THAT(ending.output, AllOf(HasSubstr(path("vanished").string()), HasSubstr("restore it"),
                                   HasSubstr("--resume")));
  EXPECT_FALSE(fs::exists(path("vanished")));
  expect_as_if_never_stopped("moved");
}

TEST_F(Faults, ATruncatedCheckpointIsRefusedAndKept) {
  run_and_stop("damaged", SIGKILL);
  const fs::path checkpoint = path("damaged/checkpoint.h5");
  const std::string half = read_file(checkpoint).substr(0, fs::file_size(checkpoint) / 2);
  write_file(checkpoint, half);
  const Ending ending = run("damaged", "--resume");
  EXPECT_EQ(ending.exit_code, exit_files);
  EXPECT_THAT(ending.output,
              AllOf(HasSubstr(checkpoint.string()), HasSubstr("is damaged"), HasSubstr("--force")));
  EXPECT_EQ(read_file(checkpoint), half);
  EXPECT_EQ(run("damaged", "--force").exit_code, 0);
  test::expect_same_results(path("full"), path("damaged"));
}

TEST_F(Faults, ACheckpointOfAnotherCaseIsRefused) {
  run_and_stop("other", SIGKILL);
  std::string faster = case_text;
  faster.replace(faster.find("5 m/s"), 5, "6 m/s");
  write_file(path("faster.toml"), faster);
  const Ending ending =
      Program({"run", path("faster.toml").string(), "--out", path("other").string(), "--resume"},
              output())
          .wait();
  EXPECT_EQ(ending.exit_code, exit_files);
  EXPECT_THAT(ending.output, AllOf(HasSubstr("belongs to another case"), HasSubstr("\"50 m/s\""),
                                   HasSubstr("\"60 m/s\""), HasSubstr("--out")));
  expect_as_if_never_stopped("other");
}

TEST_F(Faults, ARunIsReplacedOnlyByForce) {
  const std::string before = read_file(path("full/result.json"));
  const Ending ending = run("full");
  EXPECT_EQ(ending.exit_code, exit_files);
  EXPECT_THAT(ending.output, AllOf(HasSubstr("contains a run already"), HasSubstr("--resume"),
                                   HasSubstr("--force"), HasSubstr("--out")));
  const Ending again = run("full", "--resume");
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_THAT(again.output, HasSubstr("finished already"));
  EXPECT_EQ(read_file(path("full/result.json")), before);
}

TEST_F(Faults, TwoRunsDoNotShareAFolder) {
  Program first(run_arguments("shared"), output());
  ASSERT_TRUE(test::wait_for([&] { return fs::exists(path("shared/checkpoint.h5")); }));
  const Ending second = Program(run_arguments("shared", "--resume"), path("second.txt")).wait();
  EXPECT_EQ(second.exit_code, exit_files);
  EXPECT_THAT(second.output, HasSubstr("in use by another run"));
  EXPECT_EQ(first.wait().exit_code, 0);
}

// A limit of the size of files ends a run with a message, not by the signal SIGXFSZ.
TEST_F(Faults, ALimitOfFileSizesIsNamed) {
  const auto limited = [&](rlim_t bytes) {
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  };
  limited(20'000);
  const Ending ending = run("limited");
  limited(RLIM_INFINITY);
  EXPECT_EQ(ending.signal, 0);
  EXPECT_EQ(ending.exit_code, exit_files);
  EXPECT_THAT(ending.output, AllOf(HasSubstr("cannot write"), HasSubstr("File too large")));
}

TEST_F(Faults, AFullStandardOutputIsNamed) {
  for (const char* command : {"materials", "new plate", "check --keys"}) {
    const std::string line = std::string(KERF_PROGRAM) + " " + command + " 2>" +
                             path("message").string() + " >/dev/full";
    const int status = std::system(line.c_str());
    EXPECT_EQ(WEXITSTATUS(status), exit_files) << command;
    EXPECT_THAT(read_file(path("message")), HasSubstr("the standard output")) << command;
  }
}

// The report leaves out what is lost.
TEST_F(Faults, ALostFrameIsLeftOut) {
  fs::copy(path("full"), path("lost"), fs::copy_options::recursive);
  const auto frame = std::next(fs::directory_iterator(path("lost/frames")));
  fs::remove(frame->path());
  fs::remove(path("lost/report.html"));
  const Ending ending = Program({"report", path("lost").string()}, output()).wait();
  EXPECT_EQ(ending.exit_code, 0) << ending.output;
  EXPECT_TRUE(fs::exists(path("lost/report.html")));
}

TEST_F(Faults, NoFaultLeavesPartsOfFiles) {
  for (const auto& entry : fs::recursive_directory_iterator(path("full")))
    EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr(".tmp")));
}

}  // namespace
}  // namespace kerf
