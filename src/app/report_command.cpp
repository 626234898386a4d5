// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/commands.hpp"
#include "app/run_folder.hpp"
#include "model/case.hpp"
#include "report/picture.hpp"
#include "report/report.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::string folder, other;
  bool movie = false;
};

void make_movie(const fs::path& folder, const Case& description) {
  const fs::path file = write_movie(folder, description, [](std::size_t done, std::size_t all) {
    fmt::print(stderr, "\rmovie: frame {} of {}", done, all);
  });
  fmt::print(stderr, "\n");
  fmt::print("{}\n", file.string());
}

void report(const ReportOptions& options) {
  const fs::path folder = options.folder;
  const Case description = case_of_run(folder);
  write_report(folder, description);
  fmt::print("{}\n", (folder / "report.html").string());
  if (!options.other.empty()) {
    const Case other = case_of_run(options.other);
    write_comparison({folder, description}, {options.other, other});
    fmt::print("{}\n", (folder / "compare.html").string());
  }
  if (options.movie) make_movie(folder, description);
}

}  // namespace

void add_report_command(CLI::App& program) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command = program.add_subcommand("report", "Write the report of a run again");
  command->add_option("OUT", options->folder, "the folder of the run's results")->required();
  command->add_flag("--movie", options->movie, "also write movie.mp4 of all frames, with ffmpeg");
  command->add_option("--compare", options->other,
                      "the folder of another run: also write compare.html, both side by side");
  command->callback([options] { report(*options); });
}

}  // namespace kerf
