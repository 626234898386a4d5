// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "measure/derived.hpp"

namespace kerf {

// What a run of the case will not resolve or should not be trusted for, one sentence each.
std::vector<std::string> check_warnings(const Case& description, const DerivedNumbers& numbers);

}  // namespace kerf
