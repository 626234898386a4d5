// SPDX-License-Identifier: Apache-2.0
#include "engine/gpu/gpu_engine.hpp"

#include "engine/gpu/this_gpu.hpp"
#include "engine/instantiate.hpp"

extern "C" [[gnu::visibility("default")]] const kerf::GpuEngine kerf_gpu_engine;
const kerf::GpuEngine kerf_gpu_engine{kerf::gpu_engine_version, kerf::problem_of_gpu,
                                      kerf::name_of_gpu, kerf::make_here};
