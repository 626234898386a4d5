// SPDX-License-Identifier: Apache-2.0
#include "study/slurm_job.hpp"

#include <fmt/format.h>

#include <sstream>

#include "output/files.hpp"
#include "study/child_process.hpp"

namespace kerf {

namespace fs = std::filesystem;

namespace {

std::string script_of(const JobRequest& request, const fs::path& exit_file) {
  std::string command;
  for (const std::string& word : request.command) command += quoted_for_shell(word) + " ";
  command += "> " + quoted_for_shell(request.output.string()) + " 2>&1";
  return with_exit_code(command, quoted_for_shell(exit_file.string()));
}

}  // namespace

SlurmJob::SlurmJob(const JobRequest& request)
    : exit_file_(fs::path(request.output).concat(".exit")) {
  forget_exit_code();
  write_file(request.output, "");
  id_ = submit_to_slurm(request.resources, {fmt::format("--job-name={}", request.name),
                                            "--wrap=" + script_of(request, exit_file_)});
}

std::optional<bool> SlurmJob::is_queued() const {
  const CommandOutput answer = output_of("squeue", {"--me", "--noheader", "--format=%i"});
  complaint_ = answer.errors;
  if (answer.exit_code != 0) return std::nullopt;
  std::istringstream lines(answer.output);
  for (std::string line; std::getline(lines, line);)
    if (line == id_) return true;
  return false;
}

std::optional<int> SlurmJob::exit_code() const {
  return written_exit_code(exit_file_);
}

void SlurmJob::forget_exit_code() const {
  std::error_code ignored;
  fs::remove(exit_file_, ignored);
}

}  // namespace kerf
