// SPDX-License-Identifier: Apache-2.0
// One function per command of the program: adds its options to the command line and, when it is
// chosen, does it. Each lives in <name>_command.cpp. Errors leave as UserError.
#pragma once

#include <CLI/CLI.hpp>

namespace kerf {

void add_new_command(CLI::App& program);
void add_check_command(CLI::App& program);
void add_run_command(CLI::App& program);
void add_report_command(CLI::App& program);
void add_view_command(CLI::App& program);
void add_materials_command(CLI::App& program);
void add_bench_command(CLI::App& program);
void add_verify_command(CLI::App& program);
void add_study_command(CLI::App& program);

}  // namespace kerf
