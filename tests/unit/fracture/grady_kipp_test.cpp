// SPDX-License-Identifier: Apache-2.0
// Flaws of particles against Weibull's statistics, damage of a material point against the closed
// form of Grady & Kipp (1980).
#include "fracture/grady_kipp.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace kerf {
namespace {

constexpr double per_volume = 4e15, exponent = 6.0, crack_speed = 1000.0;

GradyKipp<double> law_of(double volume, std::uint64_t seed) {
  return GradyKipp<double>::of({per_volume, exponent, crack_speed}, volume, seed);
}

// The weakest flaw of a body is active at a strain with the mean (k V)^(-1/m) Gamma(1 + 1/m), for
// any number of particles.
TEST(GradyKipp, WeakestFlawIsThatOfTheBody) {
  constexpr double body = 1e-3;  // m^3
  constexpr int trials = 400;
  const double scale = std::pow(per_volume * body, -1.0 / exponent);
  const double mean = scale * std::tgamma(1.0 + 1.0 / exponent);
  const double variance = scale * scale * std::tgamma(1.0 + 2.0 / exponent) - mean * mean;
  for (const int particles : {1, 30, 3000}) {
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= trials; ++seed) {
      const auto law = law_of(body / particles, seed);
      double weakest = 1e30;
      for (int i = 0; i < particles; ++i)
        weakest = std::min(weakest, law.start(static_cast<std::uint64_t>(i)).next);
      sum += weakest;
    }
    EXPECT_NEAR(sum / trials, mean, 4.0 * std::sqrt(variance / trials)) << particles;
  }
}

// The number of flaws of a particle that are active at a strain has the mean and the variance k V
// strain^m of Poisson's law.
TEST(GradyKipp, ActiveFlawsAreAPoissonProcess) {
  constexpr int particles = 4000;
  const auto law = law_of(1e-6, 5);
  const double strain = law.unit_strain * std::pow(3.0, 1.0 / exponent), wanted = 3.0;
  double sum = 0.0, square = 0.0;
  for (std::uint64_t i = 0; i < particles; ++i) {
    const double count = law.advance(law.start(i), i, strain, 0.0).count;
    sum += count;
    square += count * count;
  }
  const double mean = sum / particles, variance = square / particles - mean * mean;
  EXPECT_NEAR(mean, wanted, 4.0 * std::sqrt(wanted / particles));
  // The variance of a Poisson sample's variance is (mean + 2 mean^2) / n.
  EXPECT_NEAR(variance, wanted, 4.0 * std::sqrt((wanted + 2.0 * wanted * wanted) / particles));
}

// For one crack D^(1/3) grows at the rate c_g / R for any step; it does not grow at strains below
// its activation strain.
TEST(GradyKipp, OneCrackGrowsAtItsSpeed) {
  const double volume = 1e-6, radius = std::cbrt(0.75 * volume / std::numbers::pi);
  const auto law = law_of(volume, 1);
  auto state = law.start(0);
  const double first = state.next;
  state = law.advance(state, 0, first * (1.0 + 1e-9), 0.0);
  ASSERT_EQ(state.count, 1.0);
  const double strain = 0.5 * (first + state.next);
  const double time = 0.5 * radius / crack_speed;
  for (const int steps : {1, 7}) {
    auto grown = state;
    for (int n = 0; n < steps; ++n) grown = law.advance(grown, 0, strain, time / steps);
    EXPECT_NEAR(std::cbrt(grown.damage), 0.5, 1e-12);
    EXPECT_EQ(law.advance(grown, 0, 0.99 * first, time).damage, grown.damage);
    for (int n = 0; n < 3; ++n) grown = law.advance(grown, 0, strain, time);
    EXPECT_EQ(grown.damage, 1.0);
  }
}

struct LargestStress {
  double damage, strain;  // at the maximum of the mean stress
  double peak;            // of strain (1 - D)
};

// Many material points at a constant rate of strain.
LargestStress pull(double rate, double volume) {
  constexpr std::uint64_t points = 400;
  const auto law = law_of(volume, 3);
  std::vector<FlawState<double>> state;
  for (std::uint64_t i = 0; i < points; ++i) state.push_back(law.start(i));
  const double dt = 2e-3 * law.unit_strain / rate;
  LargestStress best{0.0, 0.0, 0.0};
  for (double strain = 0.0; strain < 6.0 * law.unit_strain; strain += rate * dt) {
    double damage = 0.0;
    for (std::uint64_t i = 0; i < points; ++i) {
      state[i] = law.advance(state[i], i, strain, dt);
      damage += state[i].damage / points;
    }
    if (strain * (1.0 - damage) > best.peak) best = {damage, strain, strain * (1.0 - damage)};
  }
  return best;
}

// D = A rate^m t^(m+3), A = 8 pi k c_g^3 / ((m+1)(m+2)(m+3)): the stress E strain (1 - D) is
// largest at D = 1 / (m + 4), where strain^(m+3) = rate^3 / (A (m+4)), so strength is proportional
// to rate^(3/(m+3)). Particles have 10^4 flaws at that strain, or 20, or one. The mean is the same,
// except that cracks end at their particle, which increases the strength with one flaw by 1.6%.
TEST(GradyKipp, StrengthAndItsRateAreThoseOfTheClosedForm) {
  const double m = exponent, cube = std::pow(crack_speed, 3);
  const double growth =
      8.0 * std::numbers::pi * per_volume * cube / ((m + 1.0) * (m + 2.0) * (m + 3.0));
  double peaks[2];
  int n = 0;
  for (const double rate : {20.0, 320.0}) {
    const double strain = std::pow(std::pow(rate, 3) / (growth * (m + 4.0)), 1.0 / (m + 3.0));
    const double peak = strain * (m + 3.0) / (m + 4.0);
    for (const double flaws : {1e4, 20.0, 1.0}) {
      const LargestStress found = pull(rate, flaws / (per_volume * std::pow(strain, m)));
      std::printf("rate %g, %g flaws: peak %.5f of %.5f, D %.4f of %.4f\n", rate, flaws, found.peak,
                  peak, found.damage, 1.0 / (m + 4.0));
      EXPECT_NEAR(found.peak, peak, 0.02 * peak);
      if (flaws == 20.0) peaks[n] = found.peak;
    }
    ++n;
  }
  EXPECT_NEAR(std::log(peaks[1] / peaks[0]) / std::log(16.0), 3.0 / (m + 3.0), 0.01);
}

// Single precision counts the same flaws, except those within its rounding.
TEST(GradyKipp, SinglePrecisionHasEqualFlaws) {
  const auto law = law_of(1e-6, 2);
  const auto single = GradyKipp<float>::from(law);
  for (std::uint64_t i = 0; i < 100; ++i) {
    auto state = law.start(i);
    auto short_state = single.start(i);
    for (int n = 0; n < 20; ++n) {
      EXPECT_NEAR(short_state.next, state.next, 2e-6 * state.next);
      state = law.advance(state, i, state.next * (1.0 + 1e-12), 0.0);
      short_state = single.advance(short_state, i, short_state.next * (1.0f + 2e-7f), 0.0f);
    }
  }
}

}  // namespace
}  // namespace kerf
