// SPDX-License-Identifier: Apache-2.0
// This header declares what all submissions to Slurm share.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace kerf {

struct SlurmResources {
  int cores = 1;               // of each rank
  double memory = 0.0;         // bytes, of each rank, as estimated for a run of one
  std::string device = "cpu";  // of kerf run; "gpu" requests one GPU
  int ranks = 1;               // of each run (docs/mpi.md)
};

// Returns the words with which a job starts its ranks, or the program itself where it has one.
std::vector<std::string> start_words(const SlurmResources& resources,
                                     const std::filesystem::path& program);

// Returns a text as one word of a shell, whatever it holds.
std::string quoted_for_shell(const std::string& text);

// Returns lines of a shell that run a command and write its exit code to a file; both are text of
// the shell. A job that is cancelled or loses its node is ended by a signal together with its
// shell: it leaves no exit code.
std::string with_exit_code(const std::string& command, const std::string& file);
// Returns the exit code that such lines have written; nothing where they have not.
std::optional<int> written_exit_code(const std::filesystem::path& file);

// Polls in a row without an answer of Slurm before it is given up, and polls that miss a job before
// it is lost: files may be late.
inline constexpr int most_silences = 60, most_missing_polls = 2;

// Calls sbatch with a request for the resources and further words, and returns the number of the
// job. What the job prints is dropped, as Slurm would expand % and \ in the name of its file: the
// script must redirect it. Throws UserError with the message of sbatch.
std::string submit_to_slurm(const SlurmResources& resources, const std::vector<std::string>& words);

}  // namespace kerf
