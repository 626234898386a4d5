// SPDX-License-Identifier: Apache-2.0
// The device of the runs of this process: the threads of this machine, or a GPU. The engine for
// GPUs is libkerf_gpu.so, which a build for GPUs puts beside the program (src/engine/gpu/).
#pragma once

#include <memory>
#include <string>

#include "core/public_symbol.hpp"
#include "simulation/simulation.hpp"

namespace kerf {

enum class Device { cpu, gpu };

inline constexpr const char* word_of(Device device) {
  return device == Device::cpu ? "cpu" : "gpu";
}

// Sets the device of all later runs. Throws UserError (exit_bad_input) if there is no engine for
// GPUs or no GPU that it can use; the device is then unchanged.
KERF_PUBLIC void set_device(Device device);

// Returns the name of the device for reports, such as "AMD EPYC 9R14" or "NVIDIA H100 80GB HBM3".
KERF_PUBLIC std::string device_name();

// Makes the run that a case describes, on the device of this process. Throws UserError when the
// case cannot be built.
KERF_PUBLIC std::unique_ptr<Simulation> make_simulation(const Case& description);

}  // namespace kerf
