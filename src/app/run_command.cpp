// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/cost_advice.hpp"
#include "app/run_loop.hpp"
#include "core/error.hpp"
#include "input/read.hpp"
#include "input/write_used.hpp"
#include "output/readable.hpp"
#include "study/local_executor.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;

struct RunOptions {
  std::string case_file;
  std::string folder;
  MachineOptions machine;
  bool resume = false;
  bool force = false;
  bool quiet = false;
  bool ignore_memory = false;
};

// Returns a path quoted for a shell.
std::string shell_word(const std::string& path) {
  if (path.find_first_of(" \t'\"\\$&;()*?<>|`!#~") == std::string::npos) return path;
  std::string word = "'";
  for (const char c : path) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string resume_command(const RunOptions& options, const fs::path& folder) {
  std::string command = fmt::format("kerf run {} --out {}", shell_word(options.case_file),
                                    shell_word(folder.string()));
  const MachineOptions& machine = options.machine;
  if (machine.threads > 0) command += fmt::format(" --threads {}", machine.threads);
  if (machine.device != Device::cpu)
    command += fmt::format(" --device {}", word_of(machine.device));
  return command + " --resume";
}

// Refuses a case that does not fit into the memory of this machine; nothing is laid out for that.
void refuse_beyond_memory(const RunOptions& options, const Case& description) {
  const DerivedNumbers numbers = derive(description);
  const double memory = available_memory();
  if (options.ignore_memory || options.machine.device != Device::cpu || numbers.memory <= memory)
    return;
  const Pace pace = typical_pace(description, threads_of(options.machine));
  throw UserError(fmt::format(
      "{}: the run needs about {} for {} particles. Allowed: at most {}, the memory of this "
      "machine "
      "that is free. Change the case, or run it with --ignore-memory.\n{}",
      options.case_file, readable(numbers.memory, "B"), numbers.particles_expected,
      readable(memory, "B"),
      advice_text({case_text(options.case_file), options.case_file, description, numbers, pace},
                  memory)));
}

RunLoopSettings settings_of(const RunOptions& options) {
  RunLoopSettings settings;
  settings.description = read_case(options.case_file);
  refuse_beyond_memory(options, settings.description);
  settings.case_name = fs::path(options.case_file).stem().string();
  settings.case_text = write_used(settings.description);
  settings.folder =
      options.folder.empty() ? fs::path("out") / settings.case_name : fs::path(options.folder);
  settings.existing = options.resume  ? Existing::resume
                      : options.force ? Existing::replace
                                      : Existing::refuse;
  settings.quiet = options.quiet;
  settings.threads = threads_of(options.machine);
  settings.device = device_name();
  settings.resume_command = resume_command(options, settings.folder);
  return settings;
}

void print_output_paths(const RunLoopSettings& settings) {
  const auto result = nlohmann::json::parse(read_file(settings.folder / "result.json"));
  fmt::print("{}\n", result.at("verdict").get<std::string>());
  if (settings.quiet) return;
  const std::string folder = settings.folder.string();
  fmt::print("  report     {}/report.html\n", folder);
  fmt::print("  particles  {}/{}.vtkhdf.series (ParaView)\n", folder,
             result.at("case").get<std::string>());
  fmt::print("  numbers    {0}/result.json, {0}/series.csv\n", folder);
}

void run(const RunOptions& options) {
  take_machine(options.machine);
  const RunLoopSettings settings = settings_of(options);
  const RunEnd end = RunLoop(settings, make_simulation).run();
  // The exit code is 128 plus the number of the signal, as in a shell.
  if (end.signal != 0) throw CLI::RuntimeError(128 + end.signal);
  print_output_paths(settings);
}

}  // namespace

void add_run_command(CLI::App& program) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = program.add_subcommand("run", "Run a case and report on it");
  command->add_option("CASE", options->case_file, "the case file")->required();
  command->add_option("--out", options->folder, "folder for the results; default out/<case>");
  add_machine_options(*command, options->machine);
  CLI::Option* resume =
      command->add_flag("--resume", options->resume, "continue from the last checkpoint");
  command->add_flag("--force", options->force, "replace the run in the folder")->excludes(resume);
  command->add_flag("--quiet", options->quiet, "show the result only");
  command->add_flag("--ignore-memory", options->ignore_memory,
                    "run a case whose estimated memory is more than this machine has free");
  command->callback([options] { run(*options); });
}

}  // namespace kerf
