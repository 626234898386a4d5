// SPDX-License-Identifier: Apache-2.0
#include "app/executor_options.hpp"

#include <fmt/format.h>

#include "app/command_line.hpp"
#include "core/error.hpp"
#include "parallel/ranks.hpp"
#include "study/local_executor.hpp"
#include "study/slurm_executor.hpp"

namespace kerf {

namespace {

LocalBudget budget_of(const ExecutorOptions& options) {
  constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;
  LocalBudget budget = budget_of_machine();
  if (options.cores > 0) budget.cores = options.cores;
  budget.device = word_of(options.device);
  const int at_once = options.device == Device::gpu ? 1 : budget.cores;
  budget.jobs = options.jobs > 0 ? options.jobs : at_once;
  if (options.memory > 0.0) budget.memory = options.memory * gibibyte;
  return budget;
}

}  // namespace

void add_ranks_option(CLI::App& command, int& ranks) {
  constexpr int most = 4096;
  command
      .add_option("--ranks", ranks,
                  "processes that share each run, with --on slurm and the preset mpi")
      ->check(CLI::Range(1, most))
      ->capture_default_str();
}

void check_ranks(int number, const std::string& where) {
  if (number == 1) return;
  if (where != "slurm")
    throw UserError(fmt::format("--ranks {0}: only Slurm starts several ranks of a run (--on "
                                "slurm). Here start them with: mpirun -n {0} kerf run my.toml",
                                number),
                    exit_bad_input);
  refuse_without_ranks(fmt::format("--ranks {}", number));
}

void refuse_without_ranks(const std::string& asked) {
  if (ranks::exist) return;
  throw UserError(
      fmt::format("{}: this program was built without MPI and the library that divides a case. "
                  "Allowed: the same without the option, or a program of the preset mpi. Build "
                  "that: scripts/setup mpi; cmake --preset mpi && cmake --build --preset mpi; then "
                  "start build/mpi/kerf (docs/mpi.md).",
                  asked),
      exit_bad_input);
}

std::unique_ptr<Executor> make_executor(const ExecutorOptions& options,
                                        const std::filesystem::path& folder) {
  check_ranks(options.ranks, options.where);
  if (options.where == "local") {
    set_device(options.device);  // throws when it is not available
    return std::make_unique<LocalExecutor>(this_program, budget_of(options));
  }
  SlurmBudget budget;
  budget.device = word_of(options.device);
  budget.ranks = options.ranks;
  if (options.jobs > 0) budget.jobs = options.jobs;
  if (options.cores > 0) budget.cores = options.cores;
  return std::make_unique<SlurmExecutor>(std::filesystem::read_symlink(this_program), folder,
                                         budget);
}

void add_executor_options(CLI::App& command, ExecutorOptions& options) {
  constexpr int most = 4096;
  command
      .add_option("--jobs", options.jobs,
                  "maximum number of concurrent runs; default: one per core, one on a GPU")
      ->check(CLI::Range(1, most));
  command
      .add_option("--cores", options.cores,
                  "cores of all concurrent runs; default: all; with Slurm the cores of each rank "
                  "of a run, default 1")
      ->check(CLI::Range(1, most));
  command
      .add_option("--memory", options.memory,
                  "memory of all concurrent runs, in GiB; default: four fifths of the free memory")
      ->check(CLI::PositiveNumber);
  command.add_option("--on", options.where, "where runs are computed: this machine, or Slurm")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  add_ranks_option(command, options.ranks);
  add_device_option(command, options.device);
  command.add_flag("--retry", options.retry, "repeat failed runs");
  command.add_flag("--quiet", options.quiet, "show the results only");
}

}  // namespace kerf
