// SPDX-License-Identifier: Apache-2.0
// The validity flags state the limits of a run and of its model. docs/results.md lists them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/metric.hpp"

namespace kerf {

struct RunOutcome;

struct ValidityFlag {
  // good: within its limit; warning: beyond it; note: a limit of the model, for any numbers.
  enum class State { good, note, warning };
  std::string name;
  State state = State::note;
  std::optional<double> value, limit;  // SI; none where a flag has no number
  std::string sentence;

  static const MetricList<ValidityFlag>& metrics();
};

std::string_view word_of(ValidityFlag::State state);

std::vector<ValidityFlag> validity_of(const RunOutcome& outcome);

}  // namespace kerf
