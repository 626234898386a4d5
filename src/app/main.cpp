// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "app/commands.hpp"
#include "app/exit_codes.hpp"
#include "app/version_text.hpp"
#include "core/error.hpp"
#include "input/problems.hpp"
#include "parallel/ranks.hpp"
#include "study/process_limits.hpp"

namespace kerf {
namespace {

// Names what was probably meant by arguments that the program does not know.
void suggest(const CLI::App& program) {
  const CLI::App* command = &program;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  std::vector<std::string> known;
  for (const CLI::Option* option : command->get_options())
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  for (const CLI::App* below : command->get_subcommands({})) known.push_back(below->get_name());
  for (const std::string& word : command->remaining(true)) {
    const std::string guess = closest(word.substr(0, word.find('=')), known);
    if (!guess.empty()) fmt::print(stderr, "Did you mean {} instead of {}?\n", guess, word);
  }
}

// Names a command that the program does not have, and the nearest one that it has.
void refuse_unknown_command(const CLI::App& program, int argc, char** argv) {
  const std::string word = argc > 1 ? argv[1] : "-";
  if (word.empty() || word.front() == '-') return;
  std::vector<std::string> known;
  for (const CLI::App* command : program.get_subcommands({})) known.push_back(command->get_name());
  if (std::find(known.begin(), known.end(), word) != known.end()) return;
  const std::string guess = closest(word, known);
  throw UserError(
      fmt::format("there is no command \"{}\". Allowed: {}. {}", word, fmt::join(known, ", "),
                  guess.empty() ? std::string("Run kerf --help, which says what each does.")
                                : fmt::format("Did you mean {} instead of {}?", guess, word)),
      exit_usage);
}

// Names of files become part of JSON and of pages, which hold UTF-8 alone.
void refuse_other_encodings(int argc, char** argv) {
  for (int n = 1; n < argc; ++n) try {
      static_cast<void>(nlohmann::json(argv[n]).dump());
    } catch (const nlohmann::json::exception&) {
      throw CLI::ParseError(
          fmt::format("{}: the word is not valid UTF-8. Rename the file or folder.", argv[n]),
          exit_usage);
    }
}

int tell_of_memory() {
  fmt::print(stderr,
             "kerf: error: there is not enough memory. What the case needs is told by 'kerf "
             "check'; a greater spacing, a smaller piece or symmetry planes need less.\n");
  return exit_run_failed;
}

// Several ranks share a run; each would do the work of another command.
void refuse_other_commands(int argc, char** argv) {
  if (!ranks::are_several() || (argc > 1 && std::string(argv[1]) == "run")) return;
  throw UserError(
      fmt::format("mpirun with {} ranks: only 'kerf run' is computed by several ranks. Start "
                  "other commands without mpirun.",
                  ranks::count()),
      exit_usage);
}

int run(CLI::App& program, int argc, char** argv) {
  try {
    refuse_small_limits();
    refuse_other_commands(argc, argv);
    refuse_other_encodings(argc, argv);
    refuse_unknown_command(program, argc, argv);
    program.parse(argc, argv);
  } catch (const CLI::RuntimeError& error) {
    return error.get_exit_code();
  } catch (const CLI::ParseError& error) {
    if (ranks::number() != 0) return error.get_exit_code() == 0 ? 0 : exit_usage;  // rank 0 says it
    if (program.exit(error) == 0) return 0;
    suggest(program);
    return exit_usage;
  } catch (const UserError& error) {
    if (ranks::number() == 0) fmt::print(stderr, "kerf: error: {}\n", error.what());
    return error.exit_code();
  } catch (const std::bad_alloc&) {
    return tell_of_memory();
  } catch (const std::exception& error) {
    // A thread that cannot be made.
    const auto* system = dynamic_cast<const std::system_error*>(&error);
    if (system && system->code() == std::errc::resource_unavailable_try_again)
      return tell_of_memory();
    if (std::ferror(stdout) != 0) return exit_files;  // main() says so
    fmt::print(stderr, "kerf: internal error: {}. Please report this with the case.\n",
               error.what());
    return exit_internal;
  }
  return 0;
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the limit of file sizes fails with an error
  const kerf::ranks::Session ranks(argc, argv);
  CLI::App program("Kerf simulates water-jet cutting.", "kerf");
  program.set_version_flag("--version", kerf::version_text);
  program.require_subcommand(1);
  kerf::add_new_command(program);
  kerf::add_check_command(program);
  kerf::add_run_command(program);
  kerf::add_report_command(program);
  kerf::add_view_command(program);
  kerf::add_materials_command(program);
  kerf::add_bench_command(program);
  kerf::add_verify_command(program);
  kerf::add_study_command(program);
  kerf::add_limit_command(program);
  kerf::add_completion_command(program);
  kerf::add_manual_command(program);
  const int code = kerf::run(program, argc, argv);
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  fmt::print(stderr,
             "kerf: error: the standard output could not be written in full: {}. Free space there, "
             "or send it elsewhere.\n",
             std::strerror(errno));
  return code != 0 ? code : kerf::exit_files;
}
