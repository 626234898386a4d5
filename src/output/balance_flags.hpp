// SPDX-License-Identifier: Apache-2.0
// The validity flags of the balance of energy: what it misses, what smoothing of the density takes,
// and what breaks add.
#pragma once

#include <vector>

#include "model/case.hpp"
#include "output/validity.hpp"
#include "simulation/balance.hpp"

namespace kerf {

// Adds the flags of the balance of a case: always that of its drift, the others where they have
// something to tell.
void add_balance_flags(const Balance& balance, const Case& description,
                       std::vector<ValidityFlag>& flags);

}  // namespace kerf
