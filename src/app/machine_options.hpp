// SPDX-License-Identifier: Apache-2.0
// The options of commands that compute: on what, and on how much of it.
#pragma once

#include <CLI/CLI.hpp>

#include "exec/device.hpp"

namespace kerf {

struct MachineOptions {
  int threads = 0;  // 0 = every core
  Device device = Device::cpu;
};

// --threads and --device. `options` must live as long as the command.
void add_machine_options(CLI::App& command, MachineOptions& options);
// --device alone.
void add_device_option(CLI::App& command, Device& device);

// For all runs of this process. Throws UserError when the device cannot be had.
void take_machine(const MachineOptions& options);

// How many threads that is.
int threads_of(const MachineOptions& options);

}  // namespace kerf
