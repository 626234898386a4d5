// SPDX-License-Identifier: Apache-2.0
// These macros mark functions that run inside particle loops, on the CPU or on a GPU.
#pragma once

#if defined(__CUDACC__)
#define KERF_FUNCTION __host__ __device__ inline
#else
#define KERF_FUNCTION inline
#endif

// Marks the formulas that SIMD kernels share with other code. They are always inlined, so that no
// function that is compiled for one instruction set has the name of another's.
#if defined(__GNUC__) && !defined(__CUDACC__)
#define KERF_FORMULA [[gnu::always_inline]] inline
#else
#define KERF_FORMULA KERF_FUNCTION
#endif

// Stands before a loop body into which the compiler is to inline all that it calls, whatever its
// size.
#if defined(__GNUC__) && !defined(__CUDACC__)
#define KERF_FLATTEN [[gnu::flatten]]
// Stands before a part of such a body that is not inlined: its stack is set up only where it runs.
#define KERF_NOINLINE [[gnu::noinline]]
#else
#define KERF_FLATTEN
#define KERF_NOINLINE
#endif

// States that this point is never reached, as after a switch that returns for every value.
#define KERF_UNREACHABLE() __builtin_unreachable()
