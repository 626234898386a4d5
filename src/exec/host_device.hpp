// SPDX-License-Identifier: Apache-2.0
// Marks functions that run inside particle loops, on the CPU or on a GPU.
#pragma once

#if defined(__CUDACC__)
#define KERF_FUNCTION __host__ __device__ inline
#else
#define KERF_FUNCTION inline
#endif

// Before a loop body that is to be one piece of code, with all that it calls: whether a compiler
// would do so by itself hangs on its size.
#if defined(__GNUC__) && !defined(__CUDACC__)
#define KERF_FLAT [[gnu::flatten]]
// Before a part of one that is to stay apart: what it keeps on the stack is not set up where it is
// not needed.
#define KERF_APART [[gnu::noinline]]
#else
#define KERF_FLAT
#define KERF_APART
#endif
