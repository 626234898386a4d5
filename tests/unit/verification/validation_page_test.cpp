// SPDX-License-Identifier: Apache-2.0
// The page of `kerf verify` has every row and figure of the plans in the program, which are valid.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "app/embedded.hpp"
#include "model/case.hpp"
#include "verification/signal.hpp"
#include "verification/verify.hpp"

namespace kerf {
namespace {

std::string read_text(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// The plans in the program.
std::vector<VerificationCase> shipped() {
  return read_verification_cases(validation_texts(), case_templates());
}

TEST(ValidationPage, ListsTheCasesOfTheProgramAndNoOthers) {
  const std::string page = read_text(KERF_SOURCE_DIR "/docs/validation.md");
  std::set<std::string> listed, known;
  const std::regex heading("^### `([^`]+)`");
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    std::smatch found;
    if (std::regex_search(line, found, heading)) listed.insert(found[1]);
  }
  for (const VerificationCase& entry : shipped()) known.insert(entry.name);
  EXPECT_FALSE(known.empty());
  EXPECT_EQ(listed, known);
}

// Returns the beginnings of the rows of a check without long runs.
std::vector<std::string> short_rows(const VerificationCase& entry, const Check& check) {
  std::vector<std::string> runs;
  for (const std::string& run : check.runs)
    if (!entry.run(run).is_long) runs.push_back(run);
  if (check.of_mean && !runs.empty()) runs = {fmt::format("mean of {} runs", runs.size())};
  std::vector<std::string> rows;
  for (const std::string& run : runs)
    rows.push_back("| " + check.quantity + " | " + run + (check.of_mean ? "" : " |"));
  return rows;
}

TEST(ValidationPage, HasEveryQuantityAndShortRun) {
  const std::string page = read_text(KERF_SOURCE_DIR "/docs/validation.md");
  for (const VerificationCase& entry : shipped())
    for (const Check& check : entry.checks)
      for (const std::string& row : short_rows(entry, check))
        EXPECT_NE(page.find(row), std::string::npos)
            << entry.name << ": " << row << " is not in docs/validation.md; run "
            << "kerf verify --page docs/validation.md";
}

TEST(ValidationPage, ShowsEveryFigureOfItsFolder) {
  const std::string page = read_text(KERF_SOURCE_DIR "/docs/validation.md");
  std::set<std::string> shown, there;
  const std::regex image(R"(\]\(images/validation/([^)]+)\))");
  for (std::sregex_iterator at(page.begin(), page.end(), image), end; at != end; ++at)
    shown.insert((*at)[1]);
  for (const auto& entry :
       std::filesystem::directory_iterator(KERF_SOURCE_DIR "/docs/images/validation"))
    there.insert(entry.path().filename().string());
  EXPECT_FALSE(shown.empty());
  EXPECT_EQ(shown, there);
}

TEST(ValidationPage, NamesEverySignal) {
  const std::string page = read_text(KERF_SOURCE_DIR "/docs/validation.md");
  for (const auto& [name, maker] : signal_makers())
    EXPECT_NE(page.find("| `" + name + "` |"), std::string::npos) << name;
}

TEST(ShippedPlans, EveryRunIsAValidCase) {
  for (const VerificationCase& entry : shipped())
    for (const PlannedRun& run : entry.runs)
      EXPECT_NO_THROW(run.description()) << entry.name << ", " << run.name;
}

TEST(ShippedPlans, EveryCaseHasChecks) {
  for (const VerificationCase& entry : shipped()) {
    int judged = 0;
    for (const Check& check : entry.checks) judged += check.is_judged() ? 1 : 0;
    EXPECT_GT(judged, 0) << entry.name;
  }
}

}  // namespace
}  // namespace kerf
