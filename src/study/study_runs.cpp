// SPDX-License-Identifier: Apache-2.0
#include "study/study_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "core/error.hpp"
#include "output/files.hpp"

namespace kerf {

namespace {

namespace fs = std::filesystem;

constexpr auto show_pause = std::chrono::milliseconds(250);
constexpr int most_crashes = 2;  // ends by a signal after which a run is not repeated

// Returns the end of the output of a run, which holds its error message.
std::string last_words(const fs::path& output) {
  constexpr std::size_t most = 2000;
  if (!fs::exists(output)) return "";
  std::string text = read_file(output);
  if (const auto complaint = text.rfind("kerf: "); complaint != std::string::npos)
    text = text.substr(complaint);
  else if (text.size() > most)
    text = text.substr(text.size() - most);
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

// Returns the completed share of a run, from 0 to 1, with which its last line of progress begins.
double share_of(const fs::path& output) {
  if (!fs::exists(output)) return 0.0;
  const std::string text = read_file(output);
  const auto mark = text.rfind("% | left");
  if (mark == std::string::npos) return 0.0;
  const auto start = text.rfind('\n', mark);
  return std::strtod(text.c_str() + (start == std::string::npos ? 0 : start + 1), nullptr) / 100.0;
}

std::string why_it_ended(const Job& job, const JobEnd& end) {
  if (!end.problem.empty()) return end.problem;
  if (end.signal != 0)
    return fmt::format("ended by signal {} ({})", end.signal, strsignal(end.signal));
  const std::string words = last_words(job.output);
  return words.empty() ? fmt::format("ended with exit code {}", end.exit_code) : words;
}

// Makes the cases of all trials. Those that are not valid are refused together, before any run.
std::vector<ResolvedCase> resolve(const CaseMaker& maker, const std::vector<Trial>& trials) {
  constexpr std::size_t most_told = 20;
  std::vector<ResolvedCase> resolved;
  std::vector<std::string> refused;
  for (const Trial& trial : trials) try {
      resolved.push_back(maker.make(trial));
    } catch (const UserError& error) {
      if (std::find(refused.begin(), refused.end(), error.what()) == refused.end())
        refused.emplace_back(error.what());
    }
  if (refused.size() == 1) throw UserError(refused.front());
  if (refused.empty()) return resolved;
  std::string text = fmt::format(
      "{} settings of the study have no valid case, and none of it was run. Change the values that "
      "are varied or the case, so that all are valid:",
      refused.size());
  for (std::size_t n = 0; n < std::min(refused.size(), most_told); ++n) text += "\n" + refused[n];
  if (refused.size() > most_told) text += fmt::format("\nand {} more", refused.size() - most_told);
  throw UserError(text);
}

}  // namespace

fs::path run_folder(const std::string& id) {
  return fs::path("runs") / id;
}

double seconds_left(const StudyProgress& now, double first_share, double seconds) {
  if (now.timed > 0) {
    const double runs = (1.0 - now.share) * static_cast<double>(now.total);
    const double each = now.run_time / static_cast<double>(now.timed);
    return runs * each / static_cast<double>(std::max<std::size_t>(1, now.at_work));
  }
  const double done = now.share - first_share;
  return done > 0.0 ? (1.0 - now.share) * seconds / done : std::numeric_limits<double>::infinity();
}

StudyRuns::StudyRuns(fs::path folder, const CaseMaker& maker, StudyDatabase& database,
                     Executor& executor, Hooks hooks, bool retry)
    : folder_(std::move(folder)),
      maker_(maker),
      database_(database),
      executor_(executor),
      hooks_(std::move(hooks)) {
  for (const RunRow& row : database_.runs())
    if (row.state == RunState::running || (retry && row.state == RunState::failed))
      database_.mark_waiting(row.id);
}

// Writes the case once, beside the folder of the run, which holds only what the run itself writes.
Job StudyRuns::prepared(const ResolvedCase& resolved) const {
  const fs::path results = folder_ / run_folder(resolved.id);
  const auto beside = [&](const char* ending) { return fs::path(results.string() + ending); };
  make_folder(results.parent_path());
  if (!fs::exists(beside(".toml"))) write_file(beside(".toml"), resolved.text);
  for (const auto& [name, content] : resolved.meshes) {
    const fs::path file = results.parent_path() / name;  // one copy for all runs
    if (!fs::exists(file)) write_file(file, *content);
  }
  return {resolved.id, beside(".toml"), results, beside(".txt"), resolved.memory};
}

void StudyRuns::refuse_invalid(const std::vector<Trial>& trials) const {
  resolve(maker_, trials);
}

std::vector<Outcome> StudyRuns::run(const std::vector<Trial>& trials) {
  std::vector<std::string> ids;
  std::vector<Job> jobs;
  std::set<std::string> wanted;
  const std::vector<ResolvedCase> cases = resolve(maker_, trials);
  for (std::size_t n = 0; n < trials.size(); ++n) {
    const ResolvedCase& resolved = cases[n];
    ids.push_back(resolved.id);
    asked_.insert(resolved.id);
    database_.add(resolved, trials[n]);
    if (!wanted.insert(resolved.id).second) continue;
    if (database_.find(resolved.id)->state == RunState::waiting) jobs.push_back(prepared(resolved));
  }
  progress_ = {wanted.size(), wanted.size() - jobs.size(), 0, 0, 0.0, progress_.round + 1};
  for (const std::string& id : wanted) count_time(database_.find(id)->metrics);
  shown_ = {};
  if (!jobs.empty()) executor_.run(jobs, *this);
  if (signal_ != 0) throw StudyStopped{signal_};
  std::vector<Outcome> outcomes;
  for (const std::string& id : ids) {
    const RunRow row = *database_.find(id);
    outcomes.push_back({id, row.state != RunState::done, row.error, row.metrics});
  }
  return outcomes;
}

std::vector<RunRow> StudyRuns::asked() const {
  std::vector<RunRow> rows = database_.runs();
  std::erase_if(rows, [&](const RunRow& row) { return asked_.count(row.id) == 0; });
  return rows;
}

void StudyRuns::started(const Job& job) {
  database_.mark_started(job.id);
}

bool StudyRuns::ended(const Job& job, const JobEnd& end) {
  const bool was_asked_to_stop = signal_ != 0 && (end.exit_code != 0 || end.signal != 0);
  if (was_asked_to_stop) {
    database_.mark_waiting(job.id);
    return false;
  }
  // The attempts of the database include those that ended with an earlier study, whatever ended it.
  if (end.signal != 0 && ++crashes_[job.id] < most_crashes) {
    database_.mark_waiting(job.id);
    return true;
  }
  ++progress_.ended;
  if (end.exit_code == 0 && end.signal == 0) {
    finish(job);
  } else {
    ++progress_.failed;
    database_.mark_failed(job.id, why_it_ended(job, end));
  }
  return false;
}

void StudyRuns::finish(const Job& job) {
  try {
    const Metrics metrics = read_metrics(read_file(job.folder / "result.json"));
    database_.mark_done(job.id, metrics);
    count_time(metrics);
  } catch (const std::exception& error) {
    ++progress_.failed;
    database_.mark_failed(job.id, fmt::format("its results cannot be read: {}", error.what()));
  }
}

void StudyRuns::count_time(const Metrics& metrics) {
  const auto time = metrics.find("wall_time");
  if (time == metrics.end()) return;
  ++progress_.timed;
  progress_.run_time += time->second;
}

bool StudyRuns::look(const std::vector<Job>& at_work) {
  if (hooks_.stop_signal && signal_ == 0) signal_ = hooks_.stop_signal();
  const auto now = std::chrono::steady_clock::now();
  if (hooks_.show && (now - shown_ >= show_pause || progress_.ended == progress_.total)) {
    shown_ = now;
    double parts = 0.0;
    for (const Job& job : at_work) parts += share_of(job.output);
    // For a moment no run is at work between two.
    if (!at_work.empty() || progress_.ended == progress_.total) progress_.at_work = at_work.size();
    progress_.share =
        (static_cast<double>(progress_.ended) + parts) / static_cast<double>(progress_.total);
    hooks_.show(progress_);
  }
  return signal_ != 0;
}

}  // namespace kerf
