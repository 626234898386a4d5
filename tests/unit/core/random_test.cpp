// SPDX-License-Identifier: Apache-2.0
#include "core/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace kerf {
namespace {

// The first numbers of the published generator with the seed 1234567 (S. Vigna's splitmix64.c, as
// Rosetta Code lists them).
TEST(Random, EqualsSplitMix64) {
  const std::uint64_t published[] = {6457827717110365317u, 3203168211198807973u,
                                     9817491932198370423u, 4593380528125082431u,
                                     16408922859458223821u};
  for (std::uint64_t n = 0; n < 5; ++n) EXPECT_EQ(random_bits(1234567, n), published[n]);
}

// The mean is 1/2 and the variance 1/12, within four standard errors of 10^5 numbers; neighbours
// are uncorrelated.
TEST(Random, NumbersAreUniform) {
  constexpr int count = 100000;
  double sum = 0.0, square = 0.0, product = 0.0, last = 0.5;
  for (std::uint64_t n = 0; n < count; ++n) {
    const double x = random_number(7, n) - 0.5;
    ASSERT_GT(x, -0.5);
    ASSERT_LT(x, 0.5);
    sum += x;
    square += x * x;
    product += n > 0 ? x * last : 0.0;
    last = x;
  }
  const double error = 4.0 / std::sqrt(static_cast<double>(count));
  EXPECT_NEAR(sum / count, 0.0, error * std::sqrt(1.0 / 12.0));
  EXPECT_NEAR(square / count, 1.0 / 12.0, error * std::sqrt(1.0 / 180.0));
  EXPECT_NEAR(product / count, 0.0, error / 12.0);
}

}  // namespace
}  // namespace kerf
