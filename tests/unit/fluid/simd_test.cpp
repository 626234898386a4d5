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
FluidSums<D, Real> simd_sums(const std::vector<Drop>& drops, const Matter& matter) {
  const double hugoniot_slope = matter.hugoniot_slope;
  std::vector<Real> correction, length;
  const auto unit = FixedPointScale<Real>::of_spacing(spacing);
  std::vector<PackedFluid<D, Real>> fluid;
  std::vector<std::uint32_t> neighbour;
  for (const Drop& drop : drops) {
    PackedFluid<D, Real> packed{};
    for (int a = 0; a < D; ++a) {
      packed.position[a] = unit.pack(drop.x[a]);
      packed.velocity[a] = Real(drop.v[a]);
    }
    packed.pressure = Real(drop.pressure);
    packed.volume = Real(drop.surface ? -drop.volume : drop.volume);
    if (!fluid.empty()) {
      neighbour.push_back(static_cast<std::uint32_t>(fluid.size()));
      correction.push_back(Real(drop.correction));
      length.push_back(Real(drop.length));
    }
    fluid.push_back(packed);
  }
  FluidLaw<Real> law{};
  law.mass = Real(mass);
  law.volume = Real(spacing * spacing * spacing);
  law.sound_speed = Real(sound_speed);
  law.equations.shock_hugoniot.slope = Real(hugoniot_slope);
  law.equation_of_state =
      hugoniot_slope > 0.0 ? EquationOfState::shock_hugoniot : EquationOfState::tait;
  law.viscosity = Real(matter.viscosity());
  law.per_smoothing_length = Real(1.0 / h);
  law.kernel_scale = Real(WendlandC2<D>::scale(h));
  law.kernel_slope = Real(5.0 * WendlandC2<D>::scale(h) / (h * h));
  law.kernel_gradient_normalisation = Real(kernel_gradient_normalisation);
  const std::uint32_t begin = 0, same_fluid = static_cast<std::uint32_t>(neighbour.size());
  const std::uint16_t source = 0;
  FluidSums<D, Real> sums{};
  neighbour.resize(neighbour.size() + 64);
  FluidKernelTask<D, Real> task{fluid.data(), &begin, &same_fluid, neighbour.data(),
                                &source,      &law,   &sums,       static_cast<Real>(unit.unit)};
  const std::uint8_t is_graded = 1;
  correction.resize(correction.size() + 64, Real(1));
  length.resize(length.size() + 64, Real(1));
  if (matter.graded) {
    task.graded = &is_graded;
    task.correction = correction.data();
    task.length_ratio = length.data();
  }
  fluid_kernels().get<D, Real>()(task, 0, 1);
  return sums;
}

template <int D, class Real>
void expect_same_sums(const Matter& matter) {
  const double tolerance = sizeof(Real) == 4 ? 2e-5 : 1e-13;  // roundings of sums of some terms
  for (int count : {2, 3, 16, 17, 18, 33, 90}) {
    const auto drops = cloud<D>(count, 7u + static_cast<unsigned>(count), matter.graded);
    const auto due = plain_sums<D>(drops, matter);
    const auto is = simd_sums<D, Real>(drops, matter);
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
  for (const Matter& matter : {Matter{}, Matter{2.0, false}, Matter{0.0, true}}) {
    expect_same_sums<2, float>(matter);
    expect_same_sums<3, float>(matter);
    expect_same_sums<2, double>(matter);
    expect_same_sums<3, double>(matter);
  }
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
