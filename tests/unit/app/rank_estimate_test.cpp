// SPDX-License-Identifier: Apache-2.0
// The time of several ranks follows from what they have, by formulas that are known.
#include <gtest/gtest.h>

#include "app/rank_estimate.hpp"

namespace kerf {
namespace {

// Ranks with the same number of particles, ghosts and bytes.
RankLoads even_loads(int ranks, double particles, std::uint64_t ghosts, double bytes) {
  RankLoads loads;
  RankLoad load;
  load.work = particles / ranks;
  load.particles = static_cast<std::uint64_t>(particles / ranks);
  load.ghosts = ranks == 1 ? 0 : ghosts;
  if (ranks > 1) load.messages = {bytes, bytes, 1};
  loads.of.assign(static_cast<std::size_t>(ranks), load);
  loads.waits = {1, 2, 0};
  return loads;
}

constexpr OneRank one{3, 1.0, 100.0, 8e6, 0.5, 1.0};

TEST(RankEstimate, OfOneRankIsTheRun) {
  const RankEstimate estimate = estimate_ranks(even_loads(1, 8000.0, 0, 0.0), one, {});
  EXPECT_DOUBLE_EQ(estimate.step_time, 1.0);
  EXPECT_DOUBLE_EQ(estimate.run_time, 100.0);
  EXPECT_DOUBLE_EQ(estimate.speed_up, 1.0);
  EXPECT_DOUBLE_EQ(estimate.imbalance, 1.0);
  EXPECT_DOUBLE_EQ(estimate.memory, 8e6);
  EXPECT_DOUBLE_EQ(estimate.messages, 0.0);
}

// With much work the messages do not count, and the work is a quarter.
TEST(RankEstimate, OfEvenPartsOfMuchWorkIsTheirNumber) {
  const RankEstimate estimate = estimate_ranks(even_loads(4, 8000.0, 0, 0.0), one, {});
  EXPECT_NEAR(estimate.speed_up, 4.0, 1e-3);
  EXPECT_DOUBLE_EQ(estimate.imbalance, 1.0);
  EXPECT_DOUBLE_EQ(estimate.memory, 2e6);
}

// A wait for a neighbour takes the latency, a sum as often as a tree of four has levels.
TEST(RankEstimate, MessagesTakeLatencyAndBytes) {
  const RankLoads loads = even_loads(4, 8000.0, 100, 1e6);
  const auto messages = [&](double latency, double bandwidth) {
    return estimate_ranks(loads, one, {latency, bandwidth}).messages;
  };
  EXPECT_NEAR(messages(2e-3, 1e30) - messages(1e-3, 1e30), 1e-3 * (1.0 + 2.0 * 2.0), 1e-12);
  EXPECT_NEAR(messages(0.0, 1e6) - messages(0.0, 1e30), 1.0 + 2.0 * 4.0 * 64.0 / 1e6, 1e-9);
}

// One rank has half of the work, of four.
TEST(RankEstimate, TheSlowestRankSetsTheTime) {
  RankLoads loads = even_loads(4, 8000.0, 0, 0.0);
  for (std::size_t r = 0; r < 4; ++r) loads.of[r].work = r == 0 ? 3.0 : 1.0;
  const RankEstimate estimate = estimate_ranks(loads, one, {});
  EXPECT_DOUBLE_EQ(estimate.imbalance, 2.0);
  EXPECT_NEAR(estimate.speed_up, 2.0, 1e-3);
}

// Bonds are divided apart from particles, and half of the time is theirs.
TEST(RankEstimate, BondsAndParticlesAreDividedApart) {
  RankLoads loads = even_loads(2, 8000.0, 0, 0.0);
  loads.of[0].bonds = 1000.0;
  const RankEstimate estimate = estimate_ranks(loads, one, {});
  EXPECT_DOUBLE_EQ(estimate.imbalance, 0.5 * 1.0 + 0.5 * 2.0);
}

// Eight times as many particles: eight times the parts, four times the ghosts.
TEST(RankEstimate, ACoarserLayoutIsScaled) {
  OneRank finer = one;
  finer.refinement = 8.0;
  const RankEstimate estimate = estimate_ranks(even_loads(4, 8000.0, 100, 1e6), finer, {});
  EXPECT_DOUBLE_EQ(estimate.particles, 16000.0);
  EXPECT_DOUBLE_EQ(estimate.ghosts, 400.0);
  EXPECT_DOUBLE_EQ(estimate.bytes, 4e6);
}

// What all ranks have of a solid is not divided.
TEST(RankEstimate, EachRankHasTheFieldsOfTheWholeSolid) {
  RankLoads loads = even_loads(4, 8000.0, 0, 0.0);
  loads.solid_bytes = 4e6;
  EXPECT_DOUBLE_EQ(estimate_ranks(loads, one, {}).memory, 4e6 + 1e6);
}

}  // namespace
}  // namespace kerf
