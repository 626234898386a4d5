// SPDX-License-Identifier: Apache-2.0
#include "study/slurm_array.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "core/error.hpp"
#include "input/schema.hpp"
#include "output/files.hpp"
#include "study/case_maker.hpp"
#include "study/child_process.hpp"

namespace kerf {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_array = 1000;  // Slurm's default MaxArraySize is 1001

std::string script_of(const fs::path& study_folder, const fs::path& list,
                      const ArrayRequest& request) {
  std::string program;
  for (const std::string& word : start_words(request.resources, request.program))
    program += quoted_for_shell(word) + " ";
  const std::string start = fmt::format(
      R"(#!/bin/sh
# Made by kerf study: each task is one run of the list.
cd {} || exit 1
exec > "slurm/${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID.txt" 2>&1
id=$(sed -n "$((SLURM_ARRAY_TASK_ID + 1))p" {})
{}run "runs/$id.toml" --out "runs/$id" --threads "${{SLURM_CPUS_PER_TASK:-1}}" --device {} --resume \
  > "runs/$id.txt" 2>&1)",
      quoted_for_shell(study_folder.string()), quoted_for_shell(list.string()), program,
      request.resources.device);
  return with_exit_code(start, "\"slurm/$id.exit\"");
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

SlurmArrays::SlurmArrays(fs::path study_folder)
    : study_folder_(std::move(study_folder)),
      folder_(study_folder_ / "slurm"),
      name_(fmt::format("kerf-{}-", text_id(study_folder_.string()))) {
  make_folder(folder_);
}

int SlurmArrays::next_number() const {
  int number = 0;
  for (const auto& entry : fs::directory_iterator(folder_))
    if (entry.path().extension() == ".list")
      number = std::max(number, std::atoi(entry.path().stem().c_str()));
  return number + 1;
}

void SlurmArrays::submit(const std::vector<std::string>& ids, const ArrayRequest& request) {
  for (std::size_t first = 0; first < ids.size(); first += longest_array) {
    const std::size_t last = std::min(first + longest_array, ids.size());
    submit_one({ids.begin() + static_cast<std::ptrdiff_t>(first),
                ids.begin() + static_cast<std::ptrdiff_t>(last)},
               request);
  }
}

// The list is written before the array is submitted, so that every queued task is found in a list.
void SlurmArrays::submit_one(const std::vector<std::string>& ids, const ArrayRequest& request) {
  for (const std::string& id : ids) forget_exit_code(id);
  const int number = next_number();
  const fs::path list = folder_ / fmt::format("{}.list", number);
  const fs::path script = folder_ / fmt::format("{}.sh", number);
  write_file(list, fmt::format("{}\n", fmt::join(ids, "\n")));
  write_file(script, script_of(study_folder_, list, request));
  submit_to_slurm(
      request.resources,
      {fmt::format("--job-name={}{}", name_, number),
       fmt::format("--array=0-{}%{}", ids.size() - 1, request.at_once), script.string()});
}

std::optional<std::map<std::string, bool>> SlurmArrays::in_queue() const {
  const CommandOutput answer =
      output_of("squeue", {"--me", "--array", "--noheader", "--format=%i %j %t"});
  complaint_ = answer.errors;
  if (answer.exit_code != 0) return std::nullopt;
  std::map<std::string, bool> runs;
  for (const std::string& line : lines_of(answer.output)) {
    const auto words = split_words(line);  // "12_3 kerf-...-1 R"
    if (words.size() != 3 || !words[1].starts_with(name_)) continue;
    const auto mark = words[0].find('_');
    const fs::path list = folder_ / (words[1].substr(name_.size()) + ".list");
    if (mark == std::string::npos || !fs::exists(list)) continue;
    const auto ids = lines_of(read_file(list));
    const auto task = static_cast<std::size_t>(std::atol(words[0].c_str() + mark + 1));
    if (task < ids.size()) runs[ids[task]] = words[2] != "PD";
  }
  return runs;
}

std::optional<int> SlurmArrays::exit_code(const std::string& id) const {
  return written_exit_code(folder_ / (id + ".exit"));
}

void SlurmArrays::forget_exit_code(const std::string& id) const {
  std::error_code ignored;
  fs::remove(folder_ / (id + ".exit"), ignored);
}

}  // namespace kerf
