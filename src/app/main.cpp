// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/exit_codes.hpp"
#include "app/version_text.hpp"
#include "core/error.hpp"
#include "input/problems.hpp"

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

int run(CLI::App& program, int argc, char** argv) {
  try {
    program.parse(argc, argv);
  } catch (const CLI::RuntimeError& error) {
    return error.get_exit_code();
  } catch (const CLI::ParseError& error) {
    if (program.exit(error) == 0) return 0;
    suggest(program);
    return exit_usage;
  } catch (const UserError& error) {
    fmt::print(stderr, "kerf: error: {}\n", error.what());
    return error.exit_code();
  } catch (const std::bad_alloc&) {
    fmt::print(stderr,
               "kerf: error: there is not enough memory. What the case needs is told by 'kerf "
               "check'; a greater spacing, a smaller piece or symmetry planes need less.\n");
    return exit_run_failed;
  } catch (const std::exception& error) {
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
