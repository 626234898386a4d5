// SPDX-License-Identifier: Apache-2.0
// Warnings of solids that particles and contact forces cannot represent.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "app/check_warnings.hpp"
#include "app/checked_case.hpp"
#include "core/error.hpp"
#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf::test::check_solids_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> solids_of(const Case& description) {
  return solid_warnings(description, quick_loose_particles(description));
}

// A jet of 2 mm that aims at the origin, of material whose Poisson's ratio is 0: K + 4 G / 3 = E.
Case case_of(const std::string& bodies, double speed = 5.0, double angle = 0.0) {
  return parse_case(fmt::format(R"(
title = "a solid"
dimension = 2
[time]
end = "1 ms"
[materials.soft]
base = "tofu"
youngs_modulus = "100 kPa"
poisson_ratio = 0
[[jet]]
name = "jet"
speed = "{} m/s"
width = "2 mm"
position = ["0 mm", "0 mm"]
standoff = "10 mm"
angle = "{} deg"
spacing = "0.2 mm"
{})",
                                speed, angle, bodies),
                    "my.toml");
}

std::string body_of(const std::string& name, const std::string& shape,
                    const std::string& more = "material = \"soft\"") {
  return fmt::format("[[body]]\nname = \"{}\"\nspacing = \"0.5 mm\"\nshape = {}\n{}\n", name, shape,
                     more);
}

std::string box(double left, double low, double right, double high) {
  return fmt::format(
      "{{ type = \"box\", minimum = [\"{} mm\", \"{} mm\"], maximum = [\"{} mm\", \"{} mm\"] }}",
      left, low, right, high);
}

// Of foils along both axes one layer is refused, two are bonded.
TEST(CheckSolids, RefuseABodyOneParticleThick) {
  for (const double thickness : {0.5, 1.0})
    for (const bool is_upright : {false, true}) {
      const std::string shape =
          is_upright ? box(0.0, -8.0, thickness, 0.0) : box(-8.0, -thickness, 8.0, 0.0);
      const Case description = case_of(body_of("foil", shape));
      if (thickness > 0.5) {
        EXPECT_THAT(solids_of(description), IsEmpty());
        continue;
      }
      try {
        solids_of(description);
        FAIL() << "no refusal";
      } catch (const UserError& error) {
        EXPECT_THAT(error.what(), HasSubstr("body[1].spacing (\"foil\") = 0.0005 m: none of its "));
      }
    }
}

// Boxes of four rows are not laid out: none of their particles is loose, whatever their levels.
TEST(CheckSolids, BoxesThatAreNotLaidOutHaveNoLooseParticles) {
  for (const int levels : {0, 1, 2}) {
    const double edge = 4.0 * 0.5 * (1 << levels);
    const std::string grading =
        levels > 0 ? fmt::format("grading = {{ levels = {}, width = \"6 mm\" }}\n", levels) : "";
    const Case description =
        case_of(body_of("block", box(0.0, -edge, 40.0, 0.0), "material = \"soft\"\n" + grading));
    EXPECT_THAT(quick_loose_particles(description), IsEmpty());
    EXPECT_TRUE(loose_particles(description).empty()) << levels;
  }
}

// A run and a check name the place in the file, as they do of other keys.
TEST(CheckSolids, NameThePlaceOfSuchABody) {
  const std::string text = "title = \"foils\"\ndimension = 2\n[time]\nend = \"1 ms\"\n" +
                           body_of("block", box(-8.0, 0.0, 8.0, 8.0), "material = \"tofu\"") +
                           body_of("foil", box(-8.0, -2.5, 8.0, -2.0), "material = \"tofu\"");
  for (const bool by_check : {false, true}) {
    try {
      if (by_check)
        checked_case(text, "foil.toml");
      else
        refuse_unbonded(parse_case(text, "foil.toml"), text, "foil.toml");
      FAIL() << "no refusal";
    } catch (const UserError& error) {
      EXPECT_THAT(error.what(), HasSubstr("foil.toml:12: body[2].spacing (\"foil\") = 0.0005 m: "));
    }
  }
}

// The tip of a wedge has less than two particles across, whichever way it points.
TEST(CheckSolids, WarnOfTheTipOfAWedge) {
  const auto wedge = [](double tip) {
    return fmt::format(
        "{{ type = \"polygon\", vertices = [[\"-1.5 mm\", \"{0} mm\"], [\"1.5 mm\", "
        "\"{0} mm\"], [\"0 mm\", \"{1} mm\"]] }}",
        tip < -3.0 ? 0.0 : -6.0, tip);
  };
  for (const double tip : {0.0, -6.0})
    EXPECT_THAT(solids_of(case_of(body_of("wedge", wedge(tip)))),
                Contains(HasSubstr("particles of \"wedge\" have too few neighbours")));
  EXPECT_THAT(solids_of(case_of(body_of("block", box(-2.0, -4.0, 2.0, 0.0)))), IsEmpty());
}

// The stagnation pressure of water is 98 kPa at 14 m/s and 113 kPa at 15 m/s, M is 100 kPa.
TEST(CheckSolids, WarnOfASolidThatMayBePressedThroughAnother) {
  const auto pressed = HasSubstr("may press it through \"wall\"");
  const std::string block = body_of("block", box(-2.0, -4.0, 2.0, 0.0));
  const std::string below = block + body_of("wall", box(-6.0, -6.0, 6.0, -4.0), "role = \"rigid\"");
  EXPECT_THAT(solids_of(case_of(below, 15.0)), Contains(pressed));
  EXPECT_THAT(solids_of(case_of(below, 14.0)), Not(Contains(pressed)));
  EXPECT_THAT(solids_of(case_of(block, 15.0)), Not(Contains(pressed)));
  const std::string beside = body_of("block", box(0.0, -2.0, 4.0, 2.0)) +
                             body_of("wall", box(4.0, -6.0, 6.0, 6.0), "role = \"rigid\"");
  EXPECT_THAT(solids_of(case_of(beside, 15.0, 90.0)), Contains(pressed));
  const std::string missed = body_of("block", box(6.0, -4.0, 9.0, 0.0)) +
                             body_of("wall", box(-6.0, -6.0, 9.0, -4.0), "role = \"rigid\"");
  EXPECT_THAT(solids_of(case_of(missed, 15.0)), Not(Contains(pressed)));
}

// A neo-Hookean solid that is compressed to a fifth of its volume, in one direction.
TEST(CheckSolids, WarnOfASolidThatThePressureOfAJetFails) {
  const auto crushed = HasSubstr("below a fifth of its volume");
  const std::string block = body_of("block", box(-2.0, -4.0, 2.0, 0.0));
  const Case slow = case_of(block, 15.0);
  const Material& material = slow.materials[static_cast<std::size_t>(slow.bodies[0].material)];
  const double shear = material.youngs_modulus / (2.0 * (1.0 + material.poisson_ratio));
  const double bulk = material.youngs_modulus / (3.0 * (1.0 - 2.0 * material.poisson_ratio));
  const double volume = 0.2;  // J = lambda, tr C = lambda^2 + 2
  const double stress = shear * std::pow(volume, -5.0 / 3.0) * 2.0 / 3.0 * (1.0 - volume * volume) +
                        0.5 * bulk * (1.0 / volume - volume);
  const double limit = std::sqrt(2.0 * stress / 1000.0);  // m/s
  EXPECT_THAT(solids_of(case_of(block, 0.98 * limit)), Not(Contains(crushed)));
  EXPECT_THAT(solids_of(case_of(block, 1.02 * limit)), Contains(crushed));
}

}  // namespace
}  // namespace kerf::test::check_solids_test
