// SPDX-License-Identifier: Apache-2.0
// From the case's bodies and jets to what the loops need of each.
#pragma once

#include <vector>

#include "case/case.hpp"
#include "particles/medium.hpp"
#include "particles/nozzle.hpp"
#include "solid/solid_medium.hpp"

namespace kerf {

// One medium per body, then one per jet.
std::vector<Medium<double>> make_media(const Case& description, const std::vector<Nozzle>& nozzles);

// What the bonds of a solid take of its medium.
SolidMedium<double> solid_medium(const Medium<double>& medium);

}  // namespace kerf
