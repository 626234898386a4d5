// SPDX-License-Identifier: Apache-2.0
// The effect of `inclusion_of` on the shapes, lattices and bonds of a case.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/error.hpp"
#include "geometry/fill.hpp"
#include "input/read.hpp"
#include "input/write_used.hpp"
#include "model/case.hpp"
#include "support/runs.hpp"
#include "support/temporary_folder.hpp"

namespace kerf::test {
namespace {

using testing::HasSubstr;

const std::string head = R"(title = "inclusions"
dimension = 2
[time]
end = "1 ms"
[materials.gel]
kind = "elastic"
density = "1000 kg/m3"
youngs_modulus = "100 kPa"
poisson_ratio = 0.3
[materials.water]
base = "water"
sound_speed = "20 m/s"
[domain]
minimum = ["-30 mm", "-30 mm"]
maximum = ["30 mm", "30 mm"]
)";

std::string body(const std::string& name, const std::string& shape, const std::string& more = "",
                 const std::string& material = "gel") {
  return "[[body]]\nname = \"" + name + "\"\nmaterial = \"" + material +
         "\"\nspacing = \"1 mm\"\n" + "shape = { " + shape +
         " }\nvelocity_expression = [\"20*x\", \"-10*y\"]\n" + more + "\n";
}

const std::string square =
    R"(type = "box", minimum = ["-10 mm", "-10 mm"], maximum = ["10 mm", "10 mm"])";
// Without the shift their lattices, which are centred, do not match that of the square.
const std::string disc = R"(type = "disc", centre = ["1.3 mm", "0.7 mm"], radius = "6 mm")";
const std::string core = R"(type = "disc", centre = ["1.1 mm", "0.9 mm"], radius = "2.7 mm")";

using Cell = std::pair<long, long>;
Cell cell_of(const std::array<double, 3>& x) {
  return {std::lround(x[0] / 1e-3 - 0.5), std::lround(x[1] / 1e-3 - 0.5)};
}

TEST(InclusionOf, EveryLatticeNodeHasOneParticle) {
  const Case read =
      parse_case(head + body("square", square) + body("disc", disc, "inclusion_of = \"square\"") +
                     body("core", core, "inclusion_of = \"disc\"", "water"),
                 "case.toml");
  std::map<Cell, int> found;
  std::size_t least = 1000;
  for (const Body& one : read.bodies) {
    const auto particles = fill(one, 2);
    least = std::min(least, particles.size());
    for (const Point& x : particles) {
      ++found[cell_of(x)];
      EXPECT_NEAR(x[0] / 1e-3 - 0.5, std::round(x[0] / 1e-3 - 0.5), 1e-9);
      EXPECT_NEAR(x[1] / 1e-3 - 0.5, std::round(x[1] / 1e-3 - 0.5), 1e-9);
    }
  }
  EXPECT_GT(least, 15u);
  EXPECT_EQ(found.size(), 400u);
  for (const auto& [place, count] : found) EXPECT_EQ(count, 1);
  EXPECT_EQ(read.bodies[1].joined_to, "square");
  EXPECT_EQ(read.bodies[2].joined_to, "");  // water has no bonds
  EXPECT_EQ(parse_case(write_used(read), "case.used.toml"), read) << write_used(read);
}

// The lattice of a square that is turned by 20 degrees goes on in its inclusions.
TEST(InclusionOf, ATurnedLatticeGoesOnInTheInclusions) {
  const std::string turned =
      R"(type = "polygon", vertices = [["-5.9767 mm", "-12.8171 mm"], ["12.8171 mm", "-5.9767 mm"],)"
      R"( ["5.9767 mm", "12.8171 mm"], ["-12.8171 mm", "5.9767 mm"]])";
  const std::string slot =
      R"(type = "box", minimum = ["-4 mm", "-1 mm"], maximum = ["4 mm", "1 mm"])";
  const Case read =
      parse_case(head + body("square", turned) + body("disc", disc, "inclusion_of = \"square\"") +
                     body("slot", slot, "inclusion_of = \"disc\"", "water"),
                 "case.toml");
  std::map<Cell, int> found;
  const double c = std::cos(0.3490658503988659), s = std::sin(0.3490658503988659);
  for (const Body& one : read.bodies)
    for (const Point& x : fill(one, 2)) {
      const Point back{c * x[0] + s * x[1], -s * x[0] + c * x[1], 0.0};
      ++found[cell_of(back)];
      EXPECT_NEAR(back[0] / 1e-3 - 0.5, std::round(back[0] / 1e-3 - 0.5), 1e-3);
      EXPECT_NEAR(back[1] / 1e-3 - 0.5, std::round(back[1] / 1e-3 - 0.5), 1e-3);
    }
  EXPECT_EQ(found.size(), 400u);
  for (const auto& [place, count] : found) EXPECT_EQ(count, 1);
  EXPECT_EQ(parse_case(write_used(read), "case.used.toml"), read) << write_used(read);
}

// An inclusion with the modulus of the surrounding body has no effect on the motion. Particles are
// identified by their initial positions; in double precision only the order of sums differs.
TEST(InclusionOf, OfTheSameMaterialMovesAsOneBody) {
  const std::string exact = "precision = \"double\"\n";
  const auto whole =
      make_simulation(parse_case(exact + head + body("square", square), "whole.toml"));
  const auto parts = make_simulation(parse_case(
      exact + head + body("square", square) + body("disc", disc, "inclusion_of = \"square\""),
      "parts.toml"));
  std::map<Cell, std::size_t> row_of;
  const Frame start = whole->frame(), start_of_parts = parts->frame();
  std::map<std::uint64_t, Cell> place;
  std::map<Cell, std::array<double, 3>> expected;
  for (std::size_t i = 0; i < start.id.size(); ++i) place[start.id[i]] = cell_of(start.position[i]);
  take_steps(*whole, 200);
  take_steps(*parts, 200);
  const Frame end = whole->frame(), end_of_parts = parts->frame();
  double furthest = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < end.id.size(); ++i) expected[place[end.id[i]]] = end.position[i];
  place.clear();
  for (std::size_t i = 0; i < start_of_parts.id.size(); ++i)
    place[start_of_parts.id[i]] = cell_of(start_of_parts.position[i]);
  ASSERT_EQ(end_of_parts.id.size(), expected.size());
  for (std::size_t i = 0; i < end_of_parts.id.size(); ++i) {
    const Cell cell = place[end_of_parts.id[i]];
    for (std::size_t a = 0; a < 2; ++a) {
      const double laid_out = 1e-3 * (static_cast<double>(a == 0 ? cell.first : cell.second) + 0.5);
      worst = std::max(worst, std::abs(end_of_parts.position[i][a] - expected[cell][a]));
      furthest = std::max(furthest, std::abs(expected[cell][a] - laid_out));
    }
  }
  EXPECT_GT(furthest, 1e-5);
  EXPECT_LT(worst, 1e-9 * furthest);
}

TEST(InclusionOf, InvalidInclusionsAreRefused) {
  const auto refusal = [](const std::string& bodies) {
    return message_of<UserError>([&] { parse_case(head + bodies, "bad.toml"); });
  };
  EXPECT_THAT(refusal(body("square", square) + body("disc", disc, "inclusion_of = \"sqare\"")),
              HasSubstr("inclusion_of = \"sqare\": this is not another elastic body. Allowed: "
                        "square. Did you mean \"square\"?"));
  EXPECT_THAT(refusal(body("square", square) +
                      body("disc", disc, "inclusion_of = \"square\"\njoined_to = \"square\"")),
              HasSubstr("an inclusion is bonded to the body that it lies in"));
  EXPECT_THAT(refusal(body("square", square, "inclusion_of = \"disc\"") +
                      body("disc", disc, "inclusion_of = \"square\"")),
              HasSubstr("the bodies contain one another in a cycle"));
}

}  // namespace
}  // namespace kerf::test
