// SPDX-License-Identifier: Apache-2.0
// The walks for x86-64-v4: AVX-512.
#define KERF_LANES avx512
#include "lanes/walks_of_one_set.hpp"
