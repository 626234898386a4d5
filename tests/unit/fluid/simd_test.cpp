// SPDX-License-Identifier: Apache-2.0
// The SIMD pair kernel against a plain double loop in double precision, term by term.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "fluid/riemann.hpp"
#include "fluid/simd/fluid_kernels.hpp"
#include "kernels/wendland_c2.hpp"

namespace kerf::test {
namespace {

constexpr double spacing = 1e-3, h = 1.3e-3, mass = 1e-6, sound_speed = 40.0, mu = 0.3,
                 kernel_gradient_normalisation = 1.02;

struct Drop {
  double x[3], v[3], pressure, volume;
  bool surface;
};

// Some thousand neighbours of particle 0 at random in a ball of 3 h.
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

// Returns the impedance and the sound speed at the density; with shocks, c of
// materials/shock_hugoniot.hpp.
RiemannSide<double> side_of(const Drop& drop, double hugoniot_slope, double speed) {
  const double density = mass / drop.volume,
               eta = std::max(0.0, 1.0 - (mass / (spacing * spacing * spacing)) / density),
               steep = hugoniot_slope * eta,
               c = sound_speed * (1.0 - eta) * std::sqrt((1.0 + steep) / (1.0 - steep)) /
                   (1.0 - steep);
  const double speed_of_sound = hugoniot_slope > 0.0 ? c : sound_speed;
  return {density * speed_of_sound, drop.pressure, speed, speed_of_sound};
}

// `hugoniot_slope`: 0 for a fluid without shocks.
template <int D>
FluidSums<D, double> plain_sums(const std::vector<Drop>& drops, double hugoniot_slope) {
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
    const auto left = side_of(i, hugoniot_slope, 0.0),
               right = side_of(j, hugoniot_slope, -approach);
    const auto star =
        solve_riemann(left, right, hugoniot_slope > 0.0 ? shock_smoothing(left, right) : 1.0);
    const double damping = beyond_viscosity(star.dissipation, mu * std::max(0.0, approach) / r);
    for (int a = 0; a < D; ++a) {
      const double e = (i.x[a] - j.x[a]) / r,
                   normal = -2.0 * kernel_gradient_normalisation * i.volume * j.volume * slope;
      sums.sum[FluidSums<D, double>::pressure_force_at + a] += normal * star.mean_pressure * e;
      sums.sum[FluidSums<D, double>::dissipative_force_at + a] +=
          normal * (damping * e - mu * (i.v[a] - j.v[a]) / r);
      sums.sum[FluidSums<D, double>::concentration_gradient_at + a] +=
          spacing * spacing * spacing * slope * e;
    }
    sums.sum[FluidSums<D, double>::compression_rate_at] +=
        2.0 * kernel_gradient_normalisation * j.volume * star.speed * slope;
    sums.sum[FluidSums<D, double>::kernel_sum_at] +=
        spacing * spacing * spacing * WendlandC2<D>::value(r, h);
    sums.fastest_squared = std::max(sums.fastest_squared, speed);
    if (j.surface) sums.near_free_surface = 1.0;
  }
  return sums;
}

template <int D, class Real>
PackedFluid<D, Real> packed(const Drop& drop) {
  const auto unit = FixedPointScale<Real>::of_spacing(spacing);
  PackedFluid<D, Real> packed{};
  for (int a = 0; a < D; ++a) {
    packed.position[a] = unit.pack(drop.x[a]);
    packed.velocity[a] = Real(drop.v[a]);
  }
  packed.pressure = Real(drop.pressure);
  packed.volume = Real(drop.surface ? -drop.volume : drop.volume);
  return packed;
}

template <class Real>
FluidLaw<Real> law_of(double hugoniot_slope, double kernel_scale) {
  FluidLaw<Real> law{};
  law.mass = Real(mass);
  law.volume = Real(spacing * spacing * spacing);
  law.sound_speed = Real(sound_speed);
  law.equations.shock_hugoniot.slope = Real(hugoniot_slope);
  law.equation_of_state =
      hugoniot_slope > 0.0 ? EquationOfState::shock_hugoniot : EquationOfState::tait;
  law.viscosity = Real(mu);
  law.per_smoothing_length = Real(1.0 / h);
  law.kernel_scale = Real(kernel_scale);
  law.kernel_slope = Real(5.0 * kernel_scale / (h * h));
  law.kernel_gradient_normalisation = Real(kernel_gradient_normalisation);
  return law;
}

// Particles of one fluid with their lists, and the sums of some of them by the SIMD kernel.
template <int D, class Real>
struct SimdCloud {
  std::vector<PackedFluid<D, Real>> fluid;
  std::vector<std::uint32_t> begin, same_fluid, neighbour;
  std::vector<std::uint16_t> source;
  FluidLaw<Real> law{};

  void add_list(const std::vector<std::uint32_t>& list) {
    begin.push_back(static_cast<std::uint32_t>(neighbour.size()));
    same_fluid.push_back(static_cast<std::uint32_t>(list.size()));
    source.push_back(0);
    neighbour.insert(neighbour.end(), list.begin(), list.end());
  }
  std::vector<FluidSums<D, Real>> sums(std::uint32_t first, std::uint32_t last) const {
    std::vector<FluidSums<D, Real>> results(last - first);
    const FluidKernelTask<D, Real> task{
        fluid.data(),      begin.data(),
        same_fluid.data(), neighbour.data(),
        source.data(),     &law,
        results.data(),    static_cast<Real>(FixedPointScale<Real>::of_spacing(spacing).unit)};
    fluid_kernels().get<D, Real>()(task, first, last);
    return results;
  }
};

template <int D, class Real>
FluidSums<D, Real> simd_sums(const std::vector<Drop>& drops, double hugoniot_slope) {
  SimdCloud<D, Real> cloud;
  std::vector<std::uint32_t> others;
  for (const Drop& drop : drops) {
    if (!cloud.fluid.empty()) others.push_back(static_cast<std::uint32_t>(cloud.fluid.size()));
    cloud.fluid.push_back(packed<D, Real>(drop));
  }
  cloud.law = law_of<Real>(hugoniot_slope, WendlandC2<D>::scale(h));
  cloud.add_list(others);
  return cloud.sums(0, 1)[0];
}

template <int D, class Real>
void expect_same_sums(double hugoniot_slope) {
  const double tolerance = sizeof(Real) == 4 ? 2e-5 : 1e-13;  // roundings of sums of some terms
  for (int count : {2, 3, 16, 17, 18, 33, 90, 97, 98, 193, 194, 400}) {
    const auto drops = cloud<D>(count, 7u + static_cast<unsigned>(count));
    const auto due = plain_sums<D>(drops, hugoniot_slope);
    const auto is = simd_sums<D, Real>(drops, hugoniot_slope);
    const double force = std::sqrt(dot(due.pressure_force(), due.pressure_force())) + 1e-30;
    const double damping = std::sqrt(dot(due.dissipative_force(), due.dissipative_force())) + 1e-30;
    const double concentration_gradient =
        std::sqrt(dot(due.concentration_gradient(), due.concentration_gradient())) + 1e-30;
    for (int a = 0; a < D; ++a) {
      EXPECT_NEAR(is.pressure_force()[a], due.pressure_force()[a], 10.0 * tolerance * force)
          << count;
      EXPECT_NEAR(is.dissipative_force()[a], due.dissipative_force()[a], 10.0 * tolerance * damping)
          << count;
      EXPECT_NEAR(is.concentration_gradient()[a], due.concentration_gradient()[a],
                  10.0 * tolerance * concentration_gradient)
          << count;
    }
    EXPECT_NEAR(is.compression_rate(), due.compression_rate(),
                100.0 * tolerance * std::abs(due.compression_rate()));
    EXPECT_NEAR(is.kernel_sum(), due.kernel_sum(), tolerance * due.kernel_sum()) << count;
    EXPECT_NEAR(is.fastest_squared, due.fastest_squared, tolerance * due.fastest_squared);
    EXPECT_EQ(is.near_free_surface, due.near_free_surface) << count;
  }
}

TEST(FluidKernel, IsTheSumOfItsPairs) {
  for (const double hugoniot_slope : {0.0, 2.0}) {
    expect_same_sums<2, float>(hugoniot_slope);
    expect_same_sums<3, float>(hugoniot_slope);
    expect_same_sums<2, double>(hugoniot_slope);
    expect_same_sums<3, double>(hugoniot_slope);
  }
}

// The sums of a particle do not depend on the particles that the kernel computes before and after,
// some of which have no neighbours or are no fluid.
template <int D, class Real>
void expect_sums_of_each_alone() {
  SimdCloud<D, Real> all;
  constexpr std::uint32_t count = 40, lonely = 9, no_fluid = 20;
  for (const Drop& drop : cloud<D>(count, 5)) all.fluid.push_back(packed<D, Real>(drop));
  all.fluid[no_fluid].volume = Real(0);
  all.law = law_of<Real>(0.0, WendlandC2<D>::scale(h));
  for (std::uint32_t i = 0; i < count; ++i) {
    std::vector<std::uint32_t> list;
    for (std::uint32_t j = i % 7; j < count && i != lonely; ++j)
      if (j != i && j != no_fluid) list.push_back(j);
    all.add_list(list);
  }
  const auto together = all.sums(0, count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto alone = all.sums(i, i + 1)[0];
    for (int n = 0; n < FluidSums<D, Real>::count; ++n) {
      EXPECT_EQ(together[i].sum[n], alone.sum[n]) << i;
      if (i == lonely || i == no_fluid) {
        EXPECT_EQ(alone.sum[n], Real(0));
      }
    }
    EXPECT_EQ(together[i].fastest_squared, alone.fastest_squared) << i;
    EXPECT_EQ(together[i].near_free_surface, alone.near_free_surface) << i;
  }
}

TEST(FluidKernel, SumsOfAParticleAreItsOwn) {
  expect_sums_of_each_alone<2, float>();
  expect_sums_of_each_alone<3, float>();
  expect_sums_of_each_alone<2, double>();
  expect_sums_of_each_alone<3, double>();
}

// riemann_parts and solve_riemann are two forms of one solution where the sound speed is constant.
TEST(RiemannByVolumes, AgreesWithTheFormByImpedances) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int n = 0; n < 100; ++n) {
    const double left_volume = 1e-9 * (1.0 + 0.3 * uniform(engine)),
                 right_volume = 1e-9 * (1.0 + 0.3 * uniform(engine)),
                 left_pressure = 1e4 * uniform(engine), right_pressure = 1e4 * uniform(engine),
                 speed = sound_speed * uniform(engine);
    const auto due = solve_riemann<double>(
        {mass / left_volume * sound_speed, left_pressure, 0.0, sound_speed},
        {mass / right_volume * sound_speed, right_pressure, speed, sound_speed});
    const auto is =
        riemann_parts<double>({left_volume, left_pressure}, {right_volume, right_pressure}, speed,
                              {3.0 * mass, mass * sound_speed, 1.0 / (mass * sound_speed)});
    EXPECT_NEAR(is.pressure_force / is.volume, due.mean_pressure, 1e-13 * 1e4);
    EXPECT_NEAR(is.approach * is.dissipative_force / is.volume, due.dissipation,
                1e-13 * std::abs(due.dissipation));
    EXPECT_NEAR(left_volume * is.speed / is.volume, due.speed, 1e-13 * sound_speed);
  }
}

// Fixed-point coordinates wrap around: differences are valid at all positions.
TEST(FixedPointScale, DifferencesHoldAnywhere) {
  const auto unit = FixedPointScale<float>::of_spacing(spacing);
  for (double where : {0.0, -3.0, 0.5, 1e3}) {
    const auto there = unit.pack(where + 0.4 * spacing), here = unit.pack(where);
    const auto apart = static_cast<std::int32_t>(static_cast<std::uint32_t>(there) -
                                                 static_cast<std::uint32_t>(here));
    EXPECT_NEAR(apart * unit.unit, 0.4 * spacing, 2.0 * unit.unit + 1e-12 * where);
  }
}

}  // namespace
}  // namespace kerf::test
