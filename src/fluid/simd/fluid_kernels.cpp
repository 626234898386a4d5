// SPDX-License-Identifier: Apache-2.0
#include "fluid/simd/fluid_kernels.hpp"

#include "fluid/simd/fluid_kernel_loop.hpp"
#include "simd/kernel_table.hpp"

namespace kerf {

KERF_DEFINE_KERNELS(FluidKernels, fluid_kernels, compute_fluid_sums<2, float>,
                    compute_fluid_sums<3, float>, compute_fluid_sums<2, double>,
                    compute_fluid_sums<3, double>)

}  // namespace kerf
