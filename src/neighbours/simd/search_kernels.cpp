// SPDX-License-Identifier: Apache-2.0
#include "neighbours/simd/search_kernels.hpp"

#include "neighbours/simd/search.hpp"
#include "simd/kernel_table.hpp"

namespace kerf {

KERF_DEFINE_KERNELS(SearchKernels, search_kernels, search<2>, search<3>)

}  // namespace kerf
