// SPDX-License-Identifier: Apache-2.0
// What to change in a case whose run takes longer than an hour or more than the memory of the
// machine, and what each change gains. Each change is applied to the text of the case, which is
// then read and estimated anew: what is advised is accepted, and its gain is that of the changed
// case.
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "app/run_cost.hpp"
#include "model/case.hpp"

namespace kerf {

// A case as written, as read, and its cost.
struct CostedCase {
  std::string text;
  std::string file;
  Case description;
  DerivedNumbers numbers;
  Pace pace;
};

struct Advice {
  std::vector<std::string> lines;  // keys with their tables, ready to be copied
  std::string text;                // of the changed case
  RunCost before, after;
  std::string condition = {};  // of the time after it, in a clause
  // Places in the list of the advice before it with which it is not accepted.
  std::vector<std::size_t> instead_of;
  // Returns the lines with what they gain.
  std::string sentence() const;
};

inline constexpr double long_run = 3600.0;  // s

// Whether a run takes no more than an hour and the `memory` of the machine, bytes: no advice.
bool is_cheap(const RunCost& cost, double memory);

// Returns the changes that gain anything, and all of them that go together as the last one.
std::vector<Advice> cost_advice(const CostedCase& costed);

// Returns the advice as an indented list, for printing; empty if the case is cheap enough.
// `memory`: what the machine has, bytes.
std::string advice_text(const CostedCase& costed, double memory);

// Throws UserError, with advice, where the run does not fit into the memory of this machine that is
// free; nothing is laid out for that. `costed.pace` is not used. `threads`: of the run.
// `remedy`: how to run it all the same.
void refuse_beyond_memory(CostedCase costed, int threads, const std::string& remedy);

}  // namespace kerf
