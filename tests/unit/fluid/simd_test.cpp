// SPDX-License-Identifier: Apache-2.0
// The SIMD pair kernel against a plain double loop in double precision, term by term.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "fluid/packed_fluid_loop.hpp"
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
  double length = 1.0, correction = 1.0;  // h_j / h_i, s_ij of a graded solid
};
// Drops of water, of a fluid with shocks, of a graded solid.
struct Matter {
  double hugoniot_slope = 0.0;  // 0: without shocks
  bool graded = false;
  double viscosity() const { return graded ? 0.0 : mu; }
};

// Some thousand neighbours of particle 0 at random in a ball of 3 h.
template <int D>
std::vector<Drop> cloud(int count, unsigned seed, bool graded) {
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
    drop.surface = !graded && uniform(engine) > 0.9;
    if (graded && !drops.empty()) {
      drop.length = std::ldexp(1.0, static_cast<int>(engine() % 3) - 1);
      drop.correction = 1.2 + 0.6 * uniform(engine);
      drop.volume *= std::pow(drop.length, D);
    }
    drops.push_back(drop);
  }
  return drops;
}

// Returns the impedance and the sound speed at the density; with shocks, c of
// materials/shock_hugoniot.hpp.
RiemannSide<double> side_of(const Drop& drop, double own_mass, double hugoniot_slope,
                            double speed) {
  const double density = own_mass / drop.volume,
               eta = std::max(0.0, 1.0 - (mass / (spacing * spacing * spacing)) / density),
               steep = hugoniot_slope * eta,
               c = sound_speed * (1.0 - eta) * std::sqrt((1.0 + steep) / (1.0 - steep)) /
                   (1.0 - steep);
  const double speed_of_sound = hugoniot_slope > 0.0 ? c : sound_speed;
  return {density * speed_of_sound, drop.pressure, speed, speed_of_sound};
}

template <int D>
FluidSums<D, double> plain_sums(const std::vector<Drop>& drops, const Matter& matter) {
  const double hugoniot_slope = matter.hugoniot_slope, viscosity = matter.viscosity();
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
    const double r = std::sqrt(square), mean_h = 0.5 * (1.0 + j.length) * h,
                 size = std::pow(j.length, D);
    if (!(r < 2.0 * mean_h)) continue;
    const double slope = WendlandC2<D>::derivative(r, mean_h), approach = -along / r;
    const auto left = side_of(i, mass, hugoniot_slope, 0.0),
               right = side_of(j, size * mass, hugoniot_slope, -approach);
    const auto star =
        solve_riemann(left, right, hugoniot_slope > 0.0 ? shock_smoothing(left, right) : 1.0);
    const double damping =
        beyond_viscosity(star.dissipation, viscosity * std::max(0.0, approach) / r);
    for (int a = 0; a < D; ++a) {
      const double e = (i.x[a] - j.x[a]) / r, normal = -2.0 * kernel_gradient_normalisation *
                                                       j.correction * i.volume * j.volume * slope;
      sums.sum[FluidSums<D, double>::pressure_force_at + a] += normal * star.mean_pressure * e;
      sums.sum[FluidSums<D, double>::dissipative_force_at + a] +=
          normal * (damping * e - viscosity * (i.v[a] - j.v[a]) / r);
      sums.sum[FluidSums<D, double>::concentration_gradient_at + a] +=
          size * spacing * spacing * spacing * slope * e;
    }
    sums.sum[FluidSums<D, double>::compression_rate_at] +=
        2.0 * kernel_gradient_normalisation * j.correction * j.volume * star.speed * slope;
    sums.sum[FluidSums<D, double>::kernel_sum_at] +=
        size * spacing * spacing * spacing * WendlandC2<D>::value(r, mean_h);
    if (matter.graded) continue;  // it is no fluid
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
FluidLaw<Real> law_of(const Matter& matter, double kernel_scale) {
  FluidLaw<Real> law{};
  law.mass = Real(mass);
  law.volume = Real(spacing * spacing * spacing);
  law.sound_speed = Real(sound_speed);
  law.equations.shock_hugoniot.slope = Real(matter.hugoniot_slope);
  law.equation_of_state =
      matter.hugoniot_slope > 0.0 ? EquationOfState::shock_hugoniot : EquationOfState::tait;
  law.viscosity = Real(matter.viscosity());
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
  std::vector<std::uint32_t> begin, same_fluid, neighbour, graded_begin;
  std::vector<std::uint16_t> source;
  std::vector<std::uint8_t> graded;
  std::vector<Real> correction, length;  // per neighbour of a graded particle
  FluidLaw<Real> law{};
  bool by_loop = false;  // sums by the loop that takes the place of the kernel on GPUs
  SimdCloud(const std::vector<Drop>& drops, const Matter& matter)
      : law(law_of<Real>(matter, WendlandC2<D>::scale(h))) {
    for (const Drop& drop : drops) fluid.push_back(packed<D, Real>(drop));
  }
  void add_list(const std::vector<std::uint32_t>& list, const std::vector<Drop>& drops,
                bool is_graded) {
    begin.push_back(static_cast<std::uint32_t>(neighbour.size()));
    same_fluid.push_back(static_cast<std::uint32_t>(list.size()));
    source.push_back(0);
    graded.push_back(is_graded ? 1 : 0);
    neighbour.insert(neighbour.end(), list.begin(), list.end());
    graded_begin.push_back(static_cast<std::uint32_t>(correction.size()));
    if (!is_graded) return;
    for (const std::uint32_t j : list) correction.push_back(Real(drops[j].correction));
    for (const std::uint32_t j : list) length.push_back(Real(drops[j].length));
  }
  // A register may be loaded beyond the end of a list.
  std::vector<FluidSums<D, Real>> sums(std::uint32_t first, std::uint32_t last) {
    std::vector<FluidSums<D, Real>> results(last - first);
    neighbour.resize(neighbour.size() + 64);
    for (auto* numbers : {&correction, &length}) numbers->resize(numbers->size() + 64, Real(1));
    FluidKernelTask<D, Real> task;
    task.fluid = fluid.data();
    task.begin = begin.data();
    task.same_fluid = same_fluid.data();
    task.neighbour = neighbour.data();
    task.source = source.data();
    task.laws = &law;
    task.results = results.data();
    task.unit = static_cast<Real>(FixedPointScale<Real>::of_spacing(spacing).unit);
    task.graded = graded.data();
    task.graded_begin = graded_begin.data();
    task.correction = correction.data();
    task.length_ratio = length.data();
    if (!by_loop) fluid_kernels().get<D, Real>()(task, first, last);
    for (std::uint32_t i = first; by_loop && i < last; ++i) {
      PackedFluidLoop<D, Real, WeaklyCompressiblePairs<Real>>{task}(i);
      PackedFluidLoop<D, Real, ShockPairs<Real>>{task}(i);
    }
    return results;
  }
};

template <int D, class Real>
FluidSums<D, Real> simd_sums(const std::vector<Drop>& drops, const Matter& matter, bool by_loop) {
  SimdCloud<D, Real> all(drops, matter);
  all.by_loop = by_loop;
  std::vector<std::uint32_t> others;
  for (std::uint32_t j = 1; j < drops.size(); ++j) others.push_back(j);
  all.add_list(others, drops, matter.graded);
  return all.sums(0, 1)[0];
}

template <int D, class Real>
void expect_same_sums(const Matter& matter, bool by_loop) {
  const double tolerance = sizeof(Real) == 4 ? 2e-5 : 1e-13;  // roundings of sums of some terms
  for (int count : {2, 3, 16, 17, 18, 33, 90, 97, 98, 193, 194, 400}) {
    const auto drops = cloud<D>(count, 7u + static_cast<unsigned>(count), matter.graded);
    const auto due = plain_sums<D>(drops, matter);
    const auto is = simd_sums<D, Real>(drops, matter, by_loop);
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

void expect_same_sums_in_all(const Matter& matter, bool by_loop) {
  expect_same_sums<2, float>(matter, by_loop);
  expect_same_sums<3, float>(matter, by_loop);
  expect_same_sums<2, double>(matter, by_loop);
  expect_same_sums<3, double>(matter, by_loop);
}
TEST(FluidKernel, IsTheSumOfItsPairs) {
  for (const Matter& matter : {Matter{}, Matter{2.0, false}, Matter{0.0, true}})
    expect_same_sums_in_all(matter, false);
}
TEST(PackedFluidLoop, IsTheSumOfItsPairs) {
  for (const Matter& matter : {Matter{}, Matter{2.0, false}}) expect_same_sums_in_all(matter, true);
}

// The sums of a particle do not depend on the particles that the kernel computes before and after,
// some of which have no neighbours, are no fluid, or have neighbours of other spacings.
template <int D, class Real>
void expect_sums_of_each_alone() {
  constexpr std::uint32_t count = 40, lonely = 9, no_fluid = 20;
  const auto drops = cloud<D>(count, 5, true);
  SimdCloud<D, Real> all(drops, {0.0, true});
  all.fluid[no_fluid].volume = Real(0);
  for (std::uint32_t i = 0; i < count; ++i) {
    std::vector<std::uint32_t> list;
    for (std::uint32_t j = i % 7; j < count && i != lonely; ++j)
      if (j != i && j != no_fluid) list.push_back(j);
    all.add_list(list, drops, i % 5 < 2);
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
