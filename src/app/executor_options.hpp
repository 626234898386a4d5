// SPDX-License-Identifier: Apache-2.0
// This header declares the options of commands that make many runs: where and how many at once.
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>

#include "engine/device.hpp"
#include "study/executor.hpp"

namespace kerf {

// The path of the program for the runs. A child process gets the running program, even if its file
// was replaced.
inline constexpr const char* this_program = "/proc/self/exe";

struct ExecutorOptions {
  int jobs = 0;         // 0 = by the cores
  int cores = 0;        // 0 = all
  int ranks = 1;        // of each run; more than one with Slurm only
  double memory = 0.0;  // GiB; 0 = four fifths of the free memory
  std::string where = "local";
  Device device = Device::cpu;
  bool retry = false;
  bool quiet = false;
};

// Adds --ranks, of runs on Slurm.
void add_ranks_option(CLI::App& command, int& ranks);
// Throws UserError where runs cannot have so many ranks; `where`: the value of --on.
void check_ranks(int ranks, const std::string& where);
// Throws UserError where this program knows one rank only; `asked` names the option and its value.
void refuse_without_ranks(const std::string& asked);

// Adds --jobs, --cores, --memory, --on, --device, --retry and --quiet. `options` must live as long
// as the command.
void add_executor_options(CLI::App& command, ExecutorOptions& options);

// Returns the executor of the options; `folder` is that of the runs. Throws UserError when the
// device is not available.
std::unique_ptr<Executor> make_executor(const ExecutorOptions& options,
                                        const std::filesystem::path& folder);

}  // namespace kerf
