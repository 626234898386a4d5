// SPDX-License-Identifier: Apache-2.0
// The GPU that loops run on: cuda_gpu.cpp, or emulated_gpu.cpp for machines without one.
#pragma once

#include <string>

namespace kerf {

std::string problem_of_gpu();  // why it cannot be used, as a clause; empty = it can
std::string name_of_gpu();

}  // namespace kerf
