// SPDX-License-Identifier: Apache-2.0
#include "app/version_text.hpp"

#include <fmt/format.h>

#include "build_commit.hpp"
#include "core/error.hpp"
#include "core/version.hpp"
#include "engine/device.hpp"
#include "simd/instruction_set.hpp"

namespace kerf {
namespace {

// The engine for GPUs is a library beside the program, and needs a GPU.
std::string gpu_text() {
  try {
    set_device(Device::gpu);
    const std::string name = device_name();
    set_device(Device::cpu);
    return name;
  } catch (const UserError&) {
    return "none that this build can use";
  }
}

std::string simd_text() {
  try {
    return instruction_set_name();
  } catch (const UserError& error) {
    return error.what();
  }
}

}  // namespace

std::string version_text() {
  return fmt::format("kerf {}\ncommit    {}\ncompiler  {}\nSIMD      {}\nGPU       {}",
                     program_version, build_commit, compiler_name(), simd_text(), gpu_text());
}

}  // namespace kerf
