// SPDX-License-Identifier: Apache-2.0
// This header declares the laboratory of a limit: it sets the end of each run and tells its
// outcome.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/limit_plan.hpp"

namespace kerf {

class LimitRuns : public Laboratory {
 public:
  // Is called after each round of runs with their names, each name once.
  using Tell = std::function<void(const std::vector<std::string>& ids, const Trial& last)>;

  LimitRuns(const LimitPlan& plan, Laboratory& runs, Tell tell)
      : plan_(plan), runs_(runs), tell_(std::move(tell)) {}

  std::vector<Outcome> run(const std::vector<Trial>& trials) override {
    std::vector<Trial> ended;
    for (const Trial& trial : trials) ended.push_back(with_end(plan_, trial));
    std::vector<Outcome> outcomes = runs_.run(ended);
    std::vector<std::string> ids;
    for (const Outcome& outcome : outcomes) ids.push_back(outcome.id);
    if (!ended.empty()) tell_(ids, ended.back());
    return outcomes;
  }
  int side_by_side() const override { return runs_.side_by_side(); }

 private:
  const LimitPlan& plan_;
  Laboratory& runs_;
  Tell tell_;
};

}  // namespace kerf
