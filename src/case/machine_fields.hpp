// SPDX-License-Identifier: Apache-2.0
// The numbers of [machine] and the keys they have in a case file.
#pragma once

#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "case/machine.hpp"

namespace kerf {

inline constexpr std::array<std::string_view, 4> orifice_words{"sharp", "conical", "slit", "fan"};

struct MachineField {
  std::string_view key;
  double Machine::*member;
};

// What decides which keys a machine has, as the schema names it.
std::set<std::string> machine_conditions(OrificeType type, int dimension);
// The numbers it has, in the order of the schema.
std::vector<MachineField> machine_fields(const Machine& machine, int dimension);

}  // namespace kerf
