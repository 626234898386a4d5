// SPDX-License-Identifier: Apache-2.0
// Rock against Mohr & Coulomb's closed forms, and its return against a search of the nearest point.
#include "support/plastic_paths.hpp"

namespace kerf::test {
namespace {

const double cohesion = 10e6, friction = 0.6, no_cut_off = 1e12;

ElasticModuli<double> rock() {
  ElasticModuli<double> solid;
  solid.bulk_modulus = 20e9;
  solid.shear_modulus = 15e9;
  return solid;
}

PlasticParameters<double> rock_law(double dilation, double cut_off, ConeMatch match) {
  PlasticParameters<double> parameters;
  parameters.law = PlasticLaw::drucker_prager;
  parameters.drucker_prager =
      DruckerPrager<double>::of(cohesion, friction, dilation, cut_off, match);
  return parameters;
}

double excess(const DruckerPrager<double>& cone, const Eigen::Vector3d& stress) {
  const double q = equivalent_stress(Matrix3(stress.asDiagonal()));
  return q + cone.friction * stress.mean() - cone.strength;
}

// Strength of a cylinder under the pressure p: p N + 2 c sqrt(N), N = (1 + sin phi)/(1 - sin phi).
double mohr_coulomb_strength(double pressure) {
  const double n = (1.0 + std::sin(friction)) / (1.0 - std::sin(friction));
  return pressure * n + 2.0 * cohesion * std::sqrt(n);
}

// In axial compression two principal stresses are the smaller ones; in lateral compression two are
// the larger ones.
TEST(DruckerPragerCone, TouchesMohrCoulomb) {
  const auto outer = rock_law(0.0, no_cut_off, ConeMatch::compression).drucker_prager;
  const auto inner = rock_law(0.0, no_cut_off, ConeMatch::extension).drucker_prager;
  for (double pressure : {-2e6, 0.0, 5e6, 80e6}) {
    const double most = mohr_coulomb_strength(pressure), rounding = 1e-14 * most;
    EXPECT_NEAR(excess(outer, {-most, -pressure, -pressure}), 0.0, 10.0 * rounding);
    EXPECT_NEAR(excess(inner, {-most, -most, -pressure}), 0.0, 10.0 * rounding);
    EXPECT_GT(excess(inner, {-most, -pressure, -pressure}), 0.0);  // the inner cone is weaker
    EXPECT_LT(excess(outer, {-most, -most, -pressure}), 0.0);
  }
}

TEST(DruckerPragerCone, WithoutFrictionIsVonMises) {
  const auto cone = DruckerPrager<double>::of(10e6, 0.0, 0.0, 3e6, ConeMatch::compression);
  EXPECT_NEAR(cone.strength, 20e6, 1e-7);  // 2 c
  EXPECT_EQ(cone.friction, 0.0);
  EXPECT_EQ(cone.tension, 3e6);
}

// A free cylinder is compressed beyond its strength: tau stays at 2 c cos phi / (1 - sin phi), with
// no lateral stress, while the strain is elastic plus gamma (-1 + m/3, 1/2 + m/3, 1/2 + m/3), with
// m the slope of the flow. The direction is constant, so that any step is exact.
TEST(DruckerPragerCylinder, UniaxialCompressiveStrength) {
  const double strength = 2.0 * cohesion * std::cos(friction) / (1.0 - std::sin(friction));
  const double e = rock().young_modulus(), nu = 0.5 - e / (6.0 * rock().bulk_modulus);
  for (double dilation : {0.0, 0.2, friction}) {
    const auto parameters = rock_law(dilation, no_cut_off, ConeMatch::compression);
    const double m = parameters.drucker_prager.dilation;
    auto state = PlasticState<3, double>::virgin();
    for (double gamma : {1e-4, 1e-2, 0.1, 0.3}) {
      const double axial = -strength / e + gamma * (m / 3.0 - 1.0);
      const double side = nu * strength / e + gamma * (m / 3.0 + 0.5);
      const Matrix3 f =
          Eigen::Vector3d(std::exp(side), std::exp(axial), std::exp(side)).asDiagonal();
      const auto result = advance(rock(), parameters, gradient_of<3>(f), 0.0, state);
      state = result.state;
      const Matrix3 stress = kirchhoff(f, result);
      EXPECT_NEAR(stress(1, 1), -strength, 1e-12 * rock().bulk_modulus);
      EXPECT_NEAR(stress(0, 0), 0.0, 1e-12 * rock().bulk_modulus);
      EXPECT_NEAR(state.plastic_strain, gamma, 1e-12);
      // ln det C_p = 2 m gamma: only dilation changes the volume.
      EXPECT_NEAR(-0.5 * std::log(plastic_metric(state).determinant()), m * gamma, 1e-12);
    }
  }
}

// Plane strain in steady flow along the normal of the cone follows Mohr & Coulomb's (sigma_1 -
// sigma_3)/2 = c cos phi - sin phi (sigma_1 + sigma_3)/2, and the ratio of the rates of volume and
// shear is sin psi. The remaining share of the elastic strain decreases with the strain.
TEST(DruckerPragerPlane, CollapseOfMohrCoulomb) {
  const auto parameters = rock_law(friction, no_cut_off, ConeMatch::plane_strain);
  auto state = PlasticState<2, double>::virgin();
  const double sine = std::sin(friction);
  Eigen::Vector3d strain = Eigen::Vector3d::Zero();
  for (int n = 1; n <= 2000; ++n) {  // at constant stress: the volume grows by sin psi of the shear
    strain += 1e-4 * Eigen::Vector3d(0.5 * (1.0 + sine), -0.5 * (1.0 - sine), 0.0);
    const Matrix3 f = strain.array().exp().matrix().asDiagonal();
    const auto result = advance(rock(), parameters, gradient_of<2>(f), 0.0, state);
    state = result.state;
    if (n < 1000) continue;
    const Matrix3 stress = kirchhoff(f, result);
    const double radius = 0.5 * (stress(0, 0) - stress(1, 1));
    const double centre = 0.5 * (stress(0, 0) + stress(1, 1));
    EXPECT_NEAR(radius, cohesion * std::cos(friction) - sine * centre, 1e-6 * cohesion);
  }
}

TEST(DruckerPragerPlane, DilationIsTheSineOfItsAngle) {
  const double psi = 0.25;
  const auto parameters = rock_law(psi, no_cut_off, ConeMatch::plane_strain);
  auto state = PlasticState<2, double>::virgin();
  Matrix3 stress = Matrix3::Zero();
  double change = 0.0;
  for (int n = 1; n <= 2000; ++n) {
    const double shear = 1e-4 * n, volume = std::sin(psi) * shear;
    const Matrix3 f =
        Eigen::Vector3d(std::exp(0.5 * (volume + shear)), std::exp(0.5 * (volume - shear)), 1.0)
            .asDiagonal();
    const auto result = advance(rock(), parameters, gradient_of<2>(f), 0.0, state);
    state = result.state;
    const Matrix3 now = kirchhoff(f, result);
    change = (now - stress).cwiseAbs().maxCoeff();
    stress = now;
  }
  EXPECT_LE(change, 1e-9 * cohesion);  // steady: the strain increment is plastic
}

template <class Dimension>
class Rock : public testing::Test {};
TYPED_TEST_SUITE(Rock, Dimensions);

// In triaxial tension the mean stress stops at the cap, or at the apex without a cap.
TYPED_TEST(Rock, TensionStopsAtTheCap) {
  constexpr int D = TypeParam::value;
  const double apex = cohesion / std::tan(friction);
  for (double cut_off : {2e6, 0.0, no_cut_off}) {
    const auto parameters = rock_law(0.0, cut_off, ConeMatch::compression);
    const double most = std::min(cut_off, apex);
    EXPECT_NEAR(parameters.drucker_prager.tension, most, 1e-14 * apex);
    Matrix3 f = Matrix3::Identity();
    for (int a = 0; a < D; ++a) f(a, a) = 1.01;
    f(0, 1) = 1e-5;
    const auto pulled =
        advance(rock(), parameters, gradient_of<D>(f), 0.0, PlasticState<D, double>::virgin());
    const Matrix3 stress = kirchhoff(f, pulled);
    EXPECT_NEAR(stress.trace() / 3.0, most, 1e-13 * rock().bulk_modulus);
    EXPECT_LE(equivalent_stress(stress), parameters.drucker_prager.strength -
                                             parameters.drucker_prager.friction * most +
                                             1e-13 * rock().bulk_modulus);
    // The gap must close before the rock is under pressure again: at F = 1 it is under pressure.
    const auto back = advance(rock(), parameters, Matrix<D, double>::zero(), 0.0, pulled.state);
    EXPECT_LT(matrix_of(back.stress).trace(), -3.0 * most);
  }
}

// With associated flow the return is the admissible point nearest to the trial in the energy (q -
// q')^2 / 6 G + (p - p')^2 / 2 K (Simo 1992). The search follows the edges of the region.
TEST(DruckerPragerReturn, IsTheNearestPoint) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto cone = rock_law(friction, 4e6, ConeMatch::compression).drucker_prager;
  const double g = rock().shear_modulus, k = rock().bulk_modulus;
  const double edge =
      cone.strength - cone.friction * cone.tension;  // q at the intersection of cone and cap
  int capped = 0, edged = 0;
  for (int n = 0; n < 300; ++n) {
    const MeridianStress<double> trial{30e6 * (1.0 + uniform(engine)), 20e6 * uniform(engine)};
    const bool inside = trial.equivalent + cone.friction * trial.mean <= cone.strength &&
                        trial.mean <= cone.tension;
    const auto distance = [&](double q, double p) {
      return std::pow(q - trial.equivalent, 2) / (6.0 * g) +
             std::pow(p - trial.mean, 2) / (2.0 * k);
    };
    double least = inside ? 0.0 : 1e300;
    for (int step = 0; step <= 20000 && !inside; ++step) {
      const double s = step / 20000.0, q = edge + 80e6 * s;
      least = std::min(least, distance(edge * s, cone.tension));
      least = std::min(least, distance(q, (cone.strength - q) / cone.friction));
    }
    const auto flow = cone.flow(rock(), trial);
    const double q = trial.equivalent - 3.0 * g * flow.shear, p = trial.mean - k * flow.volume;
    EXPECT_LE(q + cone.friction * p, cone.strength * (1.0 + 1e-14));
    EXPECT_LE(p, cone.tension * (1.0 + 1e-14));
    // A step of the search is 4 kPa: beside the minimum an error of distance^2 / 6 G remains.
    EXPECT_NEAR(distance(q, p), least, 4e3 * 4e3 / (2.0 * k) + 1e-14 * least);
    const bool is_capped = !inside && std::abs(p - cone.tension) < 1.0;
    capped += is_capped;
    edged += is_capped && std::abs(q - edge) < 1.0;
  }
  EXPECT_GT(capped, edged);
  EXPECT_GT(edged, 20);
}

// Plastic flow dissipates work and never adds it; the remaining difference is the error of the
// steps.
TYPED_TEST(Rock, WorkIsStoredOrDissipated) {
  constexpr int D = TypeParam::value;
  std::mt19937 engine(4);
  for (double dilation : {0.0, 0.3, friction})
    for (int n = 0; n < 10; ++n) {
      const auto parameters = rock_law(dilation, 3e6, ConeMatch::compression);
      const Path path = bending_path(engine, D, 0.02);
      auto state = PlasticState<D, double>::virgin();
      for (int k = 1; k <= 100; ++k) {
        const auto result =
            advance(rock(), parameters, gradient_of<D>(path(k / 100.0)), 0.0, state);
        EXPECT_GE(result.plastic_work, 0.0);
        state = result.state;
      }
      const auto error = [&](int steps) {
        const auto end = follow<D>(rock(), parameters, path, steps);
        return std::abs(end.work - end.result.stored_energy - end.plastic) /
               (end.result.stored_energy + end.plastic);
      };
      EXPECT_LE(error(2000), 2e-3);
      EXPECT_LE(error(8000), 0.5 * error(2000));
    }
}

// A rotation of the rock along its path changes rounding only.
TYPED_TEST(Rock, IsIndependentOfRotation) {
  constexpr int D = TypeParam::value;
  std::mt19937 engine(5);
  const Eigen::Vector3d axis =
      D == 2 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(1, -2, 3).normalized().eval();
  const auto parameters = rock_law(0.3, 3e6, ConeMatch::extension);
  for (int n = 0; n < 10; ++n) {
    const Path path = bending_path(engine, D, 0.05);
    const Path turning = [&](double s) -> Matrix3 {
      return Eigen::AngleAxisd(5.0 * s, axis).toRotationMatrix() * path(s);
    };
    const auto still = follow<D>(rock(), parameters, path, 50).result;
    const auto turned = follow<D>(rock(), parameters, turning, 50).result;
    const Matrix3 off = matrix_of(still.stress) - matrix_of(turned.stress);
    EXPECT_LE(off.cwiseAbs().maxCoeff(), 1e-11 * rock().bulk_modulus);
    EXPECT_NEAR(still.state.plastic_strain, turned.state.plastic_strain, 1e-12);
  }
}

// 1000 steps in single precision against double precision: sqrt(1000) roundings of 6e-8 in strain,
// of the deviator and, since flow changes it, of the volume.
TYPED_TEST(Rock, SinglePrecision) {
  constexpr int D = TypeParam::value;
  std::mt19937 engine(6);
  const auto parameters = rock_law(0.3, 3e6, ConeMatch::compression);
  for (int n = 0; n < 10; ++n) {
    const Path path = bending_path(engine, D, 0.05);
    const auto expected = follow<D>(rock(), parameters, path, 1000).result;
    PlasticResult<D, float> result{};
    result.state = PlasticState<D, float>::virgin();
    for (int k = 1; k <= 1000; ++k)
      result = advance(in_single(rock()), PlasticParameters<float>::from(parameters),
                       single(gradient_of<D>(path(k / 1000.0))), 0.0F, result.state);
    const Matrix3 off = matrix_of(result.stress) - matrix_of(expected.stress);
    EXPECT_LE(off.cwiseAbs().maxCoeff(), 2e-6 * rock().bulk_modulus);
    EXPECT_NEAR(result.state.plastic_strain, expected.state.plastic_strain, 2e-6);
  }
}

}  // namespace
}  // namespace kerf::test
