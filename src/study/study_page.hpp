// SPDX-License-Identifier: Apache-2.0
// This header declares study.html, the page of a study: one file that loads nothing. Its script is
// web/src/study/; without the script it shows a table and a plain map.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "study/study_answers.hpp"

namespace kerf {

enum class StudyState { running, stopped, ended };

// Returns the data of the page's script, which web/README.md describes: study.json and what it does
// not contain.
nlohmann::ordered_json study_page_data(const StudyPlan& plan, const StudyAnswers& answers,
                                       StudyState state);
std::string study_page(const StudyPlan& plan, const StudyAnswers& answers, StudyState state);

// Return the page's content without the script: a plot of the verdicts over the first two keys that
// have numbers ("" where there are fewer), and a table of all runs.
std::string static_map(const StudyPlan& plan, const std::vector<RunRow>& runs);
std::string static_table(const StudyPlan& plan, const std::vector<RunRow>& runs);

// The file in the folder of a study, which is rewritten as runs end.
class StudyPageFile {
 public:
  StudyPageFile(const StudyPlan& plan, std::filesystem::path folder)
      : plan_(plan), folder_(std::move(folder)) {}

  // Rewrites the page while runs are made, when runs have ended since the last call that wrote it
  // and a few seconds have passed.
  void follow(std::size_t ended, std::size_t total, const std::function<StudyAnswers()>& answers);
  void write(const StudyAnswers& answers, StudyState state) const;

 private:
  const StudyPlan& plan_;
  std::filesystem::path folder_;
  std::pair<std::size_t, std::size_t> seen_{};  // ended, total
  std::chrono::steady_clock::time_point written_{};
};

}  // namespace kerf
