// SPDX-License-Identifier: Apache-2.0
// Warnings of cases in which nothing can be cut.
#include "app/check_warnings.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "input/read.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> warnings_of(const std::string& bodies) {
  const Case description = parse_case(R"(
title = "a jet"
dimension = 2
[machine]
pressure = "50 kPa"
orifice_diameter = "2 mm"
standoff = "6 mm"
position = ["0 mm", "6 mm"]
[time]
end = "1 ms"
)" + bodies,
                                      "my.toml");
  return check_warnings(description, derive(description));
}

std::string block_of(const std::string& material) {
  return fmt::format(R"([[body]]
name = "block"
material = "{}"
shape = {{ type = "box", minimum = ["-10 mm", "0 mm"], maximum = ["10 mm", "6 mm"] }}
)",
                     material);
}

TEST(CheckWarnings, WarnOfASolidThatCannotBreak) {
  const auto never = HasSubstr("\"block\" never breaks: its material \"copper\"");
  EXPECT_THAT(warnings_of(block_of("copper")), Contains(never));
  EXPECT_THAT(warnings_of(block_of("copper") + "fixed = true\n"), Not(Contains(never)));
  EXPECT_THAT(warnings_of(block_of("tofu")), Not(Contains(HasSubstr("never breaks"))));
  // The library knows nothing of a material of the case.
  EXPECT_THAT(warnings_of(block_of("copper")), Contains(HasSubstr("(kerf materials copper ")));
  EXPECT_THAT(warnings_of("[materials.gel]\nbase = \"copper\"\n" + block_of("gel")),
              Contains(HasSubstr("(kerf materials NAME lists")));
  EXPECT_THAT(
      warnings_of("[materials.gel]\nbase = \"copper\"\nfailure_strain = 0.3\n" + block_of("gel")),
      Not(Contains(HasSubstr("never breaks"))));
}

TEST(CheckWarnings, WarnOfValuesToBeCalibrated) {
  const auto calibrate = HasSubstr("muscle has values that are known within an interval only: ");
  EXPECT_THAT(warnings_of(block_of("muscle")), Contains(calibrate));
  EXPECT_THAT(warnings_of(block_of("muscle") + "fixed = true\n"), Not(Contains(calibrate)));
  EXPECT_THAT(warnings_of(block_of("pmma")), Not(Contains(HasSubstr("Calibrate"))));
}

TEST(CheckWarnings, WarnOfAJetWithoutAWorkpiece) {
  const auto nothing = HasSubstr("nothing that it can cut");
  EXPECT_THAT(warnings_of(""), Contains(nothing));
  EXPECT_THAT(warnings_of(block_of("tofu")), Not(Contains(nothing)));
}

// The table below stops the jet. The block begins or ends within half the jet's width of its axis,
// or beyond it.
TEST(CheckWarnings, WarnOfAJetThatPassesBesideAllBodies) {
  const auto beside = HasSubstr("passes beside all bodies that it could cut");
  const auto at = [](double left) {
    return fmt::format(R"([[body]]
name = "block"
material = "tofu"
spacing = "0.5 mm"
shape = {{ type = "box", minimum = ["{} mm", "-4 mm"], maximum = ["{} mm", "5 mm"] }}
[[body]]
name = "table"
role = "rigid"
spacing = "0.5 mm"
shape = {{ type = "box", minimum = ["-30 mm", "-8 mm"], maximum = ["30 mm", "-6 mm"] }}
)",
                       left, left + 20.0);
  };
  EXPECT_THAT(warnings_of(at(0.4)), Not(Contains(beside)));
  EXPECT_THAT(warnings_of(at(-20.4)), Not(Contains(beside)));
  EXPECT_THAT(warnings_of(at(1.5)), Contains(beside));
  EXPECT_THAT(warnings_of(at(-21.5)), Contains(beside));
  std::string moving = at(1.5);
  moving.replace(moving.find("[[body]]"), 8, "[[body]]\nvelocity = [\"-1 m/s\", \"0 m/s\"]");
  EXPECT_THAT(warnings_of(moving), Not(Contains(beside)));
}

// Jets of 2 mm, of which the first hits the block and the other may miss it.
TEST(CheckWarnings, WarnOfOneOfTwoJetsThatMisses) {
  const auto jet = [](const char* name, int at, int speed) {
    return fmt::format(
        "[[jet]]\nname = \"{}\"\nspeed = \"{} m/s\"\nwidth = \"2 mm\"\nposition = [\"{} mm\", \"6 "
        "mm\"]\nstandoff = \"4 mm\"\nspacing = \"0.2 mm\"\n",
        name, speed, at);
  };
  const auto of = [&](int at, int speed) {
    const Case description =
        parse_case("title = \"two jets\"\ndimension = 2\n[time]\nend = \"1 ms\"\n" +
                       jet("one", at, 10) + jet("two", 0, speed) + block_of("tofu"),
                   "my.toml");
    return check_warnings(description, derive(description));
  };
  EXPECT_THAT(of(15, 10),
              Contains(HasSubstr("the jet \"one\" passes beside all bodies that it could "
                                 "cut: none is within half its width of its axis, and "
                                 "its water is 0.004 m from the nearest, \"block\"")));
  EXPECT_THAT(of(5, 10), Not(Contains(HasSubstr("passes beside"))));
  const auto extrapolated = HasSubstr("pressures of faster impacts are extrapolated");
  EXPECT_THAT(of(5, 900), Not(Contains(extrapolated)));
  EXPECT_THAT(of(5, 901), Contains(extrapolated));
}

// A rigid table from y = -8 to -6 mm and a plane at y with the normal (0, up). Kernels reach 2.6
// spacings of the widest, 0.5 mm.
TEST(CheckWarnings, WarnOfPlanesThatLeaveOutARigidBody) {
  const auto plane = [](double y, int up) {
    return warnings_of(fmt::format(R"([[body]]
name = "table"
role = "rigid"
spacing = "0.5 mm"
shape = {{ type = "box", minimum = ["-30 mm", "-8 mm"], maximum = ["30 mm", "-6 mm"] }}
[[probe]]
name = "force"
kind = "plane"
position = ["0 mm", "{} mm"]
normal = [0, {}]
)",
                                   y, up));
  };
  const auto left_out = HasSubstr(
      "probe[1].normal (\"force\"): the plane leaves out the forces on "
      "the rigid body \"table\"");
  EXPECT_THAT(plane(-6.0, 1), Contains(left_out));   // in its face
  EXPECT_THAT(plane(-7.0, 1), Contains(left_out));   // inside
  EXPECT_THAT(plane(-7.0, -1), Contains(left_out));  // inside
  EXPECT_THAT(plane(-5.0, 1), Contains(left_out));   // within the reach of its face
  EXPECT_THAT(plane(-4.8, 1), Not(Contains(left_out)));
  EXPECT_THAT(plane(-6.0, -1), Not(Contains(left_out)));  // reads the force on all of it
}

TEST(CheckWarnings, WarnOfAJetThatOpensAfterTheEnd) {
  const auto late = HasSubstr("it emits no water");
  const auto on_its_way = HasSubstr("comes to the point at which it aims after 0.0011 s");
  const auto with_start = [](const char* start) {
    const Case description = parse_case(fmt::format(R"(
title = "a late jet"
dimension = 2
[time]
end = "1 ms"
[[jet]]
name = "jet"
speed = "10 m/s"
width = "2 mm"
position = ["0 mm", "6 mm"]
standoff = "4 mm"
spacing = "0.5 mm"
start = "{}"
)",
                                                    start) +
                                            block_of("tofu"),
                                        "my.toml");
    return check_warnings(description, derive(description));
  };
  for (const auto& warning : {late, on_its_way})
    EXPECT_THAT(with_start("0.5 ms"), Not(Contains(warning)));
  EXPECT_THAT(with_start("0.7 ms"), Contains(on_its_way));
  EXPECT_THAT(with_start("2 ms"), Contains(late));
  EXPECT_THAT(with_start("2 ms"), Not(Contains(HasSubstr("comes to the point"))));
}

// E = 1 kPa: a crack opens by 2 Gc / (E e_0) = 40 or 10 mm in a body of 20 mm.
TEST(CheckWarnings, WarnOfCracksThatOpenWiderThanTheBody) {
  const auto tissue = [](const std::string& energy) {
    return "[materials.tissue]\nkind = \"elastic\"\ndensity = \"1000 kg/m3\"\n"
           "youngs_modulus = \"1 kPa\"\npoisson_ratio = 0.3\ncriterion = \"crack_band\"\n"
           "failure_strain = 0.2\nfracture_energy = \"" +
           energy + " J/m2\"\n" + block_of("tissue");
  };
  const auto wide = HasSubstr("a crack in \"block\" is complete when it has opened by 0.04 m");
  EXPECT_THAT(warnings_of(tissue("4")), Contains(wide));
  EXPECT_THAT(warnings_of(tissue("1")), Not(Contains(HasSubstr("is complete when"))));
}

// A fracture energy alone has a length scale. Its band opens by w d e_f = sqrt(2 Gc w d r / E),
// with w = 2.65, r = 6 and E = 1 kPa: 25 mm for 20 J/m2 and a spacing of 1 mm, 8 mm for 2 J/m2.
TEST(CheckWarnings, WarnOfABrittleBandThatOpensWiderThanTheBody) {
  const auto gel = [](const std::string& energy) {
    return "[materials.gel]\nkind = \"elastic\"\ndensity = \"1000 kg/m3\"\n"
           "youngs_modulus = \"1 kPa\"\npoisson_ratio = 0.3\nfracture_energy = \"" +
           energy + " J/m2\"\n" + block_of("gel") + "spacing = \"1 mm\"\n";
  };
  EXPECT_THAT(warnings_of(gel("20")),
              Contains(HasSubstr("A smaller spacing of the body or a lower fracture_energy")));
  EXPECT_THAT(warnings_of(gel("2")), Not(Contains(HasSubstr("tension alone parts it nowhere"))));
}

TEST(CheckWarnings, WarnOfABrittleSolidWithoutACompressiveStrength) {
  const auto rock = [](const std::string& limits) {
    return "[materials.rock]\nkind = \"elastic\"\ndensity = \"2400 kg/m3\"\ncriterion = "
           "\"crack_band\"\n"
           "youngs_modulus = \"30 GPa\"\npoisson_ratio = 0.2\nfracture_energy = \"80 J/m2\"\n" +
           limits + block_of("rock") + "spacing = \"0.5 mm\"\n";
  };
  const auto compression = HasSubstr("begins to fail in plain compression at 3.354 MPa");
  EXPECT_THAT(warnings_of(rock("failure_strain = 1e-4\n")), Contains(compression));
  EXPECT_THAT(warnings_of(rock("failure_strain = 1e-4\ncompressive_strength = \"30 MPa\"\n")),
              Not(Contains(HasSubstr("plain compression"))));
  EXPECT_THAT(warnings_of(block_of("apple")), Not(Contains(HasSubstr("plain compression"))));
}

TEST(CheckWarnings, WarnOfAThinSoftLayerBetweenStiffBodies) {
  const auto layered = [](double modulus, double spacing) {
    return fmt::format(
        "[materials.glue]\nkind = \"elastic\"\ndensity = \"1000 kg/m3\"\nyoungs_modulus = \"{} "
        "MPa\"\n"
        "poisson_ratio = 0.3\nfailure_strain = 0.5\n{}spacing = \"0.5 mm\"\n[[body]]\nname = "
        "\"layer\"\n"
        "material = \"glue\"\njoined_to = \"block\"\nspacing = \"{} mm\"\nshape = {{ type = "
        "\"box\", minimum = "
        "[\"-10 mm\", \"6 mm\"], maximum = [\"10 mm\", \"8 mm\"] }}\n",
        modulus, block_of("pmma"), spacing);
  };
  const auto thin =
      HasSubstr("\"layer\" has 4 rows of particles across and is joined to \"block\"");
  EXPECT_THAT(warnings_of(layered(30.0, 0.5)), Contains(thin));
  EXPECT_THAT(warnings_of(layered(1000.0, 0.5)),
              Not(Contains(HasSubstr("rows of particles across"))));
  EXPECT_THAT(warnings_of(layered(30.0, 0.125)),
              Not(Contains(HasSubstr("rows of particles across"))));
}

// A nozzle of 5 mm/ms whose jet starts beside the block, which reaches from x = -10 to 10 mm.
TEST(CheckWarnings, TellOfANozzleThatComesOntoABody) {
  const std::string table =
      "[[body]]\nname = \"table\"\nrole = \"rigid\"\nspacing = \"0.5 mm\"\nshape = { type = "
      "\"box\", "
      "minimum = [\"-30 mm\", \"-3 mm\"], maximum = [\"30 mm\", \"0 mm\"] }\n";
  const auto of = [&](double start, double speed) {
    const Case description = parse_case(
        fmt::format("title = \"onto\"\ndimension = 2\n[time]\nend = \"2 ms\"\n[[jet]]\nname = "
                    "\"jet\"\nspeed = \"20 m/s\"\nwidth = \"2 mm\"\nposition = [\"{} mm\", \"6 "
                    "mm\"]\nstandoff = \"4 mm\"\nspacing = \"0.2 mm\"\ntraverse = [\"{} m/s\", "
                    "\"0 m/s\"]\n{}{}",
                    start, speed, block_of("tofu"), table),
        "my.toml");
    return check_warnings(description, derive(description));
  };
  const auto onto = HasSubstr("its axis comes over \"block\" after 1.02 ms");
  EXPECT_THAT(of(-15.0, 5.0), Contains(onto));
  EXPECT_THAT(of(15.0, -5.0), Contains(onto));
  EXPECT_THAT(of(-9.0, 5.0), Not(Contains(onto)));    // over it
  EXPECT_THAT(of(-15.0, -5.0), Not(Contains(onto)));  // away from it
  EXPECT_THAT(of(-15.0, 1.0), Not(Contains(onto)));   // not within the run
}

TEST(CheckWarnings, TellOfADwellWithoutATraverse) {
  const auto of = [&](const std::string& keys) {
    const Case description = parse_case(
        "title = \"dwell\"\ndimension = 2\n[time]\nend = \"2 ms\"\n[[jet]]\nname = \"jet\"\n"
        "speed = \"20 m/s\"\nwidth = \"2 mm\"\nposition = [\"0 mm\", \"6 mm\"]\n"
        "standoff = \"4 mm\"\nspacing = \"0.2 mm\"\n" +
            keys + block_of("tofu"),
        "my.toml");
    return check_warnings(description, derive(description));
  };
  const auto idle = HasSubstr("the dwell of the jet \"jet\", 1 ms, changes nothing");
  EXPECT_THAT(of("dwell = \"1 ms\"\n"), Contains(idle));
  EXPECT_THAT(of("dwell = \"1 ms\"\ntraverse = [\"1 m/s\", \"0 m/s\"]\n"), Not(Contains(idle)));
  EXPECT_THAT(of(""), Not(Contains(idle)));
}

}  // namespace
}  // namespace kerf
