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
// `start`: where the search for x begins; empty: at 0.
template <std::size_t N, class Apply>
Blocks<N> conjugate_gradients(const Apply& apply, Blocks<N> right, const Blocks<N>& inverse,
                              double accuracy, Blocks<N> start = {}) {
  constexpr int most_iterations = 3000;
  const auto precondition = [&](Blocks<N> blocks) {
    for (std::size_t r = 0; r < blocks.size(); ++r)
      for (std::size_t n = 0; n < N; ++n) blocks[r][n] *= inverse[r][n];
    return blocks;
  };
  const double enough = accuracy * accuracy * dot_blocks(right, precondition(right));
  Blocks<N>& residual = right;
  Blocks<N> solution(residual.size());
  if (!start.empty()) {
    solution = std::move(start);
    add_blocks(residual, apply(solution), -1.0);
  }
  Blocks<N> direction = precondition(residual);
  double product = dot_blocks(residual, direction);
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
