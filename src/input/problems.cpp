// SPDX-License-Identifier: Apache-2.0
#include "input/problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace kerf {

namespace {

constexpr std::size_t most_shown = 10;

// Returns the optimal string alignment distance: the number of insertions, deletions, substitutions
// and swaps of neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, substituted});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        now[j] = std::min(now[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(now);
  }
  return last[b.size()];
}

}  // namespace

void Problems::mention(const std::string& key, int line, std::string value) {
  if (line > 0 || !is_written(key)) mentions_[key] = {line, std::move(value)};
}

int Problems::line_of(std::string key) const {
  while (!key.empty()) {
    const auto found = mentions_.find(key);
    if (found != mentions_.end() && found->second.line > 0) return found->second.line;
    const auto cut = key.find_last_of(".[");
    key.resize(cut == std::string::npos ? 0 : cut);
  }
  return 1;
}

void Problems::add(Problem problem) {
  const auto mention = mentions_.find(problem.key);
  const int line = line_of(problem.key);
  found_.push_back({std::move(problem), line,
                    mention == mentions_.end() ? std::string() : mention->second.value});
}

bool Problems::is_written(const std::string& key) const {
  const auto mention = mentions_.find(key);
  return mention != mentions_.end() && mention->second.line > 0;
}

bool Problems::concern(const std::string& key) const {
  return std::any_of(found_.begin(), found_.end(),
                     [&](const FoundProblem& problem) { return problem.key == key; });
}

std::string Problems::message_of(const FoundProblem& problem) const {
  const bool written = !problem.value.empty();
  std::string message = fmt::format("{}:{}: {}{}{}: {}.", file_name_, problem.line, problem.key,
                                    written ? " = " : "", problem.value, problem.what);
  if (!problem.allowed.empty()) message += fmt::format(" Allowed: {}.", problem.allowed);
  if (!problem.remedy.empty())
    message += fmt::format(" {}{}", problem.remedy, problem.remedy.ends_with('?') ? "" : ".");
  // A quoted key of a TOML file may have any characters; a message is one line.
  for (char& c : message)
    if (static_cast<unsigned char>(c) < ' ') c = '?';
  return message;
}

void Problems::throw_if_any() const {
  if (found_.empty()) return;
  const std::size_t shown = std::min(found_.size(), most_shown);
  std::string text = message_of(found_.front());
  for (std::size_t i = 1; i < shown; ++i) text += fmt::format("\n{}", message_of(found_[i]));
  if (found_.size() > shown) text += fmt::format("\n... and {} more", found_.size() - shown);
  throw CaseError(text, found_);
}

std::string closest(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest_key = 64;  // longer words are not compared with keys
  std::string best;
  if (word.size() > longest_key) return best;
  std::size_t best_distance = 1 + std::max<std::size_t>(2, word.size() / 3);
  for (const auto& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= best_distance || distance >= candidate.size()) continue;
    best_distance = distance;
    best = candidate;
  }
  return best;
}

}  // namespace kerf
