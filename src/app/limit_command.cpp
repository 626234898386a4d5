// SPDX-License-Identifier: Apache-2.0
// This file implements kerf limit: the greatest feed or least pressure of a case that still cuts.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/executor_options.hpp"
#include "app/signals.hpp"
#include "app/study_display.hpp"
#include "core/error.hpp"
#include "output/files.hpp"
#include "output/readable.hpp"
#include "study/feed_by_exposure.hpp"
#include "study/limit_answer.hpp"
#include "study/limit_runs.hpp"
#include "study/run_table.hpp"
#include "study/study_answers.hpp"
#include "study/study_runs.hpp"

namespace kerf {

namespace {

namespace fs = std::filesystem;

struct LimitOptions {
  std::string file;
  std::string folder;
  LimitQuestion question;
  ExecutorOptions executor;
};

// Prints the trials as they end, and how many more there will be.
class LimitTable {
 public:
  LimitTable(const LimitPlan& plan, StudyDisplay& display, bool quiet)
      : plan_(plan), display_(display), quiet_(quiet) {}

  void tell(const std::vector<RunRow>& runs, const std::vector<std::string>& ids, const Trial& last,
            int side_by_side) {
    double seconds = std::chrono::duration<double>(Clock::now() - round_).count();
    round_ = Clock::now();
    if (quiet_) return;
    display_.clear();
    if (count_ == 0) fmt::print("{}\n", trial_heading(plan_));
    for (const std::string& id : ids) {
      const auto row =
          std::find_if(runs.begin(), runs.end(), [&](const RunRow& each) { return each.id == id; });
      if (row == runs.end()) continue;
      fmt::print("{}\n", trial_line(plan_, ++count_, *row));
      // A run that was found finished took its time, too.
      if (const double* time = find_number(*row, "wall_time")) seconds = std::max(seconds, *time);
    }
    tell_what_is_left(runs, last, side_by_side, seconds);
    std::fflush(stdout);
  }

 private:
  using Clock = std::chrono::steady_clock;

  // The time of the last round is that of each further one.
  void tell_what_is_left(const std::vector<RunRow>& runs, const Trial& last, int side_by_side,
                         double seconds) const {
    const auto bracket = bracket_of(plan_, runs, last);
    if (!bracket) return;
    const double tolerance = plan_.study.threshold->tolerance;
    const int rounds = rounds_left(*bracket, tolerance, side_by_side);
    if (rounds > 0)
      fmt::print("       bracket ± {:.2g}%, tolerance ± {:.2g}%: {} more round{}, about {}\n",
                 100.0 * bracket->half_width() / bracket->middle(), 100.0 * tolerance, rounds,
                 rounds == 1 ? "" : "s", duration_text(rounds * seconds));
  }

  const LimitPlan& plan_;
  StudyDisplay& display_;
  bool quiet_;
  std::size_t count_ = 0;
  Clock::time_point round_ = Clock::now();
};

void write_answer(const LimitPlan& plan, const LimitAnswer& answer, const fs::path& folder) {
  write_file(folder / "limit.json", limit_json(plan, answer).dump(2) + "\n");
  write_file(folder / "limit.html", limit_page(plan, answer));
  write_file(folder / "limit.csv", study_csv(plan.study, answer.runs));
}

void print_answer(const LimitPlan& plan, const LimitAnswer& answer, const LimitOptions& options,
                  const fs::path& folder) {
  const LimitWords words = describe_limit(plan, answer);
  fmt::print("{}: {}\n", words.question, words.finding);
  if (options.executor.quiet) return;
  for (const std::string& note : words.notes) fmt::print("  {}\n", note);
  fmt::print("  page       {0}/limit.html\n  numbers    {0}/limit.json, {0}/limit.csv\n",
             folder.string());
}

// Returns the runs at the ends of the range that the question states; the search begins elsewhere.
std::vector<Trial> stated_ends(const LimitQuestion& question, const LimitPlan& plan) {
  const Axis& axis = plan.study.threshold->axis;
  std::vector<Trial> trials;
  const auto add = [&](const std::string& stated, std::size_t end) {
    if (stated.empty() || plan.by_exposure) return;
    Trial trial{{}, 0, plan.study.refinement};
    axis.put_level(end, trial.setting);
    trials.push_back(with_end(plan, trial));
  };
  add(question.from, 0);
  add(question.to, 1);
  return trials;
}

// One search, from the first run to its files.
class LimitSearch {
 public:
  LimitSearch(const LimitOptions& options, const LimitPlan& plan, fs::path folder)
      : options_(options),
        plan_(plan),
        folder_(std::move(folder)),
        lock_(folder_),
        database_(folder_ / "study.db"),
        maker_(plan.study),
        executor_(make_executor(options.executor, folder_)),
        display_(progress_style(options.executor.quiet)),
        table_(plan, display_, options.executor.quiet),
        runs_(folder_, maker_, database_, *executor_,
              {[this](const StudyProgress& now) { display_.show(now); },
               [this] { return signals_.caught(); }},
              options.executor.retry) {}

  void run() {
    runs_.refuse_invalid(stated_ends(options_.question, plan_));
    LimitRuns laboratory(plan_, runs_, [this](const auto& ids, const Trial& last) {
      table_.tell(runs_.asked(), ids, last, executor_->side_by_side());
      write_answer(plan_, answer(), folder_);
    });
    try {
      found_ = plan_.by_exposure ? feed_by_exposure(plan_, laboratory)
                                 : find_threshold(*plan_.study.threshold,
                                                  {{}, 0, plan_.study.refinement}, laboratory);
    } catch (const StudyStopped& stopped) {
      finish();
      fmt::print("Stopped. Start the same command again to continue; no run is repeated.\n");
      throw CLI::RuntimeError(128 + stopped.signal);
    } catch (const UserError&) {
      finish();
      throw;
    }
    finish();
  }

 private:
  LimitAnswer answer() const { return {found_, runs_.asked()}; }
  void finish() {
    display_.clear();
    write_answer(plan_, answer(), folder_);
    print_answer(plan_, answer(), options_, folder_);
  }

  const LimitOptions& options_;
  const LimitPlan& plan_;
  fs::path folder_;
  FolderLock lock_;
  StudyDatabase database_;
  CaseMaker maker_;
  std::unique_ptr<Executor> executor_;
  StopSignals signals_;
  StudyDisplay display_;
  LimitTable table_;
  StudyRuns runs_;
  std::optional<ThresholdAnswer> found_;
};

void limit(const LimitOptions& options) {
  const LimitPlan plan = plan_limit(options.file, options.question);
  const fs::path folder = options.folder.empty() ? fs::path("out") / (plan.study.name + "-limit")
                                                 : fs::path(options.folder);
  make_folder(folder);
  if (!options.executor.quiet) {
    fmt::print("{}, results in {}\n", plan.study.title, folder.string());
    for (const std::string& sentence : plan.held) fmt::print("  {}\n", sentence);
  }
  LimitSearch(options, plan, folder).run();
}

std::string quantity_help() {
  std::string text = "quantity whose limit is searched:";
  for (const LimitQuantity& each : limit_quantities())
    text += fmt::format(" {} ({}),", each.name, each.meaning);
  return text + " or the path of a key that holds a number, such as materials.NAME.failure_strain";
}

void add_question(CLI::App& command, LimitQuestion& question) {
  command.add_option("--of", question.of, quantity_help())->required();
  command
      .add_option("--find", question.find,
                  "which limit: the least or the greatest value; default: by the quantity")
      ->check(CLI::IsMember({"least", "greatest"}));
  command.add_option(
      "--where", question.where,
      "condition instead of cut-through, such as \"kerf.depth >= 5 mm\"; default for "
      "feed: kerf.through_share >= 0.95");
  command.add_option(
      "--from", question.from,
      fmt::format("lower end of the range; default: the stated value / {:g}", limit_range_factor));
  command.add_option("--to", question.to,
                     fmt::format("upper end of the range; default: the stated value times {:g}",
                                 limit_range_factor));
  command
      .add_option("--tolerance", question.tolerance, "half-width of the bracket over its middle")
      ->check(CLI::Range(1e-4, 0.5))
      ->capture_default_str();
  command
      .add_option("--refine", question.refinement,
                  "divides every spacing of the case; below 1 coarser and faster")
      ->check(CLI::Range(0.01, 100.0))
      ->capture_default_str();
  command.add_option("--runs", question.most_runs, "greatest number of runs")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  command
      .add_option("--layouts", question.layouts,
                  "layouts of the particles in which the bracket must hold; default: 1, with "
                  "--converge 3")
      ->check(CLI::Range(1, 1000));
  command.add_flag("--converge", question.converge,
                   "also search at a coarser spacing and in three layouts, which widens the "
                   "interval by their effect");
}

}  // namespace

void add_limit_command(CLI::App& program) {
  auto options = std::make_shared<LimitOptions>();
  CLI::App* command = program.add_subcommand(
      "limit", "Find the greatest feed or the least pressure at which a case still cuts");
  command->add_option("CASE", options->file, "the case file")->required();
  add_question(*command, options->question);
  add_out_option(*command, options->folder,
                 "folder for the results; default out/<case>-limit; the same command in the "
                 "same folder continues");
  add_executor_options(*command, options->executor);
  command->callback([options] { limit(*options); });
}

}  // namespace kerf
