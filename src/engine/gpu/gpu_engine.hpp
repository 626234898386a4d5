// SPDX-License-Identifier: Apache-2.0
// The interface of libkerf_gpu.so. The library is the engine compiled with its particle loops for a
// GPU. It shares no code with the program at run time: only what is declared here, Case and
// Simulation pass between the two.
#pragma once

#include <memory>
#include <string>

#include "core/version.hpp"
#include "simulation/simulation.hpp"

namespace kerf {

struct GpuEngine {
  const char* version;       // gpu_engine_version
  std::string (*problem)();  // why no GPU can be used, as a clause; empty = one can
  std::string (*name)();     // of the GPU
  std::unique_ptr<Simulation> (*make)(const Case& description);
};

// The name of the variable of that type in the library.
inline constexpr const char* gpu_engine_symbol = "kerf_gpu_engine";

// The program and the library are of one build, so that they can exchange C++ objects.
inline constexpr const char* gpu_engine_version = program_version;

}  // namespace kerf
