// SPDX-License-Identifier: Apache-2.0
// This header declares the laboratory, from which searches get outcomes: real runs, or in tests
// functions whose answer is known.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/axis.hpp"

namespace kerf {

// One run of the case.
struct Trial {
  Setting setting;
  int repeat = 0;           // number of the layout; 0 = the seeds of the case
  double refinement = 1.0;  // divides every spacing
  bool operator==(const Trial&) const = default;
};

struct Outcome {
  std::string id;  // of the run
  bool failed = false;
  std::string error;                      // why it failed
  std::map<std::string, double> metrics;  // SI, by name (study/metrics.hpp)
};

class Laboratory {
 public:
  virtual ~Laboratory() = default;
  // Makes the runs, several at the same time, and returns their outcomes in the same order. A run
  // that exists is not repeated.
  virtual std::vector<Outcome> run(const std::vector<Trial>& trials) = 0;
  // Returns how many runs are made at the same time at most.
  virtual int side_by_side() const = 0;
};

}  // namespace kerf
