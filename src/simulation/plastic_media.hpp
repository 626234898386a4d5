// SPDX-License-Identifier: Apache-2.0
// The laws of flow of a case: one set of parameters for each body, in the order of the media.
#pragma once

#include <vector>

#include "case/case.hpp"
#include "materials/plastic_law.hpp"

namespace kerf {

std::vector<PlasticParameters<double>> make_plastic_media(const Case& description);

}  // namespace kerf
