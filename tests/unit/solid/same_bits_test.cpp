// SPDX-License-Identifier: Apache-2.0
// The solid has the same bits for any number of threads, and from a saved state.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <cstring>

#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

template <class Chosen>
class SameBits : public testing::Test {
 protected:
  using Trial = SolidOnTrial<Chosen::D, typename Chosen::P>;

  // A block expands along x and breaks, by a strain or after softening.
  static Trial start(bool softens = false) {
    constexpr int dimension = Chosen::D;
    auto medium = soft_solid(1e-3, dimension);
    medium.failure_strain = 0.1;
    if (softens) {
      medium.criterion = BondCriterion::crack_band;
      medium.softening_strain = 0.04;
    }
    medium.artificial_linear = 0.3;
    Trial trial(block<dimension>({.cells = {30, 9, 6}, .jitter = 0.2, .seed = 6}, medium));
    for (std::size_t i = 0; i < trial.size(); ++i)
      trial.velocity[i][0] =
          static_cast<typename Chosen::Real>(200.0 * (trial.layout.reference[i][0] - 15e-3));
    trial.evaluate();
    return trial;
  }
  static double take_steps(Trial& trial, int steps) {
    double released = 0.0;
    const double dt = 0.2 * 1e-3 / trial.layout.media[0].bond_wave_speed();
    for (int n = 0; n < steps; ++n) {
      trial.kick(0.5 * dt);
      for (std::size_t i = 0; i < trial.size(); ++i)
        trial.position[i] += dt * Vector<Chosen::D, double>::from(trial.velocity[i]);
      trial.deform();
      released += trial.solid.fracture().released;
      released += trial.solid.keep_softening();
      trial.evaluate();
      trial.kick(0.5 * dt);
    }
    return released;
  }
  template <class T>
  static bool are_same(const std::vector<T>& a, const std::vector<T>& b) {
    if (a.size() != b.size() || a.empty()) return a.size() == b.size();
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
  }
  static void expect_same(Trial& a, Trial& b) {
    EXPECT_TRUE(are_same(a.position, b.position));
    EXPECT_TRUE(are_same(a.velocity, b.velocity));
    EXPECT_TRUE(are_same(a.solid.save().bond_intact, b.solid.save().bond_intact));
    EXPECT_TRUE(are_same(a.solid.save().elastic_share, b.solid.save().elastic_share));
    EXPECT_TRUE(are_same(a.solid.save().acceleration, b.solid.save().acceleration));
    EXPECT_TRUE(are_same(to_host(a.solid.fields().detached), to_host(b.solid.fields().detached)));
    EXPECT_TRUE(are_same(a.solid.save().strain, b.solid.save().strain));
    EXPECT_EQ(a.solid.energy().total(), b.solid.energy().total());
  }
  // Sets the number of threads even if there are fewer cores.
  static Trial run_on(int threads, int steps) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return tbb::task_arena(threads).execute([&] {
      Trial trial = start();
      take_steps(trial, steps);
      return trial;
    });
  }
};
TYPED_TEST_SUITE(SameBits, TwoKinds);

constexpr int steps = 60;

TYPED_TEST(SameBits, ForAnyNumberOfThreads) {
  auto one = this->run_on(1, steps);
  EXPECT_LT(one.solid.count().first, this->start().solid.count().first);  // some bonds broke
  for (int threads : {2, 3}) {
    auto other = this->run_on(threads, steps);
    this->expect_same(one, other);
  }
}

TYPED_TEST(SameBits, FromASavedState) {
  for (bool softens : {false, true}) {
    auto uninterrupted = this->start(softens);
    this->take_steps(uninterrupted, steps);
    const auto saved = uninterrupted.solid.save();
    auto resumed = this->start(softens);
    resumed.position = uninterrupted.position;
    resumed.velocity = uninterrupted.velocity;
    resumed.solid.restore(saved);
    resumed.deform();
    EXPECT_EQ(uninterrupted.solid.softening_work() > 0.0, softens);
    const double released = this->take_steps(uninterrupted, 20);
    EXPECT_EQ(this->take_steps(resumed, 20), released);
    this->expect_same(uninterrupted, resumed);
  }
}

}  // namespace
}  // namespace kerf::test
