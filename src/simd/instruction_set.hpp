// SPDX-License-Identifier: Apache-2.0
// SIMD kernels are compiled once for each instruction set. Which instruction set runs is chosen
// once, when a kernel is first requested.
#pragma once

#include "parallel/loops.hpp"

namespace kerf {

// SIMD kernels run on processors only. On a GPU packed loops take their place (docs/gpu.md).
inline constexpr bool simd_exists = !on_gpu;

enum class InstructionSet { baseline, avx2, avx512 };

// The fastest instruction set that this program and this processor both have, or the one that the
// environment's KERF_SIMD names (baseline, avx2 or avx512). Throws UserError (exit_bad_input) when
// that one cannot run here.
InstructionSet instruction_set();

// Its name, as KERF_SIMD spells it.
const char* instruction_set_name();

}  // namespace kerf
