// SPDX-License-Identifier: Apache-2.0
// The distance between a field and the field of an oracle.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace kerf::test {

// Returns the largest error of a field over the largest value of the field.
struct Gap {
  double error = 0.0, scale = 0.0;
  void add(double value, double due) {
    error = std::max(error, std::abs(value - due));
    scale = std::max(scale, std::abs(due));
  }
  void add(const Eigen::Vector3d& value, const Eigen::Vector3d& due) {
    error = std::max(error, (value - due).norm());
    scale = std::max(scale, due.norm());
  }
};

}  // namespace kerf::test
