// SPDX-License-Identifier: Apache-2.0
// This library for GPUs cannot be used: it has another version, or the machine has no GPU.
#include "engine/gpu/gpu_engine.hpp"

extern "C" [[gnu::visibility("default")]] const kerf::GpuEngine kerf_gpu_engine;
const kerf::GpuEngine kerf_gpu_engine{
    KERF_ENGINE_VERSION, [] { return std::string("there is no NVIDIA GPU"); },
    [] { return std::string("none"); },
    [](const kerf::Case&) -> std::unique_ptr<kerf::Simulation> { return nullptr; }};
