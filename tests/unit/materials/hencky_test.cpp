// SPDX-License-Identifier: Apache-2.0
// The elastic part of solids with plastic flow against finite differences of its energy.
#include "materials/hencky.hpp"

#include "support/plastic_paths.hpp"

namespace kerf::test {
namespace {

template <class Dimension>
class Hencky : public testing::Test {};
TYPED_TEST_SUITE(Hencky, Dimensions);

// A plastic metric of volume one, and one of any volume.
template <int D>
PlasticState<D, double> flowed(std::mt19937& engine, double size, bool keeps_volume) {
  Matrix3 strain = random_matrix(engine, D, size);
  strain = (strain + strain.transpose()).eval();
  if (keeps_volume) strain(2, 2) -= strain.trace();
  const Matrix3 inverse_metric = exp_of(strain);
  auto state = PlasticState<D, double>::virgin();
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b)
      if (a == b || b < D) state.metric(a, b) = inverse_metric(a, b) - (a == b ? 1.0 : 0.0);
  return state;
}

double hencky_energy(const ElasticModuli<double>& solid, const Matrix3& f,
                     const Matrix3& inverse_metric) {
  const Matrix3 e = 0.5 * log_of(f * inverse_metric * f.transpose());
  const Matrix3 deviator = e - e.trace() / 3.0 * Matrix3::Identity();
  return solid.shear_modulus * deviator.squaredNorm() +
         0.5 * solid.bulk_modulus * e.trace() * e.trace();
}

// Fourth-order difference: truncation (1e-3)^4 / 30 times a fifth derivative of some 1e3 K.
template <int D>
void expect_stress_is_slope(const ElasticModuli<double>& solid,
                            const PlasticParameters<double>& parameters, const Matrix3& f,
                            const PlasticState<D, double>& state) {
  const Matrix3 inverse_metric = plastic_metric(state);
  const auto result = advance(solid, parameters, gradient_of<D>(f), 0.0, state);
  EXPECT_NEAR(result.stored_energy, hencky_energy(solid, f, inverse_metric),
              1e-12 * solid.bulk_modulus);
  const Matrix3 piola = f * matrix_of(result.stress);
  const double step = 1e-3;
  for (int k = 0; k < D * D; ++k) {
    const auto at = [&](double shift) {
      Matrix3 moved = f;
      moved(k / D, k % D) += shift;
      return hencky_energy(solid, moved, inverse_metric);
    };
    const double slope =
        (8.0 * (at(step) - at(-step)) - (at(2.0 * step) - at(-2.0 * step))) / (12.0 * step);
    EXPECT_NEAR(piola(k / D, k % D), slope, 1e-8 * solid.bulk_modulus);
  }
}

TYPED_TEST(Hencky, StressIsTheSlopeOfTheEnergy) {
  constexpr int D = TypeParam::value;
  std::mt19937 engine(1);
  PlasticParameters<double> metal, rock;  // with a strength above all stresses
  rock.law = PlasticLaw::drucker_prager;
  rock.drucker_prager.strength = rock.drucker_prager.tension = 1e20;
  int tried = 0;
  for (int n = 0; n < 60; ++n) {
    const Matrix3 f = Matrix3::Identity() + random_matrix(engine, D, 0.35);
    if (f.determinant() < 0.3) continue;
    ++tried;
    expect_stress_is_slope<D>(steel(), metal, f, PlasticState<D, double>::virgin());
    expect_stress_is_slope<D>(steel(), metal, f, flowed<D>(engine, 0.2, true));
    expect_stress_is_slope<D>(steel(), rock, f, flowed<D>(engine, 0.2, false));
  }
  EXPECT_GT(tried, 30);
}

// The tolerance is relative to the stress of such a strain, not to the modulus: some thirty
// roundings of 6e-8.
TYPED_TEST(Hencky, SinglePrecisionKeepsSmallStrains) {
  constexpr int D = TypeParam::value;
  std::mt19937 engine(2);
  const PlasticParameters<double> parameters;
  for (double size : {0.3, 1e-3, 1e-6})
    for (int n = 0; n < 100; ++n) {
      const auto h = gradient_of<D>(Matrix3::Identity() + random_matrix(engine, D, size));
      auto state = flowed<D>(engine, 0.3 * size, true);
      auto state_single = PlasticState<D, float>::virgin();
      for (int k = 0; k < SymmetricTensor<D, double>::count; ++k)
        state_single.metric.component[k] = static_cast<float>(state.metric.component[k]);
      const auto expected = matrix_of(advance(steel(), parameters, h, 0.0, state).stress);
      const auto stress =
          matrix_of(advance(in_single(steel()), PlasticParameters<float>::from(parameters),
                            single<D>(h), 0.0F, state_single)
                        .stress);
      const double scale = size * steel().bulk_modulus;
      EXPECT_LE((stress - expected).cwiseAbs().maxCoeff(), 1e-5 * scale) << size;
    }
}

}  // namespace
}  // namespace kerf::test
