// SPDX-License-Identifier: Apache-2.0
// The worst of two verifications of the same case in different placements.
#pragma once

#include "verification/verify.hpp"

namespace kerf {

// Returns, for each row of `written`, the worse of it and its counterpart of `elsewhere`: the one
// that fails, then the one that uses more of its tolerance, with the placements of both in which it
// holds. Curves and images are those of
// `written`.
Findings worst_of(Findings written, const Findings& elsewhere);

}  // namespace kerf
