// SPDX-License-Identifier: Apache-2.0
// Brackets of a change of verdict along one key.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "study/threshold_search.hpp"

namespace kerf {

// What a verdict is beyond the threshold, at each of some values of the key, side by side.
using Verdicts = std::function<std::vector<bool>(const std::vector<double>& values)>;

class Bisection {
 public:
  // Between the ends of a range, whose verdicts are taken for granted until a bracket ends there.
  // `most` bounds the number of verdicts; parts are equal in ratio when logarithmic.
  Bisection(Verdicts verdicts, Bracket range, int most, bool is_logarithmic = false);

  // Cuts the bracket into side_by_side + 1 equal parts at once, until half of it over its middle is
  // within the tolerance.
  void narrow(double tolerance, int side_by_side);
  // Starts from a bracket that is likely right, which is widened on the side where it is not.
  void start_at(Bracket guess);

  Bracket bracket() const;
  int count() const { return static_cast<int>(known_.size()); }
  bool is_exhausted() const { return count() >= most_; }
  // Whether both ends of the bracket were tried.
  bool is_confirmed() const;
  // The range holds no change: its verdict is the same everywhere, true or false.
  std::optional<bool> same_everywhere() const;

 private:
  void try_values(const std::vector<double>& values);
  bool confirm_ends();
  bool alternates() const;

  Verdicts verdicts_;
  Bracket range_;
  int most_;
  bool is_logarithmic_;
  std::map<double, bool> known_;
};

}  // namespace kerf
