// SPDX-License-Identifier: Apache-2.0
#include "fluid/lattice_sums.hpp"

#include <gtest/gtest.h>

#include "kernels/wendland_c2.hpp"

namespace kerf::test::lattice_sums_test {
namespace {

// For many neighbours the sums approach the integrals, which are 1.
TEST(LatticeSums, ApproachTheIntegrals) {
  const LatticeSums plane = lattice_sums<2, WendlandC2<2>>(4.0);
  EXPECT_NEAR(plane.kernel_sum, 1.0, 1e-3);
  EXPECT_NEAR(plane.slope, 1.0, 1e-3);
  const LatticeSums space = lattice_sums<3, WendlandC2<3>>(4.0);
  EXPECT_NEAR(space.kernel_sum, 1.0, 1e-3);
  EXPECT_NEAR(space.slope, 1.0, 1e-3);
}

// The reference is an explicit sum over the nodes of the square lattice.
TEST(LatticeSums, AtTheUsualRatioInThePlane) {
  const LatticeSums sums = lattice_sums<2, WendlandC2<2>>(1.3);
  EXPECT_NEAR(sums.kernel_sum, 1.0105, 5e-5);
  EXPECT_NEAR(sums.slope, 0.9739, 5e-5);
}

// The slope is the decrease of the kernel sum when the lattice expands: d kernel_sum / d ln spacing
// = - D slope.
TEST(LatticeSums, SlopeIsTheDerivativeOfTheKernelSum) {
  const double ratio = 1.3, step = 1e-5;
  // Spacing 1 + s at the same h, with the weight of a particle kept: (1 + s)^-D at h / (1 + s).
  const auto kernel_sum = [&](double s) {
    return lattice_sums<2, WendlandC2<2>>(ratio / (1.0 + s)).kernel_sum / ((1.0 + s) * (1.0 + s));
  };
  const double loss = (kernel_sum(step) - kernel_sum(-step)) / (2.0 * step);
  const LatticeSums sums = lattice_sums<2, WendlandC2<2>>(ratio);
  EXPECT_NEAR(-loss / 2.0, sums.slope, 1e-6);
}

}  // namespace
}  // namespace kerf::test::lattice_sums_test
