// SPDX-License-Identifier: Apache-2.0
// Blocks of total Lagrangian solid with a jump of the spacing.
#pragma once

#include "support/solid_blocks.hpp"

namespace kerf::test {

// `cells`: coarse cells, 2 spacings wide; cells with is_coarse(middle) are not refined.
template <int D, class IsCoarse>
SolidLayout<D> graded_block(const BlockChoice& choice, const Medium<double>& fine,
                            const IsCoarse& is_coarse) {
  SolidLayout<D> layout;
  auto coarse = fine;
  coarse.spacing *= 2.0;
  coarse.smoothing_length *= 2.0;
  coarse.mass *= std::pow(2.0, D);
  layout.media = {fine, coarse};
  layout.body = {0, 0};
  const auto whole = block<D>({choice.cells, 2.0 * choice.spacing}, coarse);
  for (const auto& middle : whole.reference) {
    if (is_coarse(middle)) {
      layout.reference.push_back(middle);
      layout.medium_index.push_back(1);
      continue;
    }
    for (int k = 0; k < 1 << D; ++k) {
      auto x = middle;
      for (int a = 0; a < D; ++a) x[a] += ((k >> a & 1) - 0.5) * choice.spacing;
      layout.reference.push_back(x);
      layout.medium_index.push_back(0);
    }
  }
  return layout;
}

template <int D>
SolidLayout<D> graded_block(const BlockChoice& choice) {
  return graded_block<D>(choice, soft_solid(choice.spacing, D),
                         [&](const Vector<D, double>& middle) {
                           return middle[0] > choice.spacing * choice.cells[0];
                         });
}

}  // namespace kerf::test
