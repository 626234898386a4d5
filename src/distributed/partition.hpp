// SPDX-License-Identifier: Apache-2.0
// A partition of space into parts, one for each rank, by recursive coordinate bisection.
#pragma once

#include <array>
#include <memory>
#include <vector>

namespace kerf {

// Work at a point.
struct PointOfWork {
  std::array<double, 3> position;  // m
  float work;                      // 1
};

class Partition {
 public:
  virtual ~Partition() = default;
  // The rank of the part in which a point is; the same at every rank.
  virtual int owner(const std::array<double, 3>& point) const = 0;
};

// Divides the points of all ranks into so many parts that each has about the same work: as many as
// there are ranks, or, for a plan, as there would be. A build with MPI has this function
// (distributed/mpi/).
std::shared_ptr<const Partition> make_partition(const std::vector<PointOfWork>& points,
                                                int dimension, int parts);

}  // namespace kerf
