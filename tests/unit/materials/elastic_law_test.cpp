// SPDX-License-Identifier: Apache-2.0
// Elastic laws against finite differences of their energy, Hooke's law, and closed forms.
#include "materials/elastic_law.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace kerf::test {
namespace {

ElasticSolid<double> some_solid(ElasticLaw law) {
  ElasticSolid<double> solid;
  solid.elasticity = law;
  solid.bulk_modulus = 8.3e4;
  solid.shear_modulus = 3.8e4;
  solid.ogden.exponent = 7.0;
  return solid;
}

// First Piola-Kirchhoff stress, Pa.
template <int D, class T>
Matrix<D, T> piola(const ElasticSolid<T>& solid, const Matrix<D, T>& h) {
  return first_piola(second_piola(solid, green_strain(h)), h);
}

// The energies are written from their definitions in C and J, on Eigen's matrices.
double energy_by_definition(const ElasticSolid<double>& solid, const Eigen::Matrix3d& f) {
  const double g = solid.shear_modulus, k = solid.bulk_modulus;
  const Eigen::Matrix3d c = f.transpose() * f;
  if (solid.elasticity == ElasticLaw::neo_hookean) {
    const double j = f.determinant();
    return 0.5 * g * (std::pow(j, -2.0 / 3.0) * c.trace() - 3.0) +
           0.5 * k * (0.5 * (j * j - 1.0) - std::log(j));
  }
  if (solid.elasticity == ElasticLaw::ogden) {
    const double j = f.determinant(), alpha = solid.ogden.exponent;
    const Eigen::Vector3d stretch = f.jacobiSvd().singularValues() / std::cbrt(j);
    return 2.0 * g / (alpha * alpha) * (stretch.array().pow(alpha).sum() - 3.0) +
           0.5 * k * (0.5 * (j * j - 1.0) - std::log(j));
  }
  const Eigen::Matrix3d e = 0.5 * (c - Eigen::Matrix3d::Identity());
  return 0.5 * (k - 2.0 / 3.0 * g) * e.trace() * e.trace() + g * (e * e).trace();
}

template <int D>
Eigen::Matrix3d in_space(const Matrix<D, double>& h) {  // F of H
  Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) f(a, b) += h(a, b);
  return f;
}

template <class Dimension>
class Law : public testing::Test {
 protected:
  static Matrix<Dimension::value, double> random_gradient(std::mt19937& engine, double size) {
    std::uniform_real_distribution<double> uniform(-size, size);
    Matrix<Dimension::value, double> h;
    for (double& entry : h.component) entry = uniform(engine);
    return h;
  }
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Law, Dimensions);

const ElasticLaw laws[] = {ElasticLaw::neo_hookean, ElasticLaw::ogden,
                           ElasticLaw::st_venant_kirchhoff};

// Fourth-order difference: truncation (1e-3)^4 / 30 times a fifth derivative near 1e3 K.
template <int D>
void expect_slope(const ElasticSolid<double>& solid, const Matrix<D, double>& h) {
  const Eigen::Matrix3d f = in_space(h);
  const auto p = piola(solid, h);
  const double step = 1e-3;
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) {
      const auto at = [&](double shift) {
        Eigen::Matrix3d moved = f;
        moved(a, b) += shift;
        return energy_by_definition(solid, moved);
      };
      const double slope =
          (8.0 * (at(step) - at(-step)) - (at(2.0 * step) - at(-2.0 * step))) / (12.0 * step);
      EXPECT_NEAR(p(a, b), slope, 1e-8 * solid.bulk_modulus);
    }
}

TYPED_TEST(Law, StressIsTheSlopeOfTheEnergy) {
  std::mt19937 engine(1);
  for (ElasticLaw law : laws)
    for (int n = 0; n < 50; ++n) {
      const auto solid = some_solid(law);
      const auto h = this->random_gradient(engine, 0.4);
      const Eigen::Matrix3d f = in_space(h);
      if (f.determinant() < 0.2) continue;
      EXPECT_NEAR(energy_density(solid, green_strain(h)), energy_by_definition(solid, f),
                  1e-12 * solid.bulk_modulus);
      expect_slope(solid, h);
    }
}

// sigma = K tr(e) + 2 G dev(e), with the stress out of the plane; the rest is of second order.
template <int D>
void expect_hooke(const ElasticSolid<double>& solid, const Matrix<D, double>& h, double tolerance) {
  const Eigen::Matrix3d f = in_space(h), one = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d e = 0.5 * (f + f.transpose()) - one;
  const Eigen::Matrix3d hooke =
      2.0 * solid.shear_modulus * e +
      (solid.bulk_modulus - 2.0 / 3.0 * solid.shear_modulus) * e.trace() * one;
  const auto stress = cauchy(solid, h);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(stress(a, a), hooke(a, a), tolerance);
  for (int a = 0; a < D; ++a)
    for (int b = a; b < D; ++b) EXPECT_NEAR(stress(a, b), hooke(a, b), tolerance);
}

TYPED_TEST(Law, HookeAtSmallStrain) {
  std::mt19937 engine(2);
  for (ElasticLaw law : laws)
    for (double size : {1e-3, 1e-6}) {
      const auto solid = some_solid(law);
      const auto h = this->random_gradient(engine, size);
      expect_hooke(solid, h, 20.0 * size * size * solid.bulk_modulus);
    }
}

// Single precision keeps small strains: relative to the stress, not to the modulus.
TYPED_TEST(Law, SinglePrecision) {
  std::mt19937 engine(3);
  for (ElasticLaw law : laws)
    for (double size : {0.3, 1e-3, 1e-6}) {
      const auto solid = some_solid(law);
      const auto h = this->random_gradient(engine, size);
      Matrix<TypeParam::value, float> single;
      for (int k = 0; k < TypeParam::value * TypeParam::value; ++k)
        single.component[k] = static_cast<float>(h.component[k]);
      const auto p = piola(solid, h);
      const auto q = piola(ElasticSolid<float>::from(solid), single);
      for (int k = 0; k < TypeParam::value * TypeParam::value; ++k)
        EXPECT_NEAR(q.component[k], p.component[k], 5e-6 * size * solid.bulk_modulus);
    }
}

// An additional rotation does not change the energy and rotates the stress.
TYPED_TEST(Law, RotationTurnsTheStress) {
  constexpr int D = TypeParam::value;
  std::mt19937 engine(4);
  for (ElasticLaw law : laws) {
    const auto solid = some_solid(law);
    const auto h = this->random_gradient(engine, 0.3);
    Eigen::Matrix3d turn = Eigen::AngleAxisd(2.0, D == 2 ? Eigen::Vector3d::UnitZ().eval()
                                                         : Eigen::Vector3d(1, -2, 3).normalized())
                               .toRotationMatrix();
    const Eigen::Matrix3d turned = turn * in_space(h);
    Matrix<D, double> h_turned;
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) h_turned(a, b) = turned(a, b) - (a == b ? 1.0 : 0.0);
    EXPECT_NEAR(energy_density(solid, green_strain(h)),
                energy_density(solid, green_strain(h_turned)), 1e-12 * solid.bulk_modulus);
    const Eigen::Matrix3d p = in_space(piola(solid, h)), q = in_space(piola(solid, h_turned));
    const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d off = (q - one) - turn * (p - one);
    EXPECT_LE((off.topLeftCorner<D, D>().cwiseAbs().maxCoeff()), 1e-11 * solid.bulk_modulus);
  }
}

TYPED_TEST(Law, PrincipalValuesAreEigenvalues) {
  constexpr int D = TypeParam::value;
  std::mt19937 engine(5);
  for (int n = 0; n < 100; ++n) {
    const auto green = green_strain(this->random_gradient(engine, 0.4));
    Eigen::Matrix3d e = Eigen::Matrix3d::Zero();
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) e(a, b) = green(a, b);
    auto values = principal_values(green);
    std::sort(values.component, values.component + 3);
    const Eigen::Vector3d expected =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(e).eigenvalues();
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(values[a], expected[a], 1e-12);
  }
}

// With alpha = 2 it is the neo-Hookean solid.
TYPED_TEST(Law, OgdenWithTheExponentTwoIsNeoHookean) {
  std::mt19937 engine(6);
  auto ogden = some_solid(ElasticLaw::ogden), neo_hookean = some_solid(ElasticLaw::neo_hookean);
  ogden.ogden.exponent = 2.0;
  for (int n = 0; n < 20; ++n) {
    const auto h = this->random_gradient(engine, 0.3);
    const auto p = piola(ogden, h), q = piola(neo_hookean, h);
    for (int k = 0; k < TypeParam::value * TypeParam::value; ++k)
      EXPECT_NEAR(p.component[k], q.component[k], 1e-11 * ogden.bulk_modulus);
  }
}

// Diagonal gradient with the stretch along x and the same contraction across.
Matrix<3, double> stretched(double stretch, double across) {
  auto h = Matrix<3, double>::zero();
  h(0, 0) = stretch - 1.0;
  h(1, 1) = h(2, 2) = across - 1.0;
  return h;
}
// A tensile test of a nearly incompressible bar, whose sides are free: the force over the first
// section is 2 G / alpha (lambda^(alpha - 1) - lambda^(-1 - alpha / 2)) (Ogden 1972).
TEST(Ogden, TensileTest) {
  auto solid = some_solid(ElasticLaw::ogden);
  solid.bulk_modulus = 1e4 * solid.shear_modulus;
  for (const double alpha : {3.0, 12.0})
    for (const double stretch : {0.7, 1.1, 1.6}) {
      solid.ogden.exponent = alpha;
      double low = 0.5 * std::pow(stretch, -0.5), high = 4.0 * low;
      for (int n = 0; n < 60; ++n) {  // the contraction at which the sides are free
        const double across = 0.5 * (low + high);
        (piola(solid, stretched(stretch, across))(1, 1) > 0.0 ? high : low) = across;
      }
      const double force = 2.0 * solid.shear_modulus / alpha *
                           (std::pow(stretch, alpha - 1.0) - std::pow(stretch, -1.0 - alpha / 2.0));
      EXPECT_NEAR(piola(solid, stretched(stretch, low))(0, 0), force, 0.01 * std::abs(force));
    }
}

// The modulus of waves is the second derivative of the energy by a principal stretch, here by
// central differences; without strain that of longitudinal waves.
TEST(Ogden, LargestModulus) {
  const auto solid = some_solid(ElasticLaw::ogden);
  const double at_rest = solid.bulk_modulus + 4.0 / 3.0 * solid.shear_modulus;
  EXPECT_NEAR(wave_stiffening(solid, Vector<3, double>{}), 1.0, 1e-12);
  for (const Eigen::Vector3d& stretch :
       {Eigen::Vector3d(1.4, 0.9, 1.0), Eigen::Vector3d(0.6, 1.1, 1.2)}) {
    double largest = 0.0;
    Vector<3, double> green;
    for (int k = 0; k < 3; ++k) {
      green[k] = 0.5 * (stretch[k] * stretch[k] - 1.0);
      const auto at = [&](double shift) {
        Eigen::Vector3d moved = stretch;
        moved[k] += shift;
        return energy_by_definition(solid, moved.asDiagonal());
      };
      const double step = 1e-3;
      largest = std::max(largest, (at(step) - 2.0 * at(0.0) + at(-step)) / (step * step));
    }
    EXPECT_NEAR(wave_stiffening(solid, green) * at_rest, largest, 1e-4 * largest);
  }
  EXPECT_FALSE(stiffens_with_stretch(some_solid(ElasticLaw::neo_hookean)));
}

}  // namespace
}  // namespace kerf::test
