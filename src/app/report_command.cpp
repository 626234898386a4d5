// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>

#include "app/commands.hpp"
#include "app/run_folder.hpp"
#include "model/case.hpp"
#include "report/picture.hpp"
#include "report/report.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;

void report(const fs::path& folder, bool movie) {
  const Case description = case_of_run(folder);
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
  CLI::App* command = program.add_subcommand("report", "Write the report of a run again");
  command->add_option("OUT", *folder, "the folder of the run's results")->required();
  auto movie = std::make_shared<bool>(false);
  command->add_flag("--movie", *movie, "also write movie.mp4 of all frames, with ffmpeg");
  command->callback([folder, movie] { report(*folder, *movie); });
}

}  // namespace kerf
