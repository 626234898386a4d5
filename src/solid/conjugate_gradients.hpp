// SPDX-License-Identifier: Apache-2.0
// This is the method of conjugate gradients with a diagonal preconditioner (Hestenes & Stiefel, J.
// Res. Natl. Bur. Stand. 49 (1952) 409), for a symmetric positive system of small blocks, on the
// host.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace kerf {

template <std::size_t N>
using Blocks = std::vector<std::array<double, N>>;

// Adds share * blocks to the sum.
template <std::size_t N>
void add_blocks(Blocks<N>& sum, const Blocks<N>& blocks, double share) {
  for (std::size_t r = 0; r < sum.size(); ++r)
    for (std::size_t n = 0; n < N; ++n) sum[r][n] += share * blocks[r][n];
}
template <std::size_t N>
double dot_blocks(const Blocks<N>& a, const Blocks<N>& b) {
  double sum = 0.0;
  for (std::size_t r = 0; r < a.size(); ++r)
    for (std::size_t n = 0; n < N; ++n) sum += a[r][n] * b[r][n];
  return sum;
}

// Returns the x of  apply(x) = right  to `accuracy` of the right side. `inverse`: 1 / the diagonal.
template <std::size_t N, class Apply>
Blocks<N> conjugate_gradients(const Apply& apply, Blocks<N> right, const Blocks<N>& inverse,
                              double accuracy) {
  constexpr int most_iterations = 3000;
  const auto precondition = [&](Blocks<N> blocks) {
    for (std::size_t r = 0; r < blocks.size(); ++r)
      for (std::size_t n = 0; n < N; ++n) blocks[r][n] *= inverse[r][n];
    return blocks;
  };
  Blocks<N>& residual = right;
  Blocks<N> solution(residual.size()), direction = precondition(residual);
  double product = dot_blocks(residual, direction);
  const double enough = accuracy * accuracy * product;
  for (int k = 0; k < most_iterations && product > enough; ++k) {
    const Blocks<N> applied = apply(direction);
    const double step = product / dot_blocks(direction, applied);
    add_blocks(solution, direction, step);
    add_blocks(residual, applied, -step);
    Blocks<N> next = precondition(residual);
    const double next_product = dot_blocks(residual, next);
    add_blocks(next, direction, next_product / product);
    direction = std::move(next);
    product = next_product;
  }
  return solution;
}

}  // namespace kerf
