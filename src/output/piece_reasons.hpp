// SPDX-License-Identifier: Apache-2.0
// What Kerf chose to simulate of a workpiece, for `kerf check` and the report.
#pragma once

#include <string>
#include <vector>

namespace kerf {

struct Case;

// Returns what is simulated, and why, a sentence each; empty for a case without [workpiece].
std::vector<std::string> piece_reasons(const Case& description);

}  // namespace kerf
