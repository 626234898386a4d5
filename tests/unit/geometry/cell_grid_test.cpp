// SPDX-License-Identifier: Apache-2.0
#include "geometry/cell_grid.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace kerf {
namespace {

template <int D>
std::vector<Vector<D, double>> scattered(std::size_t count, std::uint64_t seed) {
  std::vector<Vector<D, double>> points(count);
  for (std::size_t i = 0; i < count; ++i)
    for (int a = 0; a < D; ++a)
      points[i][a] =
          10.0 * random_number(seed, D * i + static_cast<std::uint64_t>(a)) - 5.0 * (a + 1);
  return points;
}

template <int D>
void finds_all_that_are_near() {
  const auto points = scattered<D>(400, 1);
  const double width = 1.3;
  const CellGrid<D> grid(points, width);
  auto places = scattered<D>(60, 2);
  for (auto& place : places) place = 1.2 * place;  // some of them outside
  for (const auto& place : places) {
    std::vector<int> seen(points.size(), 0);
    grid.visit_near(place, [&](std::size_t i) { ++seen[i]; });
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (norm(points[i] - place) < width) {
        EXPECT_EQ(seen[i], 1) << i;
      } else {
        EXPECT_LE(seen[i], 1) << i;
      }
    }
  }
}

TEST(CellGrid, FindsAllPointsThatAreNear) {
  finds_all_that_are_near<2>();
  finds_all_that_are_near<3>();
}

TEST(CellGrid, OfNoPointsIsEmpty) {
  const CellGrid<2> grid({}, 1.0);
  grid.visit_near({0.0, 0.0}, [](std::size_t) { ADD_FAILURE(); });
}

}  // namespace
}  // namespace kerf
