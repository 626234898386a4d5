// SPDX-License-Identifier: Apache-2.0
// The flaws of the bodies of a case: one law for each body, in the order of the media.
#pragma once

#include <vector>

#include "case/case.hpp"
#include "fracture/grady_kipp.hpp"
#include "particles/medium.hpp"

namespace kerf {

std::vector<GradyKipp<double>> make_flaw_media(const Case& description,
                                               const std::vector<Medium<double>>& media);

}  // namespace kerf
