// SPDX-License-Identifier: Apache-2.0
// `kerf check` answers about cases of any size within 5 s and 200 MB, pilot run included, and
// `kerf run` refuses what does not fit into the memory before it lays anything out.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/derived.hpp"
#include "core/error.hpp"
#include "faults/program.hpp"
#include "input/read.hpp"
#include "model/case.hpp"
#include "support/temporary_folder.hpp"

namespace kerf::test::check_limits {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// Further keys of the machine, the corners of the piece, and further keys of the body.
std::string large_case(const std::string& machine, const std::string& size,
                       const std::string& body) {
  return fmt::format(R"(title = "A large piece"
dimension = 3
[machine]
pressure = "200 MPa"
orifice_diameter = "0.15 mm"
standoff = "2 mm"
position = ["0 mm", "5 mm", "0 mm"]
{}
[[body]]
name = "piece"
material = "liver"
shape = {{ type = "box", {} }}
{}
)",
                     machine, size, body);
}

const char* const wide =
    R"(minimum = ["-150 mm", "-5 mm", "-100 mm"], maximum = ["150 mm", "5 mm", "100 mm"])";
const char* const small =
    R"(minimum = ["-5 mm", "0 mm", "-5 mm"], maximum = ["5 mm", "5 mm", "5 mm"])";
const char* const flat =
    R"(minimum = ["-10 mm", "0 mm", "-5 mm"], maximum = ["10 mm", "5 mm", "5 mm"])";

TEST(CheckLimits, EveryCaseIsAnsweredInTimeAndMemory) {
  const TemporaryFolder folder;
  const std::string graded = "grading = { levels = 3, width = \"0.5 mm\" }";
  for (const std::string& text :
       {large_case("spacing = \"0.01 mm\"", wide, ""), large_case("", flat, graded),
        large_case("traverse_speed = \"1 m/s\"", small, ""),
        large_case("spacing = \"0.01 mm\"", small, "jitter = 0.2")}) {
    write_file(folder / "case.toml", text);
    const Ending ending =
        Program({"check", (folder / "case.toml").string()}, folder / "output.txt").wait();
    EXPECT_EQ(ending.exit_code, 0) << ending.output;
    EXPECT_LT(ending.processor_time, 5.0) << text;
    EXPECT_LT(ending.memory, 200e6) << text;
    for (const char* told : {"particles including jet water", "memory", "steps", "run time",
                             "simulated time", "What to change", "times fewer particles"})
      EXPECT_THAT(ending.output, HasSubstr(told)) << text;
  }
}

TEST(CheckLimits, RunRefusesWhatDoesNotFitIntoTheMemory) {
  const TemporaryFolder folder;
  write_file(folder / "case.toml", large_case("spacing = \"0.011 mm\"", small, "") +
                                       "[output]\nframe_interval = \"1 s\"\n");
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"run", (folder / "case.toml").string(), "--out",
                                   (folder / "out").string()};
    words.insert(words.end(), more.begin(), more.end());
    return Program(words, folder / "output.txt").wait();
  };
  const Ending refused = run({});
  EXPECT_EQ(refused.exit_code, exit_bad_input);
  EXPECT_LT(refused.memory, 200e6);
  EXPECT_THAT(refused.output,
              AllOf(HasSubstr("the run needs about 878 GB"), HasSubstr("Allowed: at most"),
                    HasSubstr("--ignore-memory"), HasSubstr("What to change"),
                    HasSubstr("[machine] spacing = \"0.022 mm\"")));
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

// The memory that is told is that of the process of a run at its peak, program and report included:
// for a case of few particles it is the program, for a larger one mostly what is held for output.
TEST(CheckLimits, TellsTheMemoryOfTheProcessOfARun) {
  const TemporaryFolder folder;
  for (const double spacing : {2.0, 0.4}) {  // mm
    const std::string text = fmt::format(R"(title = "A block"
dimension = 2
[time]
end = "0.1 ms"
[[body]]
name = "block"
material = "tofu"
shape = {{ type = "box", minimum = ["-30 mm", "0 mm"], maximum = ["30 mm", "20 mm"] }}
spacing = "{0} mm"
[[jet]]
name = "jet"
speed = "5 m/s"
width = "12 mm"
position = ["0 mm", "20 mm"]
standoff = "10 mm"
spacing = "{0} mm"
)",
                                         spacing);
    write_file(folder / "case.toml", text);
    const Ending ending = Program({"run", (folder / "case.toml").string(), "--out",
                                   (folder / "out").string(), "--force", "--threads", "1"},
                                  folder / "output.txt")
                              .wait();
    ASSERT_EQ(ending.exit_code, 0) << ending.output;
    const double told = derive(parse_case(text, "case.toml")).memory;
    EXPECT_NEAR(told, ending.memory, 0.25 * ending.memory) << spacing;
  }
}

}  // namespace
}  // namespace kerf::test::check_limits
