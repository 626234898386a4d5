// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace kerf {

// The factor of the acoustic limit (`courant`) from which on the step of a joint is its longest
// stable one; it is shorter in proportion for smaller factors.
inline constexpr double joint_courant = 0.27;

}  // namespace kerf
