// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>

#include "app/commands.hpp"
#include "case/read.hpp"
#include "core/error.hpp"
#include "report/movie.hpp"
#include "report/report.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;

void report(const fs::path& folder, bool movie) {
  const fs::path used = folder / "case.used.toml";
  if (!fs::exists(used))
    throw UserError(fmt::format("{} holds no run of Kerf (there is no case.used.toml). Name the "
                                "folder that was given to 'kerf run' by --out.",
                                folder.string()),
                    exit_files);
  const Case description = read_case(used);
  write_report(folder, description);
  fmt::print("{}\n", (folder / "report.html").string());
  if (!movie) return;
  const fs::path file = write_movie(folder, description, [](std::size_t done, std::size_t all) {
    fmt::print(stderr, "\rmovie: frame {} of {}", done, all);
  });
  fmt::print(stderr, "\n");
  fmt::print("{}\n", file.string());
}

}  // namespace

void add_report_command(CLI::App& program) {
  auto folder = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("report", "Make the report of a run again");
  command->add_option("OUT", *folder, "the folder of the run's results")->required();
  auto movie = std::make_shared<bool>(false);
  command->add_flag("--movie", *movie, "also make movie.mp4 of all frames, by ffmpeg");
  command->callback([folder, movie] { report(*folder, *movie); });
}

}  // namespace kerf
