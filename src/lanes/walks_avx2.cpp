// SPDX-License-Identifier: Apache-2.0
// The walks for x86-64-v3: AVX2 and fused multiplication.
#define KERF_LANES avx2
#include "lanes/walks_of_one_set.hpp"
