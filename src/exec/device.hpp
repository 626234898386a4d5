// SPDX-License-Identifier: Apache-2.0
// Where the runs of this process compute: on threads of this machine, or on a GPU, by the engine
// that a build for GPUs puts beside the program as libkerf_gpu.so (src/gpu/).
#pragma once

#include <string>

namespace kerf {

enum class Device { cpu, gpu };

inline constexpr const char* word_of(Device device) {
  return device == Device::cpu ? "cpu" : "gpu";
}

// For all runs that are made from now on. Throws UserError (exit_bad_input) when there is no engine
// for a GPU or no GPU that it can use; the device then stays what it was.
void set_device(Device device);
Device device_in_use();

// As in "AMD EPYC 9R14" or "NVIDIA H100 80GB HBM3", for those who tell where a run was computed.
std::string device_name();

}  // namespace kerf
