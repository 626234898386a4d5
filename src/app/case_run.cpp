// SPDX-License-Identifier: Apache-2.0
#include "app/case_run.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <optional>

#include "core/error.hpp"
#include "study/child_process.hpp"

namespace kerf {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_output = 4000;  // bytes that are shown

fs::path output_file() {
  std::string name = (fs::temp_directory_path() / "kerf_run_XXXXXX").string();
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0)
    throw UserError(
        fmt::format("cannot write into {}. Is the disk full?", fs::temp_directory_path().string()),
        exit_files);
  close(descriptor);
  return name;
}

}  // namespace

CaseRun::CaseRun(Order order) : order_(std::move(order)), output_(output_file()) {
  watcher_ = std::thread([this] { watch(); });
}

CaseRun::~CaseRun() {
  stop();
  watcher_.join();
  std::error_code ignored;
  fs::remove(output_, ignored);
}

std::optional<CaseRun::UsedCase> CaseRun::used_case() const {
  const fs::path file = order_.folder / "case.used.toml";
  struct stat entry {};
  if (::stat(file.c_str(), &entry) != 0) return std::nullopt;
  return UsedCase{entry.st_ino, entry.st_mtim.tv_sec, entry.st_mtim.tv_nsec};
}

// The times of files are not compared with the clock, which may be set back meanwhile.
bool CaseRun::has_begun() const {
  const auto now = used_case();
  return now && (order_.existing == Existing::resume || now != before_);
}

std::vector<std::string> CaseRun::arguments() const {
  std::vector<std::string> words{"run", order_.case_file.string(), "--out", order_.folder.string()};
  if (order_.existing == Existing::resume) words.emplace_back("--resume");
  if (order_.existing == Existing::replace) words.emplace_back("--force");
  return words;
}

// The thread that starts a child must live as long: the system kills the child at its end.
void CaseRun::watch() {
  constexpr auto interval = std::chrono::milliseconds(50);
  try {
    ChildProcess child(order_.program, arguments(), output_);
    std::optional<JobEnd> end;
    bool is_told = false;
    while (!(end = child.end())) {
      if (stops_ && !is_told) child.send(SIGTERM);
      is_told = stops_;
      std::this_thread::sleep_for(interval);
    }
    const bool was_stopped = end->signal != 0 || end->exit_code == 128 + SIGTERM;
    state_ = was_stopped ? State::stopped : end->exit_code == 0 ? State::completed : State::failed;
  } catch (const std::exception& error) {
    const std::lock_guard hold(mutex_);
    problem_ = error.what();
    state_ = State::failed;
  }
}

std::string CaseRun::output() const {
  const std::lock_guard hold(mutex_);
  if (!problem_.empty()) return problem_;
  const std::string text = read_file(output_);
  return text.size() > longest_output ? text.substr(text.size() - longest_output) : text;
}

}  // namespace kerf
