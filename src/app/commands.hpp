// SPDX-License-Identifier: Apache-2.0
// This header declares one function for each command of the program, which adds its options to the
// command line and runs it when it is chosen. Each is in <name>_command.cpp and throws UserError.
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
void add_limit_command(CLI::App& program);
void add_completion_command(CLI::App& program);
void add_manual_command(CLI::App& program);

}  // namespace kerf
