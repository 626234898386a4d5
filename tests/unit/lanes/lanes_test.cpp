// SPDX-License-Identifier: Apache-2.0
// The walks of src/lanes/ against plain double loops in double precision.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "kernels/wendland_c2.hpp"
#include "lanes/walks.hpp"
#include "rates/riemann.hpp"

namespace kerf::test {
namespace {

constexpr double spacing = 1e-3, h = 1.3e-3, mass = 1e-6, sound = 40.0, mu = 0.3, steepening = 1.02;

struct Drop {
  double x[3], v[3], pressure, volume;
  bool surface;
};

// Some thousand neighbours of particle 0 in a ball of 3 h, at random.
template <int D>
std::vector<Drop> cloud(int count, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Drop> drops;
  while (static_cast<int>(drops.size()) < count) {
    Drop drop{};
    double square = 0.0;
    for (int a = 0; a < D; ++a) {
      const double off = 3.0 * h * uniform(engine);
      square += off * off;
      drop.x[a] = 0.7 + (drops.empty() ? 0.0 : off);  // far from the origin, in spacings
      drop.v[a] = 3.0 * uniform(engine);
    }
    if (square > 9.0 * h * h) continue;
    drop.pressure = 2e4 * (1.0 + uniform(engine));
    drop.volume = 1e-9 * (1.0 + 0.02 * uniform(engine));
    drop.surface = uniform(engine) > 0.9;
    drops.push_back(drop);
  }
  return drops;
}

template <int D>
FluidSums<D, double> plain_sums(const std::vector<Drop>& drops) {
  FluidSums<D, double> sums{};
  const Drop& i = drops[0];
  for (std::size_t n = 1; n < drops.size(); ++n) {
    const Drop& j = drops[n];
    double square = 0.0, along = 0.0, speed = 0.0;
    for (int a = 0; a < D; ++a) {
      square += std::pow(i.x[a] - j.x[a], 2);
      along += (i.v[a] - j.v[a]) * (i.x[a] - j.x[a]);
      speed += std::pow(i.v[a] - j.v[a], 2);
    }
    const double r = std::sqrt(square);
    if (!(r < 2.0 * h)) continue;
    const double slope = WendlandC2<D>::derivative(r, h), approach = -along / r;
    const RiemannSide<double> left{mass / i.volume * sound, i.pressure, 0.0, sound},
        right{mass / j.volume * sound, j.pressure, -approach, sound};
    const auto star = solve_riemann(left, right);
    const double damping = beyond_viscosity(star.dissipation, mu * approach / r);
    for (int a = 0; a < D; ++a) {
      const double e = (i.x[a] - j.x[a]) / r,
                   push = -2.0 * steepening * i.volume * j.volume * slope;
      sums.sum[FluidSums<D, double>::pressing_at + a] += push * star.mean_pressure * e;
      sums.sum[FluidSums<D, double>::damping_at + a] +=
          push * (damping * e - mu * (i.v[a] - j.v[a]) / r);
      sums.sum[FluidSums<D, double>::crowd_at + a] += spacing * spacing * spacing * slope * e;
    }
    sums.sum[FluidSums<D, double>::strain_rate_at] +=
        2.0 * steepening * j.volume * star.speed * slope;
    sums.sum[FluidSums<D, double>::filling_at] +=
        spacing * spacing * spacing * WendlandC2<D>::value(r, h);
    sums.fastest_squared = std::max(sums.fastest_squared, speed);
    if (j.surface) sums.sees_surface = 1.0;
  }
  return sums;
}

template <int D, class Real>
FluidSums<D, Real> walked_sums(const std::vector<Drop>& drops) {
  const auto unit = PlaceUnit<Real>::of_spacing(spacing);
  std::vector<PackedFluid<D, Real>> fluid;
  std::vector<std::uint32_t> neighbour;
  for (const Drop& drop : drops) {
    PackedFluid<D, Real> packed{};
    for (int a = 0; a < D; ++a) {
      packed.place[a] = unit.pack(drop.x[a]);
      packed.velocity[a] = Real(drop.v[a]);
    }
    packed.pressure = Real(drop.pressure);
    packed.volume = Real(drop.surface ? -drop.volume : drop.volume);
    if (!fluid.empty()) neighbour.push_back(static_cast<std::uint32_t>(fluid.size()));
    fluid.push_back(packed);
  }
  FluidLaw<Real> law{};
  law.mass = Real(mass);
  law.volume = Real(spacing * spacing * spacing);
  law.sound_speed = Real(sound);
  law.viscosity = Real(mu);
  law.smoothing_length = Real(h);
  law.per_smoothing_length = Real(1.0 / h);
  law.kernel_scale = Real(WendlandC2<D>::scale(h));
  law.kernel_slope = Real(5.0 * WendlandC2<D>::scale(h) / (h * h));
  law.steepening = Real(steepening);
  const std::uint32_t begin = 0, alike = static_cast<std::uint32_t>(neighbour.size());
  const std::uint16_t source = 0;
  FluidSums<D, Real> sums{};
  neighbour.resize(neighbour.size() + 64);
  const FluidWalkTask<D, Real> task{fluid.data(), &begin, &alike, neighbour.data(),
                                    &source,      &law,   &sums,  static_cast<Real>(unit.unit)};
  walks().get<D, Real>().fluid(task, 0, 1);
  return sums;
}

template <int D, class Real>
void expect_same_sums() {
  const double tolerance = sizeof(Real) == 4 ? 2e-5 : 1e-13;  // roundings of sums of some terms
  for (int count : {2, 3, 16, 17, 18, 33, 90}) {
    const auto drops = cloud<D>(count, 7u + static_cast<unsigned>(count));
    const auto due = plain_sums<D>(drops);
    const auto is = walked_sums<D, Real>(drops);
    const double force = std::sqrt(dot(due.pressing(), due.pressing())) + 1e-30;
    const double damping = std::sqrt(dot(due.damping(), due.damping())) + 1e-30;
    const double crowd = std::sqrt(dot(due.crowd(), due.crowd())) + 1e-30;
    for (int a = 0; a < D; ++a) {
      EXPECT_NEAR(is.pressing()[a], due.pressing()[a], 10.0 * tolerance * force) << count;
      EXPECT_NEAR(is.damping()[a], due.damping()[a], 10.0 * tolerance * damping) << count;
      EXPECT_NEAR(is.crowd()[a], due.crowd()[a], 10.0 * tolerance * crowd) << count;
    }
    EXPECT_NEAR(is.strain_rate(), due.strain_rate(),
                100.0 * tolerance * std::abs(due.strain_rate()));
    EXPECT_NEAR(is.filling(), due.filling(), tolerance * due.filling()) << count;
    EXPECT_NEAR(is.fastest_squared, due.fastest_squared, tolerance * due.fastest_squared);
    EXPECT_EQ(is.sees_surface, due.sees_surface) << count;
  }
}

TEST(FluidWalk, IsTheSumOfItsPairs) {
  expect_same_sums<2, float>();
  expect_same_sums<3, float>();
  expect_same_sums<2, double>();
  expect_same_sums<3, double>();
}

// Where the speed of sound is constant the solution by volumes is that by impedances.
TEST(RiemannByVolumes, IsThatByImpedances) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int n = 0; n < 100; ++n) {
    const double left_volume = 1e-9 * (1.0 + 0.3 * uniform(engine)),
                 right_volume = 1e-9 * (1.0 + 0.3 * uniform(engine)),
                 left_pressure = 1e4 * uniform(engine), right_pressure = 1e4 * uniform(engine),
                 speed = sound * uniform(engine);
    const auto due =
        solve_riemann<double>({mass / left_volume * sound, left_pressure, 0.0, sound},
                              {mass / right_volume * sound, right_pressure, speed, sound});
    const auto is =
        riemann_parts<double>({left_volume, left_pressure}, {right_volume, right_pressure}, speed,
                              {3.0 * mass, mass * sound, 1.0 / (mass * sound)});
    EXPECT_NEAR(is.pressing / is.volume, due.mean_pressure, 1e-13 * 1e4);
    EXPECT_NEAR(is.approach * is.damping / is.volume, due.dissipation,
                1e-13 * std::abs(due.dissipation));
    EXPECT_NEAR(left_volume * is.speed / is.volume, due.speed, 1e-13 * sound);
  }
}

// Places are counted round: differences hold wherever in space the particles are.
TEST(PlaceUnit, DifferencesHoldAnywhere) {
  const auto unit = PlaceUnit<float>::of_spacing(spacing);
  for (double where : {0.0, -3.0, 0.5, 1e3}) {
    const auto there = unit.pack(where + 0.4 * spacing), here = unit.pack(where);
    const auto apart = static_cast<std::int32_t>(static_cast<std::uint32_t>(there) -
                                                 static_cast<std::uint32_t>(here));
    EXPECT_NEAR(apart * unit.unit, 0.4 * spacing, 2.0 * unit.unit + 1e-12 * where);
  }
}

}  // namespace
}  // namespace kerf::test
