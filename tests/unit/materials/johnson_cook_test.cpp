// SPDX-License-Identifier: Apache-2.0
// Johnson & Cook's strength, heat and damage against their printed formulas.
#include "support/plastic_paths.hpp"

namespace kerf::test {
namespace {

// A line, a parabola, a root with infinite slope at zero, and a root close to zero.
TEST(FallingRoot, FindsTheRoot) {
  int calls = 0;
  const auto root = [&calls](auto&& f, double high, double accuracy) {
    calls = 0;
    const auto counted = [&](double x) { return ++calls, f(x); };
    const double x = regula_falsi(counted, high, accuracy);
    EXPECT_LE(std::abs(f(x)), accuracy);
    return x;
  };
  EXPECT_NEAR(root([](double x) { return 1.0 - 3.0 * x; }, 1.0, 1e-15), 1.0 / 3.0, 1e-15);
  EXPECT_EQ(calls, 3);
  EXPECT_NEAR(root([](double x) { return 2.0 - x * x; }, 2.0, 1e-14), std::sqrt(2.0), 1e-14);
  EXPECT_LE(calls, 12);
  for (double little : {1e-1, 1e-3, 1e-6}) {
    const double x = root([=](double y) { return little - std::pow(y, 0.26) - y; }, 1.0, 1e-15);
    EXPECT_NEAR(std::pow(x, 0.26) + x, little, 2e-15);
    EXPECT_LE(calls, 30) << little;
  }
  EXPECT_EQ(regula_falsi([](double x) { return -x - 1.0; }, 1.0, 1e-15), 0.0);
  EXPECT_EQ(regula_falsi([](double x) { return 2.0 - x; }, 1.0, 1e-15), 1.0);
}

// (792 + 510 * 0.1^0.26) (1 + 0.014 ln 1000) (1 - (206/1499)^1.03) MPa at eps_p = 0.1, 1000 /s and
// 500 K, worked out by hand: 1072.2658 * 1.0967086 * (1 - 0.1294815) = 1023.6977.
TEST(JohnsonCook, StrengthAsPrinted) {
  const auto parameters = steel_4340();
  const double homologous = parameters.heat.homologous_temperature(500.0 - 294.0);
  EXPECT_NEAR(homologous, 206.0 / 1499.0, 1e-15);
  const double strength = parameters.johnson_cook.strength(0.1, 1000.0, homologous);
  EXPECT_NEAR(strength, 1023.6977e6, 100.0);
  // The states are slow, cold and molten.
  EXPECT_EQ(parameters.johnson_cook.strength(0.0, 1e-3, 0.0), 792e6);
  EXPECT_EQ(parameters.heat.homologous_temperature(-50.0), 0.0);
  EXPECT_EQ(parameters.heat.homologous_temperature(5000.0), 1.0);
  EXPECT_EQ(parameters.johnson_cook.strength(0.5, 1e4, 1.0), 0.0);
}

// (0.05 + 3.44 exp(-2.12/3)) (1 + 0.002 ln 1000) (1 + 0.61 T*) in tension of a bar; with
// exp(-0.70666667) = 0.4932859 that is 1.74690 * 1.01381551 = 1.77104 when cold.
TEST(JohnsonCook, FailureStrainAsPrinted) {
  const auto damage = steel_4340().damage;
  EXPECT_NEAR(damage.failure_strain(1.0, 3.0, 1000.0, 0.0), 1.77104, 2e-5);
  EXPECT_NEAR(damage.failure_strain(1.0, 3.0, 1000.0, 0.5), 1.77104 * 1.305, 3e-5);
  const double most = 0.05 + 3.44 * std::exp(-2.12 * 1.5);
  EXPECT_NEAR(damage.failure_strain(1.5, 1.0, 0.0, 0.0), most, 1e-15);
  EXPECT_NEAR(damage.failure_strain(9.0, 1.0, 0.0, 0.0), most, 1e-15);  // constant above
  EXPECT_NEAR(damage.failure_strain(1.0, 0.0, 0.0, 0.0), most, 1e-15);  // molten
  EXPECT_GT(damage.failure_strain(-1.0, 0.0, 0.0, 0.0), 1e6);
  auto brittle = damage;
  brittle.constant = -5.0;
  EXPECT_EQ(brittle.failure_strain(1.0, 1.0, 0.0, 0.0), brittle.least_failure_strain);
}

template <class Dimension>
class JohnsonCookFlow : public testing::Test {};
TYPED_TEST_SUITE(JohnsonCookFlow, Dimensions);

// A change of shape at constant volume with an additional volume change of logarithm `volume`.
Matrix3 plane_stretch(double strain, double volume = 0.0) {
  const double more = 0.5 * volume;
  return Eigen::Vector3d(std::exp(strain + more), std::exp(more - strain), 1.0).asDiagonal();
}

// Stress, rate and temperature at the end of each step satisfy the printed yield function: to the
// accuracy of the root, 4 roundings of the trial stress, and that of b_e in it.
TYPED_TEST(JohnsonCookFlow, StressStaysOnTheYieldSurface) {
  constexpr int D = TypeParam::value;
  const auto parameters = steel_4340();
  const double dt = 1e-7, rate_0 = 1.0;
  auto state = PlasticState<D, double>::virgin();
  for (int n = 1; n <= 100; ++n) {
    const Matrix3 f = plane_stretch(5e-3 * n);
    const auto result = advance(steel(), parameters, gradient_of<D>(f), dt, state);
    const double eps = result.state.plastic_strain, rate = (eps - state.plastic_strain) / dt;
    const double t = result.state.temperature_rise / (1793.0 - 294.0);
    const double strength = (792e6 + 510e6 * std::pow(eps, 0.26)) *
                            (1.0 + 0.014 * std::log(rate / rate_0)) * (1.0 - std::pow(t, 1.03));
    EXPECT_NEAR(equivalent_stress(kirchhoff(f, result)), strength, 1e-13 * steel().bulk_modulus);
    EXPECT_NEAR(result.state.temperature_rise - state.temperature_rise,
                0.9 * result.plastic_work / (7830.0 * 477.0), 1e-11);
    state = result.state;
  }
  EXPECT_GT(state.temperature_rise, 100.0);
}

// Without hardening and with m = 1 the rise has a closed form: 1 - T* = exp(-share A eps_p / (c
// (T_m - T_r))) when it starts at T_r. Steps are of first order.
TYPED_TEST(JohnsonCookFlow, AdiabaticTemperature) {
  constexpr int D = TypeParam::value;
  auto parameters = steel_4340();
  parameters.johnson_cook = {792e6, 0.0, 1.0, 0.0, 1.0, 1.0};
  const auto error = [&](int steps) {
    const auto end = follow<D>(
        steel(), parameters, [](double s) { return plane_stretch(2.0 * s); }, steps);
    const double range = 1793.0 - 294.0, eps = end.result.state.plastic_strain;
    const double expected = range * -std::expm1(-0.9 * 792e6 * eps / (7830.0 * 477.0 * range));
    return end.result.state.temperature_rise / expected - 1.0;
  };
  const double coarse = error(200), fine = error(400);
  EXPECT_LE(std::abs(fine), 1e-3);
  EXPECT_NEAR(fine / coarse, 0.5, 0.02);
}

// Molten metal is a fluid: it has pressure and no shear stress.
TYPED_TEST(JohnsonCookFlow, MoltenMetalCarriesPressureOnly) {
  constexpr int D = TypeParam::value;
  auto state = PlasticState<D, double>::virgin();
  state.temperature_rise = 2000.0;
  const Matrix3 f = plane_stretch(0.1, -0.02);
  const auto result = advance(steel(), steel_4340(), gradient_of<D>(f), 1e-7, state);
  EXPECT_LE(equivalent_stress(kirchhoff(f, result)), 1e-13 * steel().bulk_modulus);
  EXPECT_NEAR(kirchhoff(f, result).trace() / 3.0, -0.02 * steel().bulk_modulus,
              1e-13 * steel().bulk_modulus);
  EXPECT_LE(result.state.damage, 1e-10);  // because it flows under very high pressure only
}

// A metal without hardening is stretched at a volume that keeps mean / q: it fails when the plastic
// strain reaches eps_f of that ratio, within one step.
TYPED_TEST(JohnsonCookFlow, DamageIsOneAtTheFailureStrain) {
  constexpr int D = TypeParam::value;
  auto parameters = linear_hardening(800e6, 0.0);
  parameters.damage = steel_4340().damage;
  for (double triaxiality : {-1.0 / 3.0, 0.0, 1.0 / 3.0, 1.0}) {
    const double volume = triaxiality * 800e6 / steel().bulk_modulus;
    const double failure = 0.05 + 3.44 * std::exp(-2.12 * triaxiality);
    auto state = PlasticState<D, double>::virgin();
    const double step = 1e-3;
    for (int n = 1; state.damage < 1.0 && n < 10000; ++n) {
      const Matrix3 f = plane_stretch(step * n, volume);
      state = advance(steel(), parameters, gradient_of<D>(f), 0.0, state).state;
      EXPECT_NEAR(state.damage, std::min(1.0, state.plastic_strain / failure), 1e-10);
    }
    EXPECT_EQ(state.damage, 1.0);
    EXPECT_NEAR(state.plastic_strain, failure, 2.0 * step);
  }
}

}  // namespace
}  // namespace kerf::test
