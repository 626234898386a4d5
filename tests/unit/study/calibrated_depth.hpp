// SPDX-License-Identifier: Apache-2.0
// The goal of a calibration of the fracture energy by one depth of cut, and a depth in closed form.
#pragma once

#include <cmath>
#include <string>

#include "study/searches.hpp"
#include "synthetic.hpp"

namespace kerf::test {

inline const std::string energy = "materials.curd.fracture_energy";

inline CalibrationGoal calibration_of(const std::string& more) {
  return *plan_of("[calibrate]\nkey = \"" + energy + "\"\nfrom = \"1 J/m2\"\nto = \"100 J/m2\"\n" +
                  more)
              .calibration;
}

inline double energy_of(const Trial& trial) {
  return trial.setting.numbers.at(energy);
}
// A depth that decreases with the fracture energy and increases with the speed.
inline double depth(double fracture_energy, double speed) {
  return 0.01 * std::pow(fracture_energy / 10.0, -0.4) * (speed / 5.0) / (1.0 + 0.1 * speed);
}

inline constexpr const char* one_cut =
    "metric = \"kerf.depth\"\nmeasured = \"MEASURED m\"\nuncertainty = \"UNCERTAINTY m\"\n"
    "[calibrate.at]\n\"jet.jet.speed\" = \"5 m/s\"\n"
    "[[calibrate.predict]]\n\"jet.jet.speed\" = \"8 m/s\"\n";

inline CalibrationGoal cut_goal(double measured, double uncertainty) {
  std::string text = one_cut;
  text.replace(text.find("MEASURED"), 8, std::to_string(measured));
  text.replace(text.find("UNCERTAINTY"), 11, std::to_string(uncertainty));
  return calibration_of(text);
}

}  // namespace kerf::test
