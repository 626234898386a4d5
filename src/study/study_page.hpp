// SPDX-License-Identifier: Apache-2.0
// study.html: the page of a study, one file that loads nothing. What moves in it is web/src/study/;
// without that it is a table and a plain map.
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

// What the page draws, described in web/README.md: study.json and what it does not say.
nlohmann::ordered_json study_page_data(const StudyPlan& plan, const StudyAnswers& answers,
                                       StudyState state);
std::string study_page(const StudyPlan& plan, const StudyAnswers& answers, StudyState state);

// For readers without the script: the verdicts over two keys, "" where there are none that are
// numbers; and all runs as a table.
std::string static_map(const StudyPlan& plan, const std::vector<RunRow>& runs);
std::string static_table(const StudyPlan& plan, const std::vector<RunRow>& runs);

// The file in the folder of a study, written anew as runs end.
class StudyPageFile {
 public:
  StudyPageFile(const StudyPlan& plan, std::filesystem::path folder)
      : plan_(plan), folder_(std::move(folder)) {}

  // While runs are made: writes the page when runs have ended since, every few seconds at most,
  // with what follows from them.
  void follow(std::size_t ended, std::size_t total, const std::function<StudyAnswers()>& answers);
  void write(const StudyAnswers& answers, StudyState state) const;

 private:
  const StudyPlan& plan_;
  std::filesystem::path folder_;
  std::pair<std::size_t, std::size_t> seen_{};  // ended, total
  std::chrono::steady_clock::time_point written_{};
};

}  // namespace kerf
