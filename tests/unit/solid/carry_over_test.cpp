// SPDX-License-Identifier: Apache-2.0
// The state of a window of a block carried over to the next window: what is in both keeps its
// bonds and state, what is new is bonded, and the window responds as the long block does.
#include "solid/carry_over.hpp"

#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

// A slit across both windows, from the surface to the middle.
struct SlitInBothWindows {
  template <class Point>
  KERF_FUNCTION bool operator()(const Point& x, const Point& y) const {
    return (x[0] < 9e-3) != (y[0] < 9e-3) && x[1] > 4e-3 && y[1] > 4e-3;
  }
};

SolidLayout<2> window_of(const SolidLayout<2>& whole, double low, double high) {
  SolidLayout<2> part;
  part.media = whole.media;
  for (const auto& x : whole.reference)
    if (x[0] > low && x[0] < high) {
      part.reference.push_back(x);
      part.medium_index.push_back(0);
    }
  return part;
}

std::vector<Index> places_in(const SolidLayout<2>& of, const SolidLayout<2>& in) {
  std::vector<Index> numbers;
  for (const auto& x : of.reference) {
    const auto found = std::find_if(in.reference.begin(), in.reference.end(),
                                    [&](const auto& y) { return x[0] == y[0] && x[1] == y[1]; });
    numbers.push_back(found == in.reference.end()
                          ? not_carried
                          : static_cast<Index>(found - in.reference.begin()));
  }
  return numbers;
}

TEST(CarryOver, WindowRespondsAsTheLongBlock) {
  auto medium = soft_solid(1e-3, 2);
  medium.criterion = BondCriterion::principal_strain;
  medium.failure_strain = 1.0;
  const auto whole = block<2>({.cells = {24, 8, 1}, .jitter = 0.1}, medium);
  const auto first = window_of(whole, 0.0, 14e-3), next = window_of(whole, 4e-3, 18e-3);
  TotalLagrangian<2, Double> block_solid(whole), before(first), now(next);
  block_solid.cut(SlitInBothWindows{});
  before.cut(SlitInBothWindows{});
  const auto earlier = places_in(next, first);
  EXPECT_GT(std::count(earlier.begin(), earlier.end(), not_carried), 8);
  auto marked = before.save();
  for (std::size_t s = 0; s < marked.elastic_share.size(); ++s)
    marked.elastic_share[s] = 1.0 - 1e-3 * static_cast<double>(s % 7);
  before.restore(marked);
  const auto state = carry_over(before, now, earlier);
  now.restore(state);
  for (std::size_t s = 0; s < earlier.size(); ++s)
    EXPECT_EQ(state.elastic_share[s],
              earlier[s] == not_carried ? 1.0 : marked.elastic_share[earlier[s]]);

  // The same bonds are intact as in the long block.
  const auto in_block = places_in(next, whole);
  const auto window_view = now.view(), block_view = block_solid.view();
  for (Index s = 0; s < now.size(); ++s)
    for (Index k = window_view.bonds.first(s); k < window_view.bonds.last(s); ++k) {
      const Index other = in_block[window_view.bond_end(s, k).particle];
      const Index bond = bond_between(block_view.bonds, in_block[s], other);
      ASSERT_NE(bond, no_bond);
      EXPECT_EQ(window_view.is_intact(s, k), block_view.is_intact(in_block[s], bond));
    }

  // The gradients of a quadratic motion are those of the long block away from the ends.
  const auto moved = [](const SolidLayout<2>& layout) {
    std::vector<Vector<2, double>> positions;
    for (auto x : layout.reference) {
      x[0] += 0.02 * x[1] + 3.0 * x[0] * x[0];
      positions.push_back(x);
    }
    Array<Vector<2, double>> result;
    to_device(positions, result);
    return result;
  };
  block_solid.deform(moved(whole));
  now.deform(moved(next));
  const auto of_window = to_host(now.fields().gradient);
  const auto of_block = to_host(block_solid.fields().gradient);
  std::size_t compared = 0;
  for (std::size_t s = 0; s < of_window.size(); ++s) {
    const double x = next.reference[s][0];
    if (x < 7.5e-3 || x > 14.5e-3) continue;  // bonds reach 2.6 mm
    ++compared;
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        EXPECT_NEAR(of_window[s](a, b), of_block[in_block[s]](a, b), 1e-13);
  }
  EXPECT_GT(compared, 40u);
}

// Nothing is bonded to a particle that has lost all its bonds.
TEST(CarryOver, NewSolidIsNotBondedToDetachedParticles) {
  auto medium = soft_solid(1e-3, 2);
  medium.criterion = BondCriterion::principal_strain;
  medium.failure_strain = 1.0;
  const auto whole = block<2>({.cells = {16, 6, 1}}, medium);
  const auto first = window_of(whole, 0.0, 10e-3), next = window_of(whole, 2e-3, 12e-3);
  TotalLagrangian<2, Double> before(first), now(next);
  std::vector<std::uint8_t> chosen(first.reference.size(), 0);
  std::size_t lost = 0;
  for (std::size_t s = 0; s < chosen.size(); ++s)
    if (first.reference[s][0] > 9e-3 && first.reference[s][1] > 5e-3) chosen[lost = s] = 1;
  Array<std::uint8_t> on_device;
  to_device(chosen, on_device);
  before.break_all_bonds_of(on_device);
  const auto earlier = places_in(next, first);
  now.restore(carry_over(before, now, earlier));
  const auto place = std::find(earlier.begin(), earlier.end(), static_cast<Index>(lost));
  ASSERT_NE(place, earlier.end());
  const auto number = static_cast<Index>(place - earlier.begin());
  EXPECT_EQ(now.view().intact_bonds(number), 0u);
  EXPECT_EQ(now.count().second, 1u);
}

}  // namespace
}  // namespace kerf::test
