// SPDX-License-Identifier: Apache-2.0
// The terms of the ledger, each named once: what series.csv, result.json and the report list.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "simulation/ledger.hpp"

namespace kerf {

struct LedgerTerm {
  const char* name;
  const char* unit;  // in 3D; per metre of depth in 2D
  const char* meaning;
  // Exactly one of them is set.
  double Ledger::*scalar = nullptr;
  std::array<double, 3> Ledger::*vector = nullptr;
};

const std::vector<LedgerTerm>& ledger_terms();

// The unit of an extensive quantity, "J" or, in 2D, "J/m".
std::string extensive_unit(const std::string& unit, int dimension);

}  // namespace kerf
