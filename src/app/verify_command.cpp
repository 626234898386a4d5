// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>

#include "app/commands.hpp"
#include "app/embedded.hpp"
#include "case/problems.hpp"
#include "core/error.hpp"
#include "output/files.hpp"
#include "simulation/simulation.hpp"
#include "verify/table.hpp"
#include "verify/verify.hpp"

namespace kerf {

namespace {

struct VerifyOptions {
  std::vector<std::string> names;
  bool all = false;
  bool list = false;
  std::string json;
  std::string page;
  int threads = 0;
};

// The part of a page between these lines is the program's.
constexpr std::string_view table_begin = "<!-- kerf verify: begin -->\n";
constexpr std::string_view table_end = "<!-- kerf verify: end -->";

void put_into_page(const std::string& file, const std::string& table) {
  std::string text = read_file(file);
  const auto begin = text.find(table_begin);
  const auto end = text.find(table_end);
  if (begin == std::string::npos || end == std::string::npos || end < begin)
    throw UserError(fmt::format("{} has no place for the table. Write the lines\n{}{}\nwhere it is "
                                "to stand.",
                                file, table_begin, table_end),
                    exit_files);
  const auto first = begin + table_begin.size();
  write_file(file, text.replace(first, end - first, table));
}

std::vector<VerificationCase> chosen_cases(const std::vector<std::string>& names) {
  auto cases = read_verification_cases(validation_texts(), case_templates());
  if (names.empty()) return cases;
  std::vector<std::string> known;
  for (const auto& entry : cases) known.push_back(entry.name);
  for (const std::string& name : names) {
    if (std::count(known.begin(), known.end(), name) > 0) continue;
    const std::string guess = closest(name, known);
    throw UserError(fmt::format("there is no verification case \"{}\". {}Allowed: {}.", name,
                                guess.empty() ? "" : fmt::format("Did you mean \"{}\"? ", guess),
                                fmt::join(known, ", ")));
  }
  std::erase_if(cases, [&](const VerificationCase& entry) {
    return std::count(names.begin(), names.end(), entry.name) == 0;
  });
  return cases;
}

void print_list(const std::vector<VerificationCase>& cases) {
  for (const VerificationCase& entry : cases) {
    const auto is_long = [](const PlannedRun& run) { return run.is_long; };
    const auto count = std::count_if(entry.runs.begin(), entry.runs.end(), is_long);
    fmt::print("{:<16} {} (runs: {}, of which with --all only: {})\n", entry.name, entry.title,
               entry.runs.size(), count);
  }
}

// A line on the terminal that goes when the case is done.
class VerifyLine {
 public:
  void show(const std::string& name, const std::string& run, double share) const {
    if (is_terminal_) fmt::print(stderr, "\r\033[K{}, {}: {:.0f}%", name, run, 100.0 * share);
  }
  void clear() const {
    if (is_terminal_) fmt::print(stderr, "\r\033[K");
  }

 private:
  bool is_terminal_ = isatty(STDERR_FILENO) != 0;
};

std::vector<Row> verify_and_print(const std::vector<VerificationCase>& cases, bool all) {
  const VerifyLine line;
  std::vector<Row> rows;
  fmt::print("{}", table_head());
  for (const VerificationCase& entry : cases) {
    const auto found = verify(entry, all, [&](const std::string& run, double share) {
      line.show(entry.name, run, share);
    });
    line.clear();
    for (const Row& row : found) fmt::print("{}", table_row(row));
    std::fflush(stdout);
    rows.insert(rows.end(), found.begin(), found.end());
  }
  return rows;
}

void run_verification(const VerifyOptions& options) {
  const auto cases = chosen_cases(options.names);
  if (options.list) {
    print_list(cases);
    return;
  }
  set_threads(options.threads);
  const auto rows = verify_and_print(cases, options.all);
  if (!options.json.empty()) write_file(options.json, to_json(rows));
  if (!options.page.empty()) put_into_page(options.page, to_markdown(cases, rows));
  const auto failed = std::count_if(rows.begin(), rows.end(),
                                    [](const Row& row) { return row.verdict == Verdict::fail; });
  const auto passed = std::count_if(rows.begin(), rows.end(),
                                    [](const Row& row) { return row.verdict == Verdict::pass; });
  fmt::print("{} passed, {} failed\n", passed, failed);
  if (failed > 0) throw CLI::RuntimeError(1);
}

}  // namespace

void add_verify_command(CLI::App& program) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command =
      program.add_subcommand("verify", "Run the verification table against theory on this machine");
  command->add_option("NAME", options->names, "Only these cases");
  command->add_flag("--all", options->all, "With the runs that take long");
  command->add_flag("--list", options->list, "List the cases and run none");
  command->add_option("--json", options->json, "Also write the table to this file, as JSON");
  command->add_option("--page", options->page,
                      "Also put the table into this Markdown page, between its marks");
  command->add_option("--threads", options->threads, "Threads, 0 = every core")
      ->check(CLI::NonNegativeNumber);
  command->callback([options] { run_verification(*options); });
}

}  // namespace kerf
