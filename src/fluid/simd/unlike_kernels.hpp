// SPDX-License-Identifier: Apache-2.0
// The SIMD kernel over unlike pairs, chosen for this processor.
#pragma once

#include "fluid/simd/packed_unlike.hpp"
#include "simd/instruction_set.hpp"
#include "simd/kernels_by_type.hpp"

namespace kerf {

using UnlikeKernels = KernelsByType<UnlikeKernel>;

const UnlikeKernels& unlike_kernels();

}  // namespace kerf
