// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "app/commands.hpp"
#include "core/error.hpp"
#include "core/version.hpp"

int main(int argc, char** argv) {
  constexpr int exit_usage = 2, exit_internal = 70;
  CLI::App program("Kerf simulates water-jet cutting.", "kerf");
  program.set_version_flag("--version", std::string("kerf ") + kerf::program_version);
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
  try {
    program.parse(argc, argv);
  } catch (const CLI::RuntimeError& error) {
    return error.get_exit_code();
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : exit_usage;
  } catch (const kerf::UserError& error) {
    fmt::print(stderr, "kerf: error: {}\n", error.what());
    return error.exit_code();
  } catch (const std::exception& error) {
    fmt::print(stderr, "kerf: internal error: {}. Please report this with the case.\n",
               error.what());
    return exit_internal;
  }
  return 0;
}
