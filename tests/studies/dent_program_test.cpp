// SPDX-License-Identifier: Apache-2.0
// What a whole run says of a jet that breaks nothing: the dent that it presses into the solid, and
// not where its water has come.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "faults/program.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using testing::HasSubstr;

// A plate of 20 mm, on a table where it is backed, under a jet of 2 m/s.
struct DentCase {
  std::string motion;  // further lines of the plate
  bool is_backed = true;
  int angle = 0;  // deg, of the jet
  int time = 30;  // ms
};

std::string case_of(const DentCase& setting) {
  std::string text = R"(title = "dent"
dimension = 2
[time]
end = ")" + std::to_string(setting.time) +
                     R"( ms"
[domain]
minimum = ["-150 mm", "-150 mm"]
maximum = ["150 mm", "150 mm"]
[materials.rubber]
kind = "elastic"
density = "1000 kg/m3"
youngs_modulus = "200 kPa"
poisson_ratio = 0.3
failure_strain = 0.5
fracture_energy = "1 kJ/m2"
criterion = "crack_band"
[[body]]
name = "plate"
material = "rubber"
shape = { type = "polygon", vertices = [["-80 mm", "-20 mm"], ["80 mm", "-20 mm"], ["80 mm", "0 mm"], ["-80 mm", "0 mm"]] }
spacing = "4 mm"
)" + setting.motion + R"(
[[jet]]
name = "jet"
speed = "2 m/s"
width = "16 mm"
position = ["0 mm", "0 mm"]
standoff = "20 mm"
spacing = "4 mm"
angle = ")" + std::to_string(setting.angle) +
                     " deg\"\n";
  if (setting.is_backed)
    text += R"([[body]]
name = "table"
role = "rigid"
shape = { type = "polygon", vertices = [["-90 mm", "-28 mm"], ["90 mm", "-28 mm"], ["90 mm", "-20 mm"], ["-90 mm", "-20 mm"]] }
spacing = "4 mm"
)";
  return text;
}

class DentProgram : public testing::Test {
 protected:
  nlohmann::json run(const DentCase& setting) const {
    write_file(folder_ / "my.toml", case_of(setting));
    const test::Ending ending = test::Program({"run", (folder_ / "my.toml").string(), "--out",
                                               (folder_ / "out").string(), "--force"},
                                              folder_ / "output.txt")
                                    .wait();
    EXPECT_EQ(ending.exit_code, 0) << ending.output;
    return nlohmann::json::parse(read_file(folder_ / "out/result.json"));
  }
  static std::string verdict(const nlohmann::json& result) { return result.at("verdict"); }
  static double kerf(const nlohmann::json& result, const char* name) {
    return result.at("kerf").at(name).get<double>();
  }

  test::TemporaryFolder folder_;
};

// The pressure of 2 kPa makes a plate of 200 kPa at most 2 kPa / 200 kPa * 20 mm = 0.2 mm thinner,
// or twice that as the load begins; the plate swings about half of it, with a period of some ms.
TEST_F(DentProgram, OnATableIsThatOfThePressure) {
  for (const int angle : {0, 60, -60}) {
    SCOPED_TRACE(angle);
    double mean = 0.0;
    constexpr int times[] = {20, 22, 24, 26, 28, 30};
    for (const int time : times) {
      const auto result = run({.motion = "", .angle = angle, .time = time});
      EXPECT_LT(kerf(result, "dent"), 0.4e-3);
      EXPECT_THAT(verdict(result), HasSubstr("breaks nothing within " + std::to_string(time)));
      mean += kerf(result, "dent") / std::size(times);
    }
    EXPECT_LT(mean, 0.2e-3);
    EXPECT_GT(mean, angle == 0 ? 0.05e-3 : -1e-12);
  }
}

TEST_F(DentProgram, OfAFreePlateIsNotItsMotion) {
  const auto result = run({.motion = "", .is_backed = false});
  EXPECT_LT(kerf(result, "dent"), 0.4e-3);
  EXPECT_GT(kerf(result, "motion"), 1e-3);
  EXPECT_THAT(verdict(result), HasSubstr("the workpiece has bent or moved by "));
}

TEST_F(DentProgram, WaterThatComesTooLateTouchesNothing) {
  const auto result =
      run({.motion = "velocity = [\"0 m/s\", \"-3 m/s\"]", .is_backed = false, .time = 15});
  EXPECT_NEAR(kerf(result, "dent"), 0.0, 1e-6);
  EXPECT_EQ(verdict(result),
            "The water has not touched the workpiece within 15 ms; the workpiece has bent or moved "
            "by 45 mm.");
}

}  // namespace
}  // namespace kerf
