// SPDX-License-Identifier: Apache-2.0
// Deformation paths, and the tensors of plastic laws as Eigen matrices, for tests.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <functional>
#include <random>

#include "materials/plastic_law.hpp"

namespace kerf::test {

using Matrix3 = Eigen::Matrix3d;

inline ElasticModuli<double> steel() {
  ElasticModuli<double> solid;
  solid.bulk_modulus = 159e9;
  solid.shear_modulus = 77e9;
  return solid;
}

inline ElasticModuli<float> in_single(const ElasticModuli<double>& solid) {
  return {static_cast<float>(solid.bulk_modulus), static_cast<float>(solid.shear_modulus)};
}

inline PlasticParameters<double> linear_hardening(double yield_stress, double modulus) {
  PlasticParameters<double> parameters;
  parameters.law = PlasticLaw::von_mises;
  parameters.von_mises.yield_stress = yield_stress;
  parameters.von_mises.modulus = modulus;
  return parameters;
}

// AISI 4340 of Johnson & Cook (1983, 1985).
inline PlasticParameters<double> steel_4340() {
  PlasticParameters<double> parameters;
  parameters.law = PlasticLaw::johnson_cook;
  parameters.johnson_cook = {792e6, 510e6, 0.26, 0.014, 1.0, 1.03};
  parameters.damage = {0.05, 3.44, -2.12, 0.002, 0.61, 1.0, 0.01};
  parameters.heat = {7830.0 * 477.0, 0.9, 294.0, 294.0, 1793.0};
  return parameters;
}

template <int D>
Matrix<D, double> gradient_of(const Matrix3& f) {  // H of F
  Matrix<D, double> h;
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) h(a, b) = f(a, b) - (a == b ? 1.0 : 0.0);
  return h;
}

template <int D>
Matrix<D, float> single(const Matrix<D, double>& h) {
  Matrix<D, float> result;
  for (int k = 0; k < D * D; ++k) result.component[k] = static_cast<float>(h.component[k]);
  return result;
}

template <int D, class T>
Matrix3 matrix_of(const SymmetricTensor<D, T>& s) {
  Matrix3 m = Matrix3::Zero();
  m(2, 2) = static_cast<double>(s(2, 2));
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) m(a, b) = static_cast<double>(s(a, b));
  return m;
}

template <int D, class T>
Matrix3 kirchhoff(const Matrix3& f, const PlasticResult<D, T>& result) {
  return f * matrix_of(result.stress) * f.transpose();
}

template <int D, class T>
Matrix3 plastic_metric(const PlasticState<D, T>& state) {  // C_p^-1
  return Matrix3::Identity() + matrix_of(state.metric);
}

inline double equivalent_stress(const Matrix3& stress) {
  const Matrix3 s = stress - stress.trace() / 3.0 * Matrix3::Identity();
  return std::sqrt(1.5) * s.norm();
}

// Applies a function to a symmetric matrix by the iterative solver of Eigen.
template <class Function>
Matrix3 of_symmetric(const Matrix3& m, const Function& function) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(m);
  const Eigen::Vector3d values = solver.eigenvalues().unaryExpr(function);
  return solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
}
inline Matrix3 log_of(const Matrix3& m) {
  return of_symmetric(m, [](double x) { return std::log(x); });
}
inline Matrix3 exp_of(const Matrix3& m) {
  return of_symmetric(m, [](double x) { return std::exp(x); });
}

// F(s) for s from 0 to 1 with F(0) = 1; in two dimensions there is no deformation along z.
using Path = std::function<Matrix3(double)>;

inline Matrix3 random_matrix(std::mt19937& engine, int dimension, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  Matrix3 m = Matrix3::Zero();
  for (int a = 0; a < dimension; ++a)
    for (int b = 0; b < dimension; ++b) m(a, b) = uniform(engine);
  return m;
}

// A curved path: H = s A + sin(3 s) B.
inline Path bending_path(std::mt19937& engine, int dimension, double size) {
  const Matrix3 straight = random_matrix(engine, dimension, size);
  const Matrix3 bend = random_matrix(engine, dimension, size);
  return [=](double s) -> Matrix3 {
    return Matrix3::Identity() + s * straight + std::sin(3.0 * s) * bend;
  };
}

// The same path at constant volume.
inline Path at_constant_volume(const Path& path, int dimension) {
  return [=](double s) -> Matrix3 {
    Matrix3 f = path(s);
    f.topLeftCorner(dimension, dimension) *= std::pow(f.determinant(), -1.0 / dimension);
    return f;
  };
}

template <int D>
struct PathEnd {
  PlasticResult<D, double> result;
  double work = 0.0;     // by the trapezoidal rule on P : dF, J/m^3
  double plastic = 0.0;  // sum of the plastic work
};

// Takes `steps` equal steps along the path in the time `duration`.
template <int D>
PathEnd<D> follow(const ElasticModuli<double>& solid, const PlasticParameters<double>& parameters,
                  const Path& path, int steps, double duration = 0.0) {
  PathEnd<D> end{};
  end.result.state = PlasticState<D, double>::virgin();
  Matrix3 piola = Matrix3::Zero(), before = Matrix3::Identity();
  for (int n = 1; n <= steps; ++n) {
    const Matrix3 f = path(static_cast<double>(n) / steps);
    end.result = advance(solid, parameters, gradient_of<D>(f), duration / steps, end.result.state);
    const Matrix3 reached = f * matrix_of(end.result.stress);
    end.work += 0.5 * (piola + reached).cwiseProduct(f - before).sum();
    end.plastic += end.result.plastic_work;
    piola = reached;
    before = f;
  }
  return end;
}

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;

}  // namespace kerf::test
