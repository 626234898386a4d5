// SPDX-License-Identifier: Apache-2.0
// This header declares functions for the command lines of several commands: the options of commands
// that compute, and the refusal of an unknown name.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "engine/device.hpp"

namespace kerf {

struct MachineOptions {
  int threads = 0;  // 0 = every core
  Device device = Device::cpu;
};

// Adds --threads and --device. `options` must live as long as the command.
void add_machine_options(CLI::App& command, MachineOptions& options);
// Adds --device alone.
void add_device_option(CLI::App& command, Device& device);

// Sets threads and device for all runs of this process. Throws UserError when the device is not
// available.
void take_machine(const MachineOptions& options);

// Returns the number of threads.
int threads_of(const MachineOptions& options);

// Adds --out, which names a folder; an empty name, as of a variable that is not set, is refused.
CLI::Option* add_out_option(CLI::App& command, std::string& folder, const std::string& meaning);

// Throws the UserError "SENTENCE. Did you mean "..."? Allowed: ..."; the question is part of it if
// a known name is similar or contains it.
[[noreturn]] void refuse_name(const std::string& sentence, const std::string& name,
                              const std::vector<std::string>& known,
                              const std::string& separator = ", ");

}  // namespace kerf
