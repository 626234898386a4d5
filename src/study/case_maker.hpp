// SPDX-License-Identifier: Apache-2.0
// From a trial to the case that runs.
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "case/case.hpp"
#include "study/laboratory.hpp"
#include "study/study_plan.hpp"

namespace kerf {

struct ResolvedCase {
  std::string id;        // the same for the same text, whatever the study's title
  std::string text;      // a complete case, as case.used.toml
  double spacing = 0.0;  // m, the finest of its particles
  double memory = 0.0;   // bytes, estimate
};

class CaseMaker {
 public:
  explicit CaseMaker(const StudyPlan& plan);

  // Throws UserError, which names the study's keys and values, when the case is not good.
  ResolvedCase make(const Trial& trial) const;

 private:
  std::string title_of(const Setting& setting) const;

  std::string title_;
  std::string file_name_;
  toml::table base_;
  std::vector<Axis> axes_;  // every key that a trial may set
};

// 15 hexadecimal digits of the SHA-1 of a text.
std::string text_id(const std::string& text);

}  // namespace kerf
