// SPDX-License-Identifier: Apache-2.0
// A point of a case, whatever its dimension.
#pragma once

#include <array>

namespace kerf {

using Point = std::array<double, 3>;  // m (or m/s, m/s^2 where a vector is meant)

}  // namespace kerf
