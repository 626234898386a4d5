// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>

#include "app/commands.hpp"
#include "case/read.hpp"
#include "core/error.hpp"
#include "report/report.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;

void report(const fs::path& folder) {
  const fs::path used = folder / "case.used.toml";
  if (!fs::exists(used))
    throw UserError(fmt::format("{} holds no run of Kerf (there is no case.used.toml). Name the "
                                "folder that was given to 'kerf run' by --out.",
                                folder.string()),
                    exit_files);
  write_report(folder, read_case(used));
  fmt::print("{}\n", (folder / "report.html").string());
}

}  // namespace

void add_report_command(CLI::App& program) {
  auto folder = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("report", "Make the report of a run again");
  command->add_option("OUT", *folder, "the folder of the run's results")->required();
  command->callback([folder] { report(*folder); });
}

}  // namespace kerf
