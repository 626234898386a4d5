// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/embedded.hpp"
#include "app/verify_page.hpp"
#include "core/error.hpp"
#include "input/units.hpp"
#include "model/case.hpp"
#include "output/files.hpp"
#include "simulation/simulation.hpp"
#include "verification/table.hpp"
#include "verification/verify.hpp"
#include "verification/worst.hpp"

namespace kerf {

namespace {

struct VerifyOptions {
  std::vector<std::string> names, runs;
  bool all = false;
  bool list = false;
  bool experiments = false;
  std::string json;
  std::string page;
  std::string keep;
  std::string turned = "0 deg";
  Placement placement;
  std::string elsewhere;
  MachineOptions machine;
};

std::vector<VerificationCase> all_cases(bool experiments) {
  return read_verification_cases(experiments ? experiment_texts() : validation_texts(),
                                 case_templates());
}

// Refuses a name that is not in this table but in the other.
void refuse_other_table(const std::string& name, bool experiments) {
  const auto others = all_cases(!experiments);
  const auto has_name = [&](const VerificationCase& entry) { return entry.name == name; };
  if (std::none_of(others.begin(), others.end(), has_name)) return;
  throw UserError(fmt::format("\"{}\" is {}.", name,
                              experiments ? "a case with theory: leave out --experiments"
                                          : "a published experiment: add --experiments"),
                  exit_bad_input);
}

std::vector<VerificationCase> chosen_cases(const VerifyOptions& options) {
  const std::vector<std::string>& names = options.names;
  auto cases = all_cases(options.experiments);
  if (names.empty()) return cases;
  std::vector<std::string> known;
  for (const auto& entry : cases) known.push_back(entry.name);
  for (const std::string& name : names) {
    if (std::count(known.begin(), known.end(), name) > 0) continue;
    refuse_other_table(name, options.experiments);
    refuse_name(fmt::format("there is no {} \"{}\"",
                            options.experiments ? "experiment" : "verification case", name),
                name, known);
  }
  std::erase_if(cases, [&](const VerificationCase& entry) {
    return std::count(names.begin(), names.end(), entry.name) == 0;
  });
  return cases;
}

// Cases without any of the runs are removed too.
void keep_runs(const std::vector<std::string>& runs, std::vector<VerificationCase>& cases) {
  if (runs.empty()) return;
  std::vector<std::string> known;
  for (const VerificationCase& entry : cases)
    for (const PlannedRun& run : entry.runs) known.push_back(run.name);
  for (const std::string& run : runs) {
    if (std::count(known.begin(), known.end(), run) > 0) continue;
    refuse_name(fmt::format("--run: there is no run \"{}\" in the cases chosen", run), run, known,
                "; ");
  }
  std::erase_if(cases, [&](VerificationCase& entry) { return !entry.keep_runs(runs); });
}

// Refuses a choice of runs by which no row can be judged.
void refuse_without_rows(const std::vector<VerificationCase>& cases, const VerifyOptions& options) {
  std::set<std::string> lacking;
  for (const VerificationCase& entry : cases)
    for (const Check& check : entry.checks) {
      if (!entry.due_runs(check, options.all).empty()) return;
      const auto others = check.other_runs();
      lacking.insert(others.begin(), others.end());
      lacking.insert(check.runs.begin(), check.runs.end());
    }
  if (cases.empty()) return;
  for (const std::string& run : options.runs) lacking.erase(run);
  throw UserError(
      options.runs.empty()
          ? "every run of these cases is a long one: add --all, or choose some by --run."
          : fmt::format("--run: these runs alone judge no row, which takes its interval or its "
                        "scale from others. Add some of: {}.",
                        fmt::join(lacking, "; ")),
      exit_bad_input);
}

void print_cases(const std::vector<VerificationCase>& cases) {
  for (const VerificationCase& entry : cases) {
    const auto is_long = [](const PlannedRun& run) { return run.is_long; };
    const auto count = std::count_if(entry.runs.begin(), entry.runs.end(), is_long);
    fmt::print("{:<16} {} (runs: {}, of which with --all only: {})\n", entry.name, entry.title,
               entry.runs.size(), count);
  }
}

double read_angle(const std::string& text) {
  const Quantity quantity = read_quantity(text, "rad");
  if (!quantity.problem.empty())
    throw UserError(
        fmt::format("--turned: {}. Write an angle such as \"30 deg\".", quantity.problem),
        exit_bad_input);
  return quantity.value;
}

VerificationCase placed_at(VerificationCase entry, const Placement& placement) {
  for (PlannedRun& run : entry.runs) run.placement = placement;
  return entry;
}

// Refuses a placement of a case that was named.
[[noreturn]] void refuse_placement(const VerificationCase& entry, const Placement& placement,
                                   const std::string& problem) {
  const Placement allowed = allowed_part(entry, placement);
  throw UserError(
      fmt::format("{} cannot be {}: {}. {}, or leave out the case.", entry.name, placement.text(),
                  problem,
                  allowed.is_as_written()
                      ? "Leave out --turned, --mirrored, --moved and --standoff"
                      : fmt::format("Of this it can be {}: leave out the rest", allowed.text())),
      exit_bad_input);
}

// Places the runs of the cases that can be placed like this, and removes the others. A case that
// was named is refused instead.
void place(const Placement& placement, bool are_named, std::vector<VerificationCase>& cases) {
  if (placement.is_as_written()) return;
  fmt::print("Every case is {}.\n", placement.text());
  std::erase_if(cases, [&](VerificationCase& entry) {
    const std::string problem = placement_problem(entry, placement);
    if (problem.empty()) {
      entry = placed_at(std::move(entry), placement);
      return false;
    }
    if (are_named) refuse_placement(entry, placement, problem);
    fmt::print("{} is left out: {}\n", entry.name, problem);
    return true;
  });
}

// A line on the terminal that is removed when the case is done.
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

// Verifies a case as it is given, and elsewhere if a text is given to draw the placement from.
Findings verify_here_and_elsewhere(const VerificationCase& entry, const VerifyOptions& options,
                                   const KeptRuns& kept) {
  const VerifyLine line;
  const auto show = [&](const std::string& run, double share) {
    line.show(entry.name, run, share);
  };
  Findings found = verify(entry, options.all, show, kept);
  if (!options.elsewhere.empty()) {
    const Placement drawn = random_placement(options.elsewhere);
    const Placement there = allowed_part(entry, drawn);
    if (!there.is_as_written())
      found = worst_of(std::move(found), verify(placed_at(entry, there), options.all, show, kept));
    found.elsewhere[entry.name] = allowed_text(entry, drawn);
  }
  line.clear();
  return found;
}

Findings verify_and_print(const std::vector<VerificationCase>& cases, const VerifyOptions& options,
                          const KeptRuns& kept) {
  Findings findings;
  const auto append = [](auto& to, auto& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  fmt::print("{}", table_head());
  for (const VerificationCase& entry : cases) {
    Findings found = verify_here_and_elsewhere(entry, options, kept);
    for (const Row& row : found.rows) fmt::print("{}", table_row(row));
    for (const auto& [name, text] : found.elsewhere) fmt::print("{} elsewhere: {}\n", name, text);
    findings.elsewhere.merge(found.elsewhere);
    std::fflush(stdout);
    append(findings.rows, found.rows);
    append(findings.curves, found.curves);
    append(findings.images, found.images);
  }
  return findings;
}

void run_verification(const VerifyOptions& options) {
  auto cases = chosen_cases(options);
  keep_runs(options.runs, cases);
  if (options.list) {
    print_cases(cases);
    return;
  }
  Placement placement = options.placement;
  placement.angle = read_angle(options.turned);
  if (!options.elsewhere.empty() && !placement.is_as_written())
    throw UserError(
        "--elsewhere draws the placement. Leave out --turned, --mirrored, --moved and --standoff, "
        "or leave out --elsewhere.",
        exit_bad_input);
  if (!options.elsewhere.empty())
    fmt::print(
        "Every case is judged by the worse of two runs: as written, and {} (as far as the "
        "case allows it).\n",
        random_placement(options.elsewhere).text());
  if (!options.page.empty() && !placement.is_as_written())
    throw UserError(
        "--page: the page shows the cases as they are written. Leave out --turned, --mirrored, "
        "--moved and --standoff, or write the table with --json.",
        exit_bad_input);
  place(placement, !options.names.empty(), cases);
  take_machine(options.machine);
  const KeptRuns kept(options.keep);
  for (VerificationCase& entry : cases) take_up_kept(entry, kept);
  refuse_without_rows(cases, options);
  const Findings findings = verify_and_print(cases, options, kept);
  if (!options.json.empty()) write_file(options.json, to_json(findings.rows));
  if (!options.page.empty())
    write_verification_page(options.page, cases, findings,
                            options.experiments ? TableKind::experiments : TableKind::theory,
                            !options.names.empty());
  const auto count = [&](Verdict verdict) {
    return std::count_if(findings.rows.begin(), findings.rows.end(),
                         [verdict](const Row& row) { return row.verdict == verdict; });
  };
  fmt::print("{} passed, {} failed\n", count(Verdict::pass), count(Verdict::fail));
  if (has_failed(findings.rows)) throw CLI::RuntimeError(1);
}

}  // namespace

void add_verify_command(CLI::App& program) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command =
      program.add_subcommand("verify", "Run the verification table against theory on this machine");
  command->add_option("NAME", options->names, "Only these cases");
  command->add_flag("--all", options->all, "Include long runs");
  command->add_option("--run", options->runs, "Only these runs of the cases, including long ones")
      ->allow_extra_args(false);
  command->add_flag("--experiments", options->experiments,
                    "Compare with published experiments instead of theory");
  command->add_flag("--list", options->list, "List the cases and run none");
  command->add_option("--json", options->json, "Also write the table to this file, as JSON");
  command->add_option(
      "--page", options->page,
      "Also write the table into this Markdown page, between its marks, with curves "
      "and pictures beside it; with names of cases, their sections only");
  command->add_option("--keep", options->keep,
                      "Keep each run in this folder, show those that it holds, long ones too, and "
                      "make none of them again; empty it after a change of the program");
  command->add_option("--turned", options->turned,
                      "Turn each case against its lattices by this angle, such as \"30 deg\"");
  command->add_flag("--mirrored", options->placement.mirrored, "Mirror each case in x");
  command
      ->add_option("--moved", options->placement.moved,
                   "Move jets and probes across the jet by this many spacings")
      ->check(CLI::Range(-100.0, 100.0));
  command
      ->add_option("--standoff", options->placement.standoff,
                   "Multiply the standoff of jets by this factor")
      ->check(CLI::Range(1.0, 10.0));
  command->add_option("--elsewhere", options->elsewhere,
                      "Run each case a second time, turned, mirrored, moved and with another "
                      "standoff, all drawn from this text, and judge it by the worse run");
  add_machine_options(*command, options->machine);
  command->callback([options] { run_verification(*options); });
}

}  // namespace kerf
