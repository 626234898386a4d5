// SPDX-License-Identifier: Apache-2.0
// The program as mpirun starts it.
#pragma once

#include <sstream>

#include "faults/program.hpp"

namespace kerf::test {

// Returns the words after mpirun for so many ranks of the program, more than there are cores and as
// any user.
inline std::vector<std::string> words_of_mpirun(int ranks,
                                                const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"--allow-run-as-root", "--oversubscribe", "-n",
                                 std::to_string(ranks), KERF_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

// Returns the process of a rank below that of mpirun; 0 = there is none yet.
inline pid_t process_of_rank(pid_t mpirun, int rank) {
  const std::string wanted = "OMPI_COMM_WORLD_RANK=" + std::to_string(rank);
  const std::string children =
      "/proc/" + std::to_string(mpirun) + "/task/" + std::to_string(mpirun) + "/children";
  std::istringstream list(read_file(children));
  for (pid_t child = 0; list >> child;) {
    std::string word;
    std::istringstream words(read_file("/proc/" + std::to_string(child) + "/environ"));
    while (std::getline(words, word, '\0'))
      if (word == wanted) return child;
  }
  return 0;
}

}  // namespace kerf::test
