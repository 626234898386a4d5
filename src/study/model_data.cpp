// SPDX-License-Identifier: Apache-2.0
#include "study/study_answers.hpp"

namespace kerf {

const double* find_number(const RunRow& row, const std::string& name) {
  const auto& numbers = row.trial.setting.numbers;
  if (const auto key = numbers.find(name); key != numbers.end()) return &key->second;
  const auto metric = row.metrics.find(name);
  return metric == row.metrics.end() ? nullptr : &metric->second;
}

std::vector<ModelDatum> model_data(const ModelGoal& goal, double refinement,
                                   const std::vector<RunRow>& runs) {
  std::vector<std::string> names = goal.variables;
  if (!goal.drive.empty()) names.push_back(goal.drive);
  std::vector<ModelDatum> data;
  for (const RunRow& row : runs) {
    const auto value = row.metrics.find(goal.metric);
    if (row.state != RunState::done || row.trial.refinement != refinement ||
        value == row.metrics.end())
      continue;
    ModelDatum datum{{}, value->second};
    for (const std::string& name : names)
      if (const double* number = find_number(row, name)) datum.variables[name] = *number;
    if (datum.variables.size() == names.size()) data.push_back(std::move(datum));
  }
  return data;
}

}  // namespace kerf
