// SPDX-License-Identifier: Apache-2.0
// The only list of what is compiled: dimension and precision, one translation unit each so that
// they build side by side.
#pragma once

#include <memory>

#include "core/precision.hpp"
#include "simulation/simulation.hpp"

namespace kerf {

std::unique_ptr<Simulation> make_2d_mixed(const Case& description);
std::unique_ptr<Simulation> make_2d_double(const Case& description);
std::unique_ptr<Simulation> make_3d_mixed(const Case& description);
std::unique_ptr<Simulation> make_3d_double(const Case& description);

}  // namespace kerf
