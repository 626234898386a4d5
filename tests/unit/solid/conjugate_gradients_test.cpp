// SPDX-License-Identifier: Apache-2.0
// The method of conjugate gradients against systems of known solution.
#include "solid/conjugate_gradients.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace kerf::test {
namespace {

// The second differences of a chain with both ends held, plus `softness`, in blocks of two chains.
struct HeldChains {
  double softness = 0.0;
  mutable int calls = 0;

  Blocks<2> operator()(const Blocks<2>& x) const {
    ++calls;
    Blocks<2> result(x.size());
    for (std::size_t r = 0; r < x.size(); ++r)
      for (std::size_t n = 0; n < 2; ++n)
        result[r][n] = (2.0 + softness) * x[r][n] - (r > 0 ? x[r - 1][n] : 0.0) -
                       (r + 1 < x.size() ? x[r + 1][n] : 0.0);
    return result;
  }
};

Blocks<2> known_chains(std::size_t count) {
  Blocks<2> x(count);
  for (std::size_t r = 0; r < count; ++r) {
    const auto number = static_cast<double>(r);
    x[r] = {std::sin(0.3 * number), 1.0 + 0.1 * number};
  }
  return x;
}

TEST(ConjugateGradients, FindKnownSolutions) {
  const HeldChains chains{0.01};
  const Blocks<2> due = known_chains(40), inverse(40, {1.0 / 2.01, 1.0 / 2.01});
  const Blocks<2> is = conjugate_gradients<2>(chains, chains(due), inverse, 1e-12);
  for (std::size_t r = 0; r < due.size(); ++r)
    for (std::size_t n = 0; n < 2; ++n) EXPECT_NEAR(is[r][n], due[r][n], 1e-10);  // condition 400
}

// A start near the solution saves steps, and is no matter for the solution.
TEST(ConjugateGradients, BeginWhereTheyAreTold) {
  const HeldChains chains{0.01};
  const Blocks<2> due = known_chains(40), inverse(40, {1.0 / 2.01, 1.0 / 2.01});
  const Blocks<2> right = chains(due);
  chains.calls = 0;
  conjugate_gradients<2>(chains, right, inverse, 1e-8);
  const int calls_from_zero = chains.calls;
  Blocks<2> near = due;
  for (auto& block : near) block[0] *= 1.0 + 1e-6;
  chains.calls = 0;
  const Blocks<2> is = conjugate_gradients<2>(chains, right, inverse, 1e-8, near);
  EXPECT_LT(chains.calls, calls_from_zero);
  for (std::size_t r = 0; r < due.size(); ++r)
    for (std::size_t n = 0; n < 2; ++n) EXPECT_NEAR(is[r][n], due[r][n], 1e-5);
}

}  // namespace
}  // namespace kerf::test
