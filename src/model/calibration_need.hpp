// SPDX-License-Identifier: Apache-2.0
// Materials whose values are known within an interval only are to be calibrated by a test cut.
#pragma once

#include <string>

namespace kerf {

struct Case;

// Returns a sentence for each material of a body that can be cut and that has uncalibrated values,
// joined by spaces; empty if there is none.
std::string calibration_need(const Case& description);

}  // namespace kerf
