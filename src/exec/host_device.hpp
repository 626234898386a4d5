// SPDX-License-Identifier: Apache-2.0
// Marks functions that run inside particle loops, on the CPU or on a GPU.
#pragma once

#if defined(__CUDACC__)
#define KERF_FUNCTION __host__ __device__ inline
#else
#define KERF_FUNCTION inline
#endif
