// SPDX-License-Identifier: Apache-2.0
// This header declares the maker of cases: it turns a trial into the case that is run.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "core/error.hpp"
#include "study/laboratory.hpp"
#include "study/study_plan.hpp"

namespace kerf {

struct ResolvedCase {
  std::string id;        // depends on the case alone, not on the study's title
  std::string text;      // a complete case, as case.used.toml
  double spacing = 0.0;  // m, the finest of its particles
  double memory = 0.0;   // bytes, estimated
  // The contents of the meshes that the text refers to, by the names of their files.
  std::map<std::string, std::shared_ptr<const std::string>> meshes;
};

class CaseMaker {
 public:
  explicit CaseMaker(const StudyPlan& plan);

  // Throws UserError, which names the study's keys and values, when the case is not valid.
  ResolvedCase make(const Trial& trial) const;

 private:
  std::string title_of(const Setting& setting) const;

  std::string title_;
  std::string study_file_;
  std::string file_name_;  // of the cases: the meshes of the base are found from its folder
  toml::table base_;
  std::vector<Axis> axes_;  // every key that a trial may set
};

// Returns the refusal of a case that a study made: "FILE: with SETTING the case is not valid:" and
// the problems of the case, without the lines of a text that no user wrote.
UserError refused_case(const std::string& study_file, const std::string& setting,
                       const UserError& problems, const std::string& case_name);

// Returns 15 hexadecimal digits of the SHA-1 of a text.
std::string text_id(const std::string& text);

}  // namespace kerf
