// SPDX-License-Identifier: Apache-2.0
// What a run needs is told for what it holds, and what is advised names the key that is the cause.
#include "app/cost_advice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "app/checked_case.hpp"
#include "geometry/particle_estimate.hpp"
#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf {
namespace cost_advice_of_cases {

std::string foam(const std::string& machine, const std::string& workpiece,
                 const std::string& after = "") {
  return "title = \"foam\"\ndimension = 3\nquality = \"draft\"\n[machine]\npressure = \"30 MPa\"\n"
         "orifice_diameter = \"0.15 mm\"\nstandoff = \"3 mm\"\ntraverse_speed = \"1 m/s\"\n" +
         machine +
         "[workpiece]\nmaterial = \"polyurethane-foam\"\n"
         "size = [\"300 mm\", \"5 mm\", \"200 mm\"]\n" +
         workpiece + after;
}

CheckedCase checked(const std::string& text) {
  CheckedCase result = checked_case(text, "my.toml");
  result.costed.pace = typical_pace(result.costed.description, 1);
  return result;
}

std::vector<std::string> lines_of(const std::vector<Advice>& list) {
  std::vector<std::string> lines;
  for (const Advice& advice : list) {
    std::string text;
    for (const std::string& line : advice.lines) text += line + "\n";
    lines.push_back(text);
  }
  return lines;
}

bool has(const std::vector<std::string>& lines, const std::string& start) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.rfind(start, 0) == 0; });
}

// A run that may last a second holds no more water than its domain, whatever its end is.
TEST(CostAdvice, WaterThatHasLeftIsNotCounted) {
  const DerivedNumbers usual = derive(checked(foam("", "")).costed.description);
  const Case second = checked(foam("", "", "[time]\nend = \"1 s\"\n")).costed.description;
  const DerivedNumbers numbers = derive(second);
  double room = 1.1;
  for (std::size_t a = 0; a < 3; ++a)
    room *= (second.domain.maximum[a] - second.domain.minimum[a]) / second.jets[0].spacing;
  EXPECT_EQ(numbers.particles_initial, usual.particles_initial);
  EXPECT_GE(numbers.particles_expected, usual.particles_expected);
  EXPECT_LE(static_cast<double>(numbers.particles_expected - numbers.particles_initial), room);
  EXPECT_LT(numbers.particle_memory, 2e9);
  const DerivedNumbers longer =
      derive(checked(foam("", "", "[time]\nend = \"10 s\"\n")).costed.description);
  EXPECT_EQ(longer.particles_expected, numbers.particles_expected);
  // The run is likely to end as early as without that end, and its time is told for that.
  EXPECT_EQ(numbers.likely_end, usual.likely_end);
  EXPECT_NEAR(numbers.particles_mean, usual.particles_mean, 1e-9 * usual.particles_mean);
}

TEST(CostAdvice, AnEndThatIsTooLateIsNamed) {
  const CheckedCase late = checked(
      "title = \"late\"\ndimension = 2\nquality = \"draft\"\n[machine]\npressure = \"50 kPa\"\n"
      "orifice_diameter = \"2 mm\"\nstandoff = \"6 mm\"\nposition = [\"0 mm\", \"6 mm\"]\n"
      "[[body]]\nname = \"gel\"\nmaterial = \"tofu\"\n"
      "shape = { type = \"box\", minimum = [\"-10 mm\", \"0 mm\"], maximum = [\"10 mm\", \"6 mm\"] "
      "}\n[time]\nend = \"10 s\"\n");
  const auto list = cost_advice(late.costed);
  ASSERT_FALSE(list.empty());
  EXPECT_EQ(lines_of(list).front().rfind("[time] end = ", 0), 0u) << lines_of(list).front();
  EXPECT_LT(list.front().after.seconds, 1e-2 * list.front().before.seconds);
}

// A graded body counts as its particles, not as its lattice at the finest spacing.
TEST(CostAdvice, GradedBodiesCountAsTheyAreLaidOut) {
  const std::string text = foam("", "spacing = \"1.5 um\"\n");
  const Case description = parse_case(text, "my.toml", quick_look);
  const auto estimate =
      estimate_particles(description.bodies[0], 3, {description.symmetry, description.domain});
  ASSERT_LT(estimate.total(), ReadEffort{}.most_particles);
  ASSERT_GT(estimate.uniform(3), ReadEffort{}.most_particles);
  const ReadEffort of_a_run{ReadEffort{}.most_particles, quick_look.most_tested};
  EXPECT_NO_THROW(parse_case(text, "my.toml", of_a_run));
  const CheckedCase fine = checked(text);
  EXPECT_FALSE(fine.is_refused);
  EXPECT_TRUE(has(lines_of(cost_advice(fine.costed)), "[workpiece] spacing = "));
}

TEST(CostAdvice, RefusedCasesAreNotCalledValid) {
  const CheckedCase finer = checked(foam("", "spacing = \"0.9 um\"\n"));
  EXPECT_TRUE(finer.is_refused);
  EXPECT_EQ(verdict_of(finer).find("the case is valid"), std::string::npos);
  EXPECT_NE(verdict_of(finer).find("a run refuses this case"), std::string::npos);
  EXPECT_TRUE(has(lines_of(cost_advice(finer.costed)), "[workpiece] spacing = "));
  CheckedCase usual = checked(foam("", ""));
  EXPECT_EQ(verdict_of(usual), "the case is valid");
  usual.memory = 1.0;
  EXPECT_NE(verdict_of(usual).find("too little memory"), std::string::npos);
}

TEST(CostAdvice, NoLineIsGivenTwice) {
  for (const std::string& machine :
       {std::string("pulse_frequency = \"20 kHz\"\nduty = 0.5\n"),
        std::string("orifice_type = \"slit\"\norifice_length = \"2 mm\"\n")}) {
    const auto lines = lines_of(cost_advice(checked(foam(machine, "")).costed));
    EXPECT_GE(lines.size(), 2u);
    EXPECT_EQ(std::set<std::string>(lines.begin(), lines.end()).size(), lines.size());
  }
}

// A graded body cannot be cut by symmetry planes at any place: one or the other.
TEST(CostAdvice, ChangesThatExcludeEachOtherSaySo) {
  const std::string text =
      "title = \"big\"\ndimension = 3\nquality = \"draft\"\n[machine]\npressure = \"3 MPa\"\n"
      "orifice_diameter = \"0.5 mm\"\nstandoff = \"3 mm\"\n"
      "position = [\"0 mm\", \"10 mm\", \"0 mm\"]\n[[body]]\nname = \"block\"\n"
      "material = \"liver\"\nshape = { type = \"box\", minimum = [\"-20 mm\", \"0 mm\", \"-20 "
      "mm\"], maximum = [\"20 mm\", \"10 mm\", \"20 mm\"] }\n";
  const auto list = cost_advice(checked(text).costed);
  const auto lines = lines_of(list);
  std::size_t planes = 0;
  while (planes < lines.size() && lines[planes].rfind("[domain]", 0) != 0) ++planes;
  ASSERT_LT(planes, lines.size());
  ASSERT_FALSE(list[planes].instead_of.empty());
  for (const std::size_t other : list[planes].instead_of) EXPECT_LT(other, planes);
  EXPECT_NE(list[planes].sentence().find("; instead of the "), std::string::npos);
  EXPECT_EQ(list.front().sentence().find("instead of"), std::string::npos);
}

// The runs of a window that travels with its nozzle end where the cut is stationary.
TEST(CostAdvice, LongPathsAreToldHowToEnd) {
  const std::string text =
      "title = \"path\"\ndimension = 2\nquality = \"draft\"\n[machine]\npressure = \"30 MPa\"\n"
      "orifice_diameter = \"0.1 mm\"\nstandoff = \"3 mm\"\ntraverse_speed = \"1 m/s\"\n"
      "[workpiece]\nmaterial = \"fat\"\nsize = [\"300 mm\", \"1 mm\"]\nframe = \"travelling\"\n";
  const CheckedCase path = checked(text);
  const auto list = cost_advice(path.costed);
  const auto lines = lines_of(list);
  EXPECT_TRUE(has(lines, "[time] end = "));
  EXPECT_TRUE(has(lines, "[time] stop = \"stationary\""));
  for (const Advice& advice : list) {
    if (advice.lines.front() != "[time] stop = \"stationary\"") continue;
    EXPECT_LT(advice.after.seconds, 0.1 * advice.before.seconds);
    EXPECT_NE(advice.sentence().find("where the cut is stationary after "), std::string::npos);
  }
  const auto ended =
      lines_of(cost_advice(checked(text + "[time]\nstop = \"stationary\"\n").costed));
  EXPECT_FALSE(has(ended, "[time] stop"));
  EXPECT_FALSE(has(lines_of(cost_advice(checked(foam("", "")).costed)), "[time]"));
}

}  // namespace cost_advice_of_cases
}  // namespace kerf
