// SPDX-License-Identifier: Apache-2.0
// Flow of metals against closed forms and against a return mapping that stores the plastic part of
// the deformation.
#include <cstring>

#include "support/plastic_paths.hpp"

namespace kerf::test {
namespace {

template <class Dimension>
class MetalFlow : public testing::Test {};
TYPED_TEST_SUITE(MetalFlow, Dimensions);

// The same step in another form (Weber & Anand 1990): F_p is stored, strains are logarithms of full
// matrices in the intermediate configuration, and bisection finds the flow.
struct PlasticPartOracle {
  ElasticModuli<double> solid;
  J2Hardening<double> law;
  Matrix3 plastic = Matrix3::Identity();  // F_p
  double plastic_strain = 0.0;

  Matrix3 second_piola(const Matrix3& f) {
    const double g = solid.shear_modulus;
    const Matrix3 elastic = f * plastic.inverse(), one = Matrix3::Identity();
    const Matrix3 strain = 0.5 * log_of(elastic.transpose() * elastic);
    Matrix3 deviator = 2.0 * g * (strain - strain.trace() / 3.0 * one);
    const double trial = equivalent_stress(deviator);
    double low = 0.0, high = trial / (3.0 * g);
    for (int k = 0; k < 100; ++k) {
      const double middle = 0.5 * (low + high);
      const double strength = law.strength(plastic_strain + middle, 0.0, 0.0);
      (trial - 3.0 * g * middle > strength ? low : high) = middle;
    }
    if (trial > law.strength(plastic_strain, 0.0, 0.0)) {
      const Matrix3 direction = 1.5 / trial * deviator;
      plastic = exp_of(low * direction) * plastic;
      plastic_strain += low;
      deviator *= 1.0 - 3.0 * g * low / trial;
    }
    // The stress is pulled back from the intermediate to the reference configuration: S = F_p^-1
    // S_e F_p^-T, and S_e is the Mandel stress times C_e^-1, which has the same axes.
    const Matrix3 mandel = deviator + solid.bulk_modulus * strain.trace() * one;
    const Matrix3 after = f * plastic.inverse();
    const Matrix3 back = plastic.inverse();
    return back * mandel * (after.transpose() * after).inverse() * back.transpose();
  }
};

// The tolerance is some fifty roundings of b_e of size 4 in strains, times the modulus.
TYPED_TEST(MetalFlow, FollowsThePlasticStrain) {
  constexpr int D = TypeParam::value;
  std::mt19937 engine(1);
  auto parameters = linear_hardening(700e6, 2e9);
  parameters.von_mises.saturation_stress = 300e6;
  parameters.von_mises.saturation_strain = 0.05;
  for (int n = 0; n < 20; ++n) {
    const Path path = bending_path(engine, D, 0.3);
    PlasticPartOracle oracle{steel(), parameters.von_mises};
    auto state = PlasticState<D, double>::virgin();
    for (int k = 1; k <= 30; ++k) {
      const Matrix3 f = path(k / 30.0);
      const auto result = advance(steel(), parameters, gradient_of<D>(f), 0.0, state);
      state = result.state;
      const Matrix3 off = matrix_of(result.stress) - oracle.second_piola(f);
      ASSERT_LE(off.cwiseAbs().maxCoeff(), 1e-12 * steel().bulk_modulus);
      ASSERT_NEAR(state.plastic_strain, oracle.plastic_strain, 1e-12);
    }
    EXPECT_GT(state.plastic_strain, 0.02);
  }
}

// For a bar with free sides tau = E (eps - eps_p) = sigma_0 + H eps_p in logarithmic strain, so tau
// = (sigma_0 + H eps) / (1 + H / E), and the true stress is tau / J, ln J = (1 - 2 nu) tau / E. The
// flow keeps its direction, so that long steps are exact too.
TEST(MetalBar, Tension) {
  const double yield = 400e6, modulus = 1e9;
  const double k = steel().bulk_modulus, e = steel().young_modulus();
  const double nu = 0.5 - e / (6.0 * k);
  auto state = PlasticState<3, double>::virgin();
  for (double strain : {0.001, 0.01, 0.1, 0.5, 1.0}) {
    const double elastic_limit = yield / e;
    const double tau =
        strain < elastic_limit ? e * strain : (yield + modulus * strain) / (1.0 + modulus / e);
    const double plastic = strain - tau / e;
    const double side = -nu * tau / e - 0.5 * plastic;
    const Matrix3 f =
        Eigen::Vector3d(std::exp(strain), std::exp(side), std::exp(side)).asDiagonal();
    const auto result =
        advance(steel(), linear_hardening(yield, modulus), gradient_of<3>(f), 0.0, state);
    state = result.state;
    const double true_stress = kirchhoff(f, result)(0, 0) / f.determinant();
    EXPECT_NEAR(true_stress, tau * std::exp(-(1.0 - 2.0 * nu) * tau / e), 1e-12 * k);
    EXPECT_NEAR(kirchhoff(f, result)(1, 1), 0.0, 1e-12 * k);
    EXPECT_NEAR(state.plastic_strain, plastic, 1e-12);
  }
}

// F = diag(exp(eps), exp(-eps), 1): q = 2 sqrt(3) G (eps - sqrt(3)/2 eps_p).
TYPED_TEST(MetalFlow, PlaneStretchAtConstantVolume) {
  constexpr int D = TypeParam::value;
  const double yield = 400e6, modulus = 1e9, g = steel().shear_modulus;
  auto state = PlasticState<D, double>::virgin();
  for (double strain : {0.002, 0.02, 0.2, 0.8}) {
    const Matrix3 f = Eigen::Vector3d(std::exp(strain), std::exp(-strain), 1.0).asDiagonal();
    const auto result =
        advance(steel(), linear_hardening(yield, modulus), gradient_of<D>(f), 0.0, state);
    state = result.state;
    const double trial = 2.0 * std::sqrt(3.0) * g * strain;
    const double plastic = trial > yield ? (trial - yield) / (3.0 * g + modulus) : 0.0;
    EXPECT_NEAR(state.plastic_strain, plastic, 1e-12);
    EXPECT_NEAR(equivalent_stress(kirchhoff(f, result)), trial - 3.0 * g * plastic, 1e-12 * g);
  }
}

// In simple shear of a metal without hardening the stress in steady flow is sigma_0 / sqrt(3) and
// the flow grows by shear / sqrt(3), except for the elastic strain, sigma_0 / G, by which the axes
// of the flow lag. The steps add an error of their own size.
TYPED_TEST(MetalFlow, SimpleShear) {
  constexpr int D = TypeParam::value;
  const double yield = 400e6, elastic = yield / steel().shear_modulus;
  const Path shear = [](double s) -> Matrix3 {
    Matrix3 f = Matrix3::Identity();
    f(0, 1) = 3.0 * s;
    return f;
  };
  const auto half = follow<D>(
      steel(), linear_hardening(yield, 0.0), [&](double s) { return shear(0.5 * s); }, 3000);
  const auto end = follow<D>(steel(), linear_hardening(yield, 0.0), shear, 6000);
  const Matrix3 stress = kirchhoff(shear(1.0), end.result);
  EXPECT_NEAR(stress(0, 1), yield / std::sqrt(3.0), elastic * yield);
  EXPECT_LE(std::abs(stress(0, 0)), elastic * yield);
  EXPECT_LE(std::abs(stress(2, 2)), elastic * yield);
  const double grown = end.result.state.plastic_strain - half.result.state.plastic_strain;
  EXPECT_NEAR(grown, 1.5 / std::sqrt(3.0), elastic * 1.5);
}

// A rotation of the body along its path changes neither S nor the state, up to rounding.
TYPED_TEST(MetalFlow, IsIndependentOfRotation) {
  constexpr int D = TypeParam::value;
  std::mt19937 engine(4);
  const Eigen::Vector3d axis =
      D == 2 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(1, -2, 3).normalized().eval();
  for (int n = 0; n < 10; ++n) {
    const Path path = bending_path(engine, D, 0.3);
    const Path turning = [&](double s) -> Matrix3 {
      return Eigen::AngleAxisd(5.0 * s, axis).toRotationMatrix() * path(s);
    };
    const auto still = follow<D>(steel(), steel_4340(), path, 50, 1e-5);
    const auto turned = follow<D>(steel(), steel_4340(), turning, 50, 1e-5);
    const Matrix3 off = matrix_of(still.result.stress) - matrix_of(turned.result.stress);
    EXPECT_LE(off.cwiseAbs().maxCoeff(), 1e-11 * steel().bulk_modulus);
    EXPECT_NEAR(still.result.state.plastic_strain, turned.result.state.plastic_strain, 1e-12);
    EXPECT_NEAR(still.result.state.temperature_rise, turned.result.state.temperature_rise, 1e-8);
    EXPECT_NEAR(still.result.state.damage, turned.result.state.damage, 1e-11);
  }
}

// det C_p = 1: each of 2000 steps may round the metric once, either way.
TYPED_TEST(MetalFlow, KeepsTheVolume) {
  constexpr int D = TypeParam::value;
  std::mt19937 engine(5);
  for (int n = 0; n < 10; ++n) {
    const Path path = bending_path(engine, D, 0.4);
    const auto end = follow<D>(steel(), linear_hardening(400e6, 1e9), path, 2000);
    EXPECT_GT(end.result.state.plastic_strain, 0.1);
    EXPECT_NEAR(plastic_metric(end.result.state).determinant(), 1.0, 1e-12);
  }
}

// All work of the stress is stored or dissipated; the rest is the error of steps, of first order.
TYPED_TEST(MetalFlow, WorkIsStoredOrDissipated) {
  constexpr int D = TypeParam::value;
  std::mt19937 engine(6);
  for (const auto& parameters : {linear_hardening(400e6, 1e9), steel_4340()})
    for (int n = 0; n < 10; ++n) {
      const Path path = at_constant_volume(bending_path(engine, D, 0.2), D);
      const auto error = [&](int steps) {
        const auto end = follow<D>(steel(), parameters, path, steps, 1e-5);
        EXPECT_GT(end.plastic, 5.0 * end.result.stored_energy);
        return (end.work - end.result.stored_energy - end.plastic) / end.work;
      };
      const double coarse = error(500), fine = error(1000);
      EXPECT_LE(std::abs(fine), 2e-3);
      EXPECT_NEAR(fine / coarse, 0.5, 0.25);
    }
}

// Backward Euler: the error of the stress halves with the step.
TYPED_TEST(MetalFlow, StepsConverge) {
  constexpr int D = TypeParam::value;
  std::mt19937 engine(7);
  for (int n = 0; n < 5; ++n) {
    const Path path = at_constant_volume(bending_path(engine, D, 0.2), D);
    const auto stress = [&](int steps) {
      return matrix_of(follow<D>(steel(), steel_4340(), path, steps, 1e-5).result.stress).eval();
    };
    const Matrix3 reference = stress(25600);
    const double coarse = (stress(200) - reference).norm(), fine = (stress(400) - reference).norm();
    EXPECT_LE(fine, 5e-3 * reference.norm());
    EXPECT_NEAR(fine / coarse, 0.5, 0.1);
  }
}

// Unloading does not change the state, and a second evaluation of a step gives the same result.
TYPED_TEST(MetalFlow, UnloadingKeepsTheState) {
  constexpr int D = TypeParam::value;
  const auto at = [](double strain) {
    return gradient_of<D>(Eigen::Vector3d(std::exp(strain), std::exp(-strain), 1.0).asDiagonal());
  };
  const auto bytes_differ = [](const auto& a, const auto& b) {
    return std::memcmp(&a, &b, sizeof a) != 0;
  };
  const auto virgin = PlasticState<D, double>::virgin();
  const auto loaded = advance(steel(), steel_4340(), at(0.1), 1e-6, virgin);
  EXPECT_GT(loaded.plastic_work, 0.0);
  EXPECT_FALSE(bytes_differ(loaded, advance(steel(), steel_4340(), at(0.1), 1e-6, virgin)));
  const auto unloaded = advance(steel(), steel_4340(), at(0.099), 1e-6, loaded.state);
  EXPECT_FALSE(bytes_differ(loaded.state, unloaded.state));
  EXPECT_EQ(unloaded.plastic_work, 0.0);
  EXPECT_LT(unloaded.stored_energy, loaded.stored_energy);
}

// 1000 steps in single precision against double precision. Stress: four roundings of b_e, 6e-8
// each, times G. Accumulated values are rounded in each step in either direction: sqrt(1000)
// roundings, 2e-6.
TYPED_TEST(MetalFlow, SinglePrecision) {
  constexpr int D = TypeParam::value;
  std::mt19937 engine(8);
  const auto solid = in_single(steel());
  const auto parameters = PlasticParameters<float>::from(steel_4340());
  for (int n = 0; n < 10; ++n) {
    const Path path = at_constant_volume(bending_path(engine, D, 0.2), D);
    const auto expected = follow<D>(steel(), steel_4340(), path, 1000, 1e-5);
    PlasticResult<D, float> result{};
    result.state = PlasticState<D, float>::virgin();
    for (int k = 1; k <= 1000; ++k) {
      const auto h = single(gradient_of<D>(path(k / 1000.0)));
      result = advance(solid, parameters, h, 1e-8F, result.state);
    }
    const Matrix3 off = matrix_of(result.stress) - matrix_of(expected.result.stress);
    EXPECT_LE(off.cwiseAbs().maxCoeff(), 2.4e-7 * steel().shear_modulus);
    EXPECT_NEAR(plastic_metric(result.state).determinant(), 1.0, 2e-6);
    const auto& state = expected.result.state;
    EXPECT_NEAR(result.state.plastic_strain, state.plastic_strain, 2e-6 * state.plastic_strain);
    EXPECT_NEAR(result.state.temperature_rise, state.temperature_rise,
                2e-6 * state.temperature_rise);
    EXPECT_NEAR(result.state.damage, state.damage, 2e-6 * state.damage);
  }
}

}  // namespace
}  // namespace kerf::test
