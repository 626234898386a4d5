// SPDX-License-Identifier: Apache-2.0
// Where searches get their answers from: real runs, or in tests functions whose answer is known.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/axis.hpp"

namespace kerf {

// One run of the case.
struct Trial {
  Setting setting;
  int repeat = 0;           // which layout; 0 = the seeds that the case has
  double refinement = 1.0;  // every spacing is divided by it
  bool operator==(const Trial&) const = default;
};

struct Outcome {
  std::string id;  // of the run
  bool failed = false;
  std::string error;                      // why
  std::map<std::string, double> metrics;  // SI, by name: study/metrics.hpp
};

class Laboratory {
 public:
  virtual ~Laboratory() = default;
  // Makes the runs, side by side as far as the machine allows; outcomes in the same order. A run
  // that was made before is not made again.
  virtual std::vector<Outcome> run(const std::vector<Trial>& trials) = 0;
  // How many runs go on at once at most.
  virtual int side_by_side() const = 0;
};

}  // namespace kerf
