// SPDX-License-Identifier: Apache-2.0
#include "fluid/simd/unlike_kernels.hpp"

#include "fluid/simd/unlike_pair_kernel.hpp"
#include "simd/kernel_table.hpp"

namespace kerf {

KERF_DEFINE_KERNELS(UnlikeKernels, unlike_kernels, add_unlike_sums<2, float>,
                    add_unlike_sums<3, float>, add_unlike_sums<2, double>,
                    add_unlike_sums<3, double>)

}  // namespace kerf
