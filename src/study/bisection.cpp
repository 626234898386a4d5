// SPDX-License-Identifier: Apache-2.0
#include "study/bisection.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kerf {

DecidedEnds decided_ends(const std::map<double, bool>& verdicts) {
  DecidedEnds ends;
  for (const auto& [value, is_beyond] : verdicts) {
    if (is_beyond) break;
    ends.low = value;
  }
  for (auto entry = verdicts.rbegin(); entry != verdicts.rend() && entry->second; ++entry)
    ends.high = entry->first;
  return ends;
}

Bisection::Bisection(Verdicts verdicts, Bracket range, int most, bool is_logarithmic)
    : verdicts_(std::move(verdicts)), range_(range), most_(most), is_logarithmic_(is_logarithmic) {}

// An end that no run decides is one of the range.
Bracket Bisection::bracket() const {
  const DecidedEnds ends = decided_ends(known_);
  return {ends.low.value_or(range_.low), ends.high.value_or(range_.high)};
}

bool Bisection::is_confirmed() const {
  const Bracket now = bracket();
  return known_.count(now.low) > 0 && known_.count(now.high) > 0;
}

std::optional<bool> Bisection::same_everywhere() const {
  const auto low = known_.find(range_.low), high = known_.find(range_.high);
  if (low != known_.end() && low->second) return true;
  if (high != known_.end() && !high->second) return false;
  return std::nullopt;
}

void Bisection::try_values(const std::vector<double>& values) {
  std::vector<double> missing;
  for (const double value : values)
    if (known_.count(value) == 0 && count() + static_cast<int>(missing.size()) < most_)
      missing.push_back(value);
  if (missing.empty()) return;
  const std::vector<bool> found = verdicts_(missing);
  for (std::size_t i = 0; i < missing.size(); ++i) known_[missing[i]] = found[i];
}

bool Bisection::alternates() const {
  const Bracket now = bracket();
  const auto inner = known_.upper_bound(now.low);
  return inner != known_.end() && inner->first < now.high;
}

void Bisection::narrow(double tolerance, int side_by_side) {
  const int parts = std::max(1, side_by_side) + 1;
  while (!is_exhausted()) {
    const Bracket now = bracket();
    const bool is_narrow = now.half_width() <= tolerance * std::abs(now.middle());
    if ((is_narrow || alternates()) && !confirm_ends()) return;
    if (is_narrow || alternates()) continue;
    std::vector<double> values;
    for (int i = 1; i < parts; ++i)
      values.push_back(between(now.low, now.high, static_cast<double>(i) / parts, is_logarithmic_));
    try_values(values);
  }
}

// Runs the ends of the bracket that were assumed; returns false if there was none.
bool Bisection::confirm_ends() {
  if (is_confirmed() || same_everywhere()) return false;
  const Bracket now = bracket();
  const int before = count();
  try_values({now.low, now.high});
  return count() > before;
}

void Bisection::start_at(Bracket guess) {
  try_values({guess.low, guess.high});
  double step = guess.high - guess.low;
  while (!is_exhausted() && !same_everywhere()) {
    const Bracket now = bracket();
    const bool is_low_open = known_.count(now.low) == 0, is_high_open = known_.count(now.high) == 0;
    if (!is_low_open && !is_high_open) return;
    if (is_low_open) try_values({std::max(range_.low, known_.begin()->first - step)});
    if (is_high_open) try_values({std::min(range_.high, known_.rbegin()->first + step)});
    step *= 2.0;
  }
}

void Bisection::leave(double start) {
  constexpr double factor = 2.0;
  try_values({start});
  while (!is_exhausted() && !is_confirmed() && !same_everywhere()) {
    const bool is_low_open = known_.count(bracket().low) == 0;
    try_values({is_low_open ? std::max(range_.low, known_.begin()->first / factor)
                            : std::min(range_.high, known_.rbegin()->first * factor)});
  }
}

}  // namespace kerf
