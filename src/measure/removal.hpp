// SPDX-License-Identifier: Apache-2.0
// How much material a jet has taken away, and what it cost.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "measure/workpiece.hpp"

namespace kerf {

struct Removal {
  double volume = 0.0;  // m^3 (2D: m^2), of the solid as laid out
  double rate = 0.0;    // m^3/s (2D: m^2/s), mean since contact; 0 before
  // J/m^3 (1e9 J/m^3 = 1 J/mm^3), energy of the jet since contact over the volume; nan without any.
  double specific_energy = std::numeric_limits<double>::quiet_NaN();
};

// Of the jet since it met the workpiece.
struct JetWork {
  double duration = 0.0;  // s
  double energy = 0.0;    // J (2D: J/m), kinetic
};

// `body` -1 = the whole workpiece. `standing` is that of find_standing().
double removed_volume(const Workpiece& workpiece, const std::vector<std::uint8_t>& standing,
                      int body = -1);
Removal measure_removal(double volume, const JetWork& work);

}  // namespace kerf
