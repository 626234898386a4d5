// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "analysis/derived.hpp"
#include "app/check_warnings.hpp"
#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/converge.hpp"
#include "app/cost_advice.hpp"
#include "app/executor_options.hpp"
#include "app/later_end.hpp"
#include "app/run_json.hpp"
#include "app/run_loop.hpp"
#include "app/slurm_run.hpp"
#include "core/error.hpp"
#include "engine/lead.hpp"
#include "input/read.hpp"
#include "output/readable.hpp"
#include "parallel/ranks.hpp"
#include "report/report_parts.hpp"

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
  bool json_summary = false;
  LogFormat log_format = LogFormat::text;
  bool converge = false;
  int layouts = 3;
  bool ignore_memory = false;
  std::string where = "local";
  int ranks = 1;
};

// Returns a word quoted for a shell, where it must be.
std::string shell_word(const std::string& word) {
  const bool is_plain = word.find_first_of(" \t'\"\\$&;()*?<>|`!#~") == std::string::npos;
  return is_plain ? word : quoted_for_shell(word);
}

// Returns the arguments of the program for a run, without --resume and --force.
std::vector<std::string> arguments_of(const RunOptions& options, const fs::path& folder) {
  std::vector<std::string> words{"run", options.case_file, "--out", folder.string()};
  const MachineOptions& machine = options.machine;
  if (machine.threads > 0)
    words.insert(words.end(), {"--threads", std::to_string(machine.threads)});
  if (machine.device != Device::cpu)
    words.insert(words.end(), {"--device", std::string(word_of(machine.device))});
  if (options.log_format == LogFormat::json) words.insert(words.end(), {"--log", "json"});
  if (options.converge)
    words.insert(words.end(), {"--converge", "--layouts", std::to_string(options.layouts)});
  return words;
}

std::string resume_command(const RunOptions& options, const fs::path& folder) {
  std::string command = "kerf";
  for (const std::string& word : arguments_of(options, folder)) command += " " + shell_word(word);
  if (options.where == "slurm") command += " --on slurm";
  if (options.ranks > 1) command += fmt::format(" --ranks {}", options.ranks);
  return command + " --resume";
}

RunLoopSettings settings_of(const RunOptions& options) {
  const std::string text = case_text(options.case_file);
  Case description = parse_case(text, options.case_file);
  refuse_unbonded(description, text, options.case_file);
  if (!options.ignore_memory && options.machine.device == Device::cpu)
    refuse_beyond_memory({text, options.case_file, description, derive(description), {}},
                         threads_of(options.machine), "--ignore-memory");
  RunLoopSettings settings =
      settings_of_case(std::move(description), options.case_file, options.folder);
  settings.existing = existing_of(options.resume, options.force);
  settings.quiet = options.quiet || options.json_summary;
  settings.log_format = options.log_format;
  settings.threads = threads_of(options.machine);
  settings.device = device_name();
  settings.resume_command = resume_command(options, settings.folder);
  return settings;
}

void print_output_paths(const RunLoopSettings& settings, const nlohmann::ordered_json& result,
                        bool will_converge) {
  fmt::print("{}\n", result.at("verdict").get<std::string>());
  if (settings.quiet) return;
  const std::string folder = settings.folder.string();
  fmt::print("  report     {}/report.html\n", folder);
  fmt::print("  particles  {}/{}.vtkhdf.series (ParaView)\n", folder,
             result.at("case").get<std::string>());
  fmt::print("  numbers    {0}/result.json, {0}/series.csv\n", folder);
  if (result.contains("kerf") && !will_converge &&
      (!result.contains("intervals") || result.at("intervals").empty()))
    fmt::print("  intervals  not examined; {} --converge does\n", settings.resume_command);
}

ConvergeSettings converge_settings_of(const RunOptions& options, const RunLoopSettings& run) {
  ConvergeSettings settings;
  settings.case_file = options.case_file;
  settings.folder = run.folder;
  settings.layouts = options.layouts;
  settings.resume_command = run.resume_command;
  settings.executor.cores = run.threads;
  settings.executor.device = options.machine.device;
  settings.quiet = options.json_summary;
  settings.executor.quiet = options.quiet || options.json_summary;
  return settings;
}

// The exit code is 128 plus the number of the signal, as in a shell.
void leave_if_stopped(int signal) {
  if (signal != 0) throw CLI::RuntimeError(128 + signal);
}

// Lets Slurm run the case, with one thread unless the options have another number. The node tests
// the device and the memory.
int run_by_slurm(RunOptions options) {
  if (options.machine.threads == 0) options.machine.threads = 1;
  const Case description = parse_case(case_text(options.case_file), options.case_file);
  SlurmRun run;
  run.resources = {options.machine.threads, derive(description).memory,
                   std::string(word_of(options.machine.device)), options.ranks};
  if constexpr (ranks::exist)
    if (options.ranks > 1)
      refuse_undistributed(description, fmt::format("--ranks {}", options.ranks),
                           "Leave the option out.");
  fs::path folder =
      options.folder.empty() ? default_folder(options.case_file) : fs::path(options.folder);
  if (!folder.has_filename()) folder = folder.parent_path();
  run.name = "kerf-" + fs::path(options.case_file).stem().string();
  run.folder = folder.string();
  run.arguments = arguments_of(options, folder);
  const std::pair<bool, const char*> flags[] = {{options.resume, "--resume"},
                                                {options.force, "--force"},
                                                {options.quiet, "--quiet"},
                                                {options.json_summary, "--json-summary"},
                                                {options.ignore_memory, "--ignore-memory"}};
  for (const auto& [is_given, word] : flags)
    if (is_given) run.arguments.emplace_back(word);
  run.resume_command = resume_command(options, folder);
  return run_on_slurm(run);
}

// Refuses the options that several ranks cannot follow.
void refuse_for_ranks(const RunOptions& options) {
  const auto refuse = [](const char* option, const char* reason) {
    throw UserError(fmt::format("mpirun with {} ranks: {} {}. Leave the option or mpirun out.",
                                ranks::count(), option, reason),
                    exit_bad_input);
  };
  if (options.where == "slurm") refuse("--on slurm", "starts a run of its own");
  if (options.ranks > 1) refuse("--ranks", "is for runs on Slurm");
  if (options.converge) refuse("--converge", "starts runs of one rank each");
  if (options.machine.device != Device::cpu) refuse("--device gpu", "computes with one rank only");
}

void run_here(const RunOptions& options, RunLoopSettings settings) {
  continue_to_later_end(settings);
  const ConvergeSettings further = converge_settings_of(options, settings);
  if (options.converge) check_convergence(settings.description, further);
  leave_if_stopped(RunLoop(settings, make_simulation).run().signal);
  const fs::path file = settings.folder / "result.json";
  using_result(file, [&] {
    if (!options.json_summary) print_output_paths(settings, read_result(file), options.converge);
    if (options.converge) leave_if_stopped(converge(settings.description, further));
    if (options.json_summary) fmt::print("{}", run_json(read_result(file), settings.folder));
  });
}

// Of several ranks the first one runs the case, and the others follow it.
void run_with_ranks(const RunOptions& options) {
  RunLoopSettings settings;
  at_all_ranks([&] {
    refuse_for_ranks(options);
    take_machine(options.machine);
    settings = settings_of(options);
    refuse_undistributed(settings.description, fmt::format("mpirun with {} ranks", ranks::count()),
                         "Run this case without mpirun.");
  });
  if (ranks::number() != 0) return follow(settings.description);
  const Lead lead;
  run_here(options, std::move(settings));
}

void run(const RunOptions& options) {
  if constexpr (ranks::exist)
    if (ranks::are_several()) return run_with_ranks(options);
  check_ranks(options.ranks, options.where);
  if (options.where == "slurm") {
    if (const int code = run_by_slurm(options); code != 0) throw CLI::RuntimeError(code);
    return;
  }
  take_machine(options.machine);
  run_here(options, settings_of(options));
}

}  // namespace

void add_run_command(CLI::App& program) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = program.add_subcommand("run", "Run a case and report on it");
  command->add_option("CASE", options->case_file, "the case file")->required();
  add_out_option(*command, options->folder, "folder for the results; default out/<case>");
  add_machine_options(*command, options->machine);
  CLI::Option* resume =
      command->add_flag("--resume", options->resume, "continue from the last checkpoint");
  command->add_flag("--force", options->force, "replace the run in the folder")->excludes(resume);
  command->add_flag("--quiet", options->quiet, "show the result only");
  command->add_flag("--json-summary", options->json_summary,
                    "show the result only, as one JSON object in SI units, for programs");
  const std::map<std::string, LogFormat> formats{{"text", LogFormat::text},
                                                 {"json", LogFormat::json}};
  command
      ->add_option_function<std::string>(
          "--log",
          [options, formats](const std::string& word) { options->log_format = formats.at(word); },
          "format of the log: text, or json for programs")
      ->check(CLI::IsMember(formats))
      ->default_str("text");
  CLI::Option* converges = command->add_flag(
      "--converge", options->converge,
      "also run the case at two coarser spacings and in other layouts, and give each headline "
      "number its interval");
  command->add_option("--layouts", options->layouts, "layouts of the particles with --converge")
      ->needs(converges)
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_flag("--ignore-memory", options->ignore_memory,
                    "run a case whose estimated memory is more than this machine has free");
  command
      ->add_option(
          "--on", options->where,
          "where the run is computed: this machine, or Slurm, which gives each rank the cores "
          "of --threads (1)")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  add_ranks_option(*command, options->ranks);
  command->callback([options] { run(*options); });
}

}  // namespace kerf
