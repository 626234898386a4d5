// SPDX-License-Identifier: Apache-2.0
// The plan of kerf check --ranks divides a case as the ranks of a run do.
#include <nlohmann/json.hpp>

#include "input/read.hpp"
#include "model/case.hpp"
#include "ranks/graded_block.hpp"
#include "ranks/rank_runs.hpp"
#include "simulation/run_settings.hpp"
#include "standard/standard.hpp"

namespace kerf::test {
namespace {

// Water beside a block that is bonded, on a rigid plate; the water moves to other cells at once.
constexpr const char* planned_case = R"(title = "Water beside a block"
dimension = 2
gravity = ["0 m/s2", "-9.81 m/s2"]
[time]
end = "1 ms"
[domain]
minimum = ["-60 mm", "-20 mm"]
maximum = ["150 mm", "100 mm"]
[materials.slow]
base = "water"
sound_speed = "15 m/s"
source = "a test"
[[body]]
name = "block"
material = "tofu"
shape = { type = "box", minimum = ["-50 mm", "0 mm"], maximum = ["0 mm", "50 mm"] }
spacing = "1 mm"
[[body]]
name = "pool"
material = "slow"
shape = { type = "box", minimum = ["1 mm", "0 mm"], maximum = ["101 mm", "40 mm"] }
spacing = "1 mm"
[[body]]
name = "plate"
role = "rigid"
shape = { type = "box", minimum = ["-52 mm", "-8 mm"], maximum = ["130 mm", "0 mm"] }
spacing = "1 mm"
)";

std::string water_cube(int across) {
  const std::string side = "\"" + std::to_string(across) + " mm\"";
  return "title = \"Cube of water\"\ndimension = 3\n[time]\nend = \"1 ms\"\n[domain]\nminimum = "
         "[\"-5 mm\", \"-5 mm\", \"-5 mm\"]\nmaximum = [\"105 mm\", \"105 mm\", \"105 mm\"]\n"
         "[materials.slow]\nbase = \"water\"\nsound_speed = \"15 m/s\"\nsource = \"a test\"\n"
         "[[body]]\nname = \"cube\"\nmaterial = \"slow\"\nspacing = \"1 mm\"\nshape = { type = "
         "\"box\", minimum = [\"0 mm\", \"0 mm\", \"0 mm\"], maximum = [" +
         side + ", " + side + ", " + side + "] }\n";
}

struct Counts {
  std::uint64_t particles, ghosts;
};

// A run that shows what this rank has.
class ShownRun : public Standard<2, Mixed> {
 public:
  using Standard<2, Mixed>::Standard;
  Counts counts() const { return {particles_.owned(), particles_.ghosts.count}; }
};

// Not a test of its own: MatchesTheRanksOfARun starts it under mpirun. One rank writes what it
// plans for others, several write what they have.
TEST(RankOfAPlan, WritesItsCounts) {
  const char* const folder = std::getenv("KERF_PLAN_FOLDER");
  if (folder == nullptr) GTEST_SKIP() << "started by another test";
  int count = 1;
  std::string name = "test";
  char* words[] = {name.data(), nullptr};
  char** arguments = words;
  const ranks::Session session(count, arguments);
  const ShownRun run(run_settings(read_case(fs::path(folder) / "case.toml")));
  const int planned = std::atoi(std::getenv("KERF_PLAN_RANKS"));
  std::string text;
  if (ranks::are_several())
    for (const Counts& at : ranks::all(run.counts()))
      text += std::to_string(at.particles) + " " + std::to_string(at.ghosts) + "\n";
  else
    for (const RankLoad& load : run.rank_loads(planned).of)
      text += std::to_string(load.particles) + " " + std::to_string(load.ghosts) + "\n";
  if (ranks::number() == 0)
    write_file(fs::path(folder) / (ranks::are_several() ? "have" : "planned"), text);
}

class PlannedRanks : public Ranks {
 protected:
  // Starts RankOfAPlan with so many ranks, for a plan of `planned`.
  void count_with(int ranks, int planned) const {
    setenv("KERF_PLAN_FOLDER", folder("").c_str(), 1);
    setenv("KERF_PLAN_RANKS", std::to_string(planned).c_str(), 1);
    auto words = words_of_mpirun(ranks, {"--gtest_filter=RankOfAPlan.*"});
    *std::find(words.begin(), words.end(), KERF_PROGRAM) = fs::read_symlink("/proc/self/exe");
    const Ending ending = Program("mpirun", words, folder("counts.log")).wait();
    unsetenv("KERF_PLAN_FOLDER");
    ASSERT_EQ(ending.exit_code, 0) << ending.output;
  }
  // What kerf check prints of the case, with the processor time that it took.
  nlohmann::json plan(int ranks, double* seconds = nullptr) const {
    const Ending ending = Program({"check", folder("case.toml").string(), "--no-timing", "--json",
                                   "--threads", "1", "--ranks", std::to_string(ranks)},
                                  folder("check.log"))
                              .wait();
    EXPECT_EQ(ending.exit_code, 0) << ending.output;
    if (seconds != nullptr) *seconds = ending.processor_time;
    return nlohmann::json::parse(ending.output).at("ranks");
  }
  std::vector<Counts> counts_in(const std::string& name) const {
    std::istringstream text(read_file(folder(name)));
    std::vector<Counts> all;
    for (Counts at{}; text >> at.particles >> at.ghosts;) all.push_back(at);
    return all;
  }
  static void expect_alike(const std::vector<Counts>& a, const std::vector<Counts>& b,
                           double tolerance) {
    ASSERT_EQ(a.size(), b.size());
    std::uint64_t of_a = 0, of_b = 0;
    for (std::size_t r = 0; r < a.size(); ++r) {
      of_a += a[r].particles;
      of_b += b[r].particles;
      EXPECT_NEAR(double(a[r].particles), double(b[r].particles), tolerance) << r;
      EXPECT_NEAR(double(a[r].ghosts), double(b[r].ghosts), tolerance) << r;
    }
    EXPECT_EQ(of_a, of_b);
  }
  void expect_refused(const std::vector<std::string>& options,
                      const std::vector<std::string>& parts) const {
    std::vector<std::string> words{"check", folder("case.toml").string(), "--no-timing"};
    words.insert(words.end(), options.begin(), options.end());
    const Ending ending = Program(words, folder("check.log")).wait();
    EXPECT_NE(ending.exit_code, 0);
    for (const std::string& part : parts)
      EXPECT_NE(ending.output.find(part), std::string::npos) << ending.output;
  }
};

// One cut is the same. Of several ranks each of the later ones may lie on the other side of a piece
// of a row, 12 cells of at most four particles: Zoltan seeks the median in another order there.
TEST_F(PlannedRanks, MatchTheRanksOfARun) {
  constexpr double of_piece = 48.0;
  for (const char* text : {planned_case, jet_on_graded_block}) {
    write_case(text);
    for (const int ranks : {2, 3}) {
      count_with(1, ranks);
      count_with(ranks, ranks);
      expect_alike(counts_in("planned"), counts_in("have"), ranks == 2 ? 0.0 : of_piece);
    }
  }
}

// Each of eight ranks has a box at a corner. Its sides are halves of the cube, but along x cut
// between pieces of rows, which are 12 cells long. A cell is half as wide as the reach of a list,
// 1.4 to 1.7 spacings, and a patch three cells; the ghosts lie in one patch or two beside the box.
TEST_F(PlannedRanks, OfACubeHaveItsCornersAndSlabsAroundThem) {
  constexpr int n = 60;
  write_case(water_cube(n));
  const auto estimates = plan(8).at("estimates");
  ASSERT_EQ(estimates.size(), 4u);
  const auto& last = estimates.back();
  EXPECT_EQ(last.at("ranks"), 8);
  const double particles = last.at("particles"), ghosts = last.at("ghosts");
  const double half = 0.5 * n, piece = 12.0 * 1.7, cell = 1.7;
  EXPECT_GE(particles, half * half * half);
  EXPECT_LE(particles, (half + 0.5 * piece) * (half + cell) * (half + cell));
  const auto slabs = [&](double wide, double along) {
    return (along + wide) * (half + wide) * (half + wide) - along * half * half;
  };
  EXPECT_GE(ghosts, slabs(3.0 * 1.4, half - 0.5 * piece));
  EXPECT_LE(ghosts, slabs(6.0 * 1.7, half + 0.5 * piece));
  EXPECT_EQ(last.at("partners"), 7);
  EXPECT_EQ(estimates.front().at("ghosts"), 0);
  EXPECT_EQ(estimates.front().at("particles"), n * n * n);
}

// More ranks have less each and send less each, but are less even.
TEST_F(PlannedRanks, TenThousandArePlannedInSeconds) {
  write_case(water_cube(47));  // 103 823 particles
  double seconds = 0.0;
  const auto estimates = plan(10000, &seconds).at("estimates");
  ASSERT_EQ(estimates.size(), 15u);
  EXPECT_EQ(estimates.back().at("ranks"), 10000);
  EXPECT_LE(seconds, 20.0);
  for (std::size_t k = 1; k < estimates.size(); ++k) {
    EXPECT_LE(estimates[k].at("particles"), estimates[k - 1].at("particles"));
    EXPECT_LE(estimates[k].at("memory"), estimates[k - 1].at("memory"));
    EXPECT_GE(estimates[k].at("imbalance"), 1.0);
    EXPECT_GT(estimates[k].at("bytes_per_step"), 0.0);
    EXPECT_LE(estimates[k].at("particles").get<double>() + estimates[k].at("ghosts").get<double>(),
              47.0 * 47.0 * 47.0);
  }
  EXPECT_GT(estimates.back().at("imbalance"), estimates[1].at("imbalance"));
  EXPECT_LT(estimates.back().at("efficiency"), 0.5);
}

TEST_F(PlannedRanks, AreRefusedWhereACaseIsNotDivided) {
  write_case(read_file(fs::path(KERF_SOURCE_DIR) / "cases" / "column-on-wall.toml"));
  expect_refused({"--ranks", "8"},
                 {"case.toml: --ranks 8", "'shinohara2004'", "Allowed", "Leave the option out"});
}

}  // namespace
}  // namespace kerf::test
