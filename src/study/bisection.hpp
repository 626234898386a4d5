// SPDX-License-Identifier: Apache-2.0
// This header declares the bisection of a range: it brackets the value at which a verdict changes.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "study/searches.hpp"

namespace kerf {

// Returns for each value of the key, all of them run at once, whether it lies beyond the threshold.
using Verdicts = std::function<std::vector<bool>(const std::vector<double>& values)>;

// The ends of a bracket that verdicts decide: the highest value up to which every verdict is false,
// and the lowest one from which every verdict is true.
struct DecidedEnds {
  std::optional<double> low, high;
};
DecidedEnds decided_ends(const std::map<double, bool>& verdicts);

class Bisection {
 public:
  // The verdicts at the ends of the range are assumed until a bracket ends there. `most` limits the
  // number of verdicts; parts have equal ratios if logarithmic.
  Bisection(Verdicts verdicts, Bracket range, int most, bool is_logarithmic = false);

  // Divides the bracket into side_by_side + 1 equal parts, until its half-width over its middle is
  // within the tolerance.
  void narrow(double tolerance, int side_by_side);
  // Starts from a probable bracket, which is widened on the side where it proves wrong.
  void start_at(Bracket guess);

  // Starts from one value, which is left by factors of 2 on the side of the threshold until the
  // verdict changes or an end of the range is reached. The range lies above 0.
  void leave(double start);

  Bracket bracket() const;
  int count() const { return static_cast<int>(known_.size()); }
  bool is_exhausted() const { return count() >= most_; }
  // Returns whether a value within the bracket was run: the verdicts change more than once.
  bool alternates() const;
  // Returns whether both ends of the bracket were run.
  bool is_confirmed() const;
  // Returns the verdict if it is the same at both ends of the range, nothing if it changes.
  std::optional<bool> same_everywhere() const;

 private:
  void try_values(const std::vector<double>& values);
  bool confirm_ends();

  Verdicts verdicts_;
  Bracket range_;
  int most_;
  bool is_logarithmic_;
  std::map<double, bool> known_;
};

}  // namespace kerf
