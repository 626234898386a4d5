// SPDX-License-Identifier: Apache-2.0
// A run of several ranks (parallel/ranks.hpp): rank 0 leads it, and every other rank follows, by
// calling the same functions of its own part of the run. So the loop of a run, its output and its
// decisions are those of a run of one rank. A build with MPI has these functions (engine/mpi/).
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "simulation/simulation.hpp"

namespace kerf {

// Throws UserError (exit_bad_input), the same at every rank, if a case has what several ranks
// cannot compute. `asked`: what wants them, "mpirun with 2 ranks"; `remedy`: a sentence.
void refuse_undistributed(const Case& description, const std::string& asked,
                          const std::string& remedy);

// Does the work at every rank. What it throws at one of them is thrown at all: the UserError of the
// lowest rank.
void at_all_ranks(const std::function<void()>& work);

// Makes at rank 0 the run that all ranks compute.
std::unique_ptr<Simulation> make_led(const Case& description);

// The others follow rank 0 through the runs of a case as long as such an object lives there.
class Lead {
 public:
  Lead() = default;
  ~Lead();
  Lead(const Lead&) = delete;
  Lead& operator=(const Lead&) = delete;
};
void follow(const Case& description);

}  // namespace kerf
