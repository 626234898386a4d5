// SPDX-License-Identifier: Apache-2.0
// The SIMD kernel over pairs of particles of one fluid, chosen for this processor.
#pragma once

#include "fluid/simd/packed_fluid.hpp"
#include "simd/instruction_set.hpp"
#include "simd/kernels_by_type.hpp"

namespace kerf {

using FluidKernels = KernelsByType<FluidKernel>;

const FluidKernels& fluid_kernels();

}  // namespace kerf
