// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/public_symbol.hpp"

namespace kerf {

struct Case;

// Returns the case as a complete case file: every default is written and every number is in SI
// units with as many digits as it needs, so that the file is read back to the same Case, bit for
// bit.
KERF_PUBLIC std::string write_used(const Case& description);

}  // namespace kerf
