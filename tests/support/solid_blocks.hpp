// SPDX-License-Identifier: Apache-2.0
// Blocks of total Lagrangian solid for tests.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <random>

#include "solid/total_lagrangian.hpp"
#include "support/kinds.hpp"

namespace kerf::test {

using PlaneOnly = testing::Types<Kind<2, Double>, Kind<2, Mixed>>;
using DoubleOnly = testing::Types<Kind<2, Double>, Kind<3, Double>>;

// E = 1e5 Pa, nu = 0.3, as for the tofu of the cases.
inline Medium<double> soft_solid(double spacing, int dimension) {
  Medium<double> solid;
  solid.phase = Phase::solid;
  solid.density = 1000.0;
  solid.spacing = spacing;
  solid.smoothing_length = 1.3 * spacing;
  solid.mass = solid.density * std::pow(spacing, dimension);
  solid.bulk_modulus = 1e5 / (3.0 * (1.0 - 2.0 * 0.3));
  solid.shear_modulus = 1e5 / (2.0 * (1.0 + 0.3));
  return solid;
}

struct BlockChoice {
  std::array<int, 3> cells = {9, 8, 7};
  double spacing = 1e-3;  // m
  double jitter = 0.0;    // of the spacing
  unsigned seed = 1;
};

template <int D>
SolidLayout<D> block(const BlockChoice& choice, const Medium<double>& medium) {
  std::mt19937 engine(choice.seed);
  std::uniform_real_distribution<double> uniform(-choice.jitter, choice.jitter);
  SolidLayout<D> layout;
  layout.media = {medium};
  const int layers = D == 3 ? choice.cells[2] : 1;
  for (int k = 0; k < choice.cells[0] * choice.cells[1] * layers; ++k) {
    const int cell[3] = {k % choice.cells[0], k / choice.cells[0] % choice.cells[1],
                         k / (choice.cells[0] * choice.cells[1])};
    Vector<D, double> x;
    for (int a = 0; a < D; ++a) x[a] = choice.spacing * (cell[a] + 0.5 + uniform(engine));
    layout.reference.push_back(x);
    layout.medium_index.push_back(0);
  }
  return layout;
}

template <int D>
SolidLayout<D> block(const BlockChoice& choice) {
  return block<D>(choice, soft_solid(choice.spacing, D));
}

template <int D>
using Square = Eigen::Matrix<double, D, D>;

template <int D, class T>
Square<D> as_square(const Matrix<D, T>& m) {
  Square<D> e;
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) e(a, b) = m(a, b);
  return e;
}

template <int D>
Eigen::Matrix<double, D, 1> as_column(const Vector<D, double>& v) {
  return Eigen::Map<const Eigen::Matrix<double, D, 1>>(v.component);
}

// A linear map with stretch, shear and rotation of order one.
template <int D>
Square<D> some_map() {
  Square<D> m;
  if constexpr (D == 2)
    m << 1.1, 0.25, -0.3, 0.9;
  else
    m << 1.1, 0.25, -0.1, -0.3, 0.9, 0.2, 0.15, -0.05, 1.2;
  return m;
}

template <int D>
Square<D> rotation(double angle) {
  if constexpr (D == 2)
    return Eigen::Rotation2Dd(angle).toRotationMatrix();
  else
    return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
}

// A solid with the positions and velocities that the test sets.
template <int D, class P>
struct SolidOnTrial {
  using Real = typename P::Real;
  SolidLayout<D> layout;
  TotalLagrangian<D, P> solid;
  std::vector<Vector<D, double>> position;
  std::vector<Vector<D, Real>> velocity;
  Array<Vector<D, double>> device_position;
  Array<Vector<D, Real>> device_velocity;

  explicit SolidOnTrial(const SolidLayout<D>& chosen)
      : layout(chosen),
        solid(chosen),
        position(chosen.reference),
        velocity(chosen.reference.size(), Vector<D, Real>::zero()) {}

  std::size_t size() const { return position.size(); }
  void map(const Square<D>& m, double shift = 0.0) {
    for (std::size_t i = 0; i < size(); ++i)
      for (int a = 0; a < D; ++a) {
        position[i][a] = shift;
        for (int b = 0; b < D; ++b) position[i][a] += m(a, b) * layout.reference[i][b];
      }
  }
  void displace_randomly(double amplitude, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
    for (auto& x : position)
      for (int a = 0; a < D; ++a) x[a] += uniform(engine);
  }
  void deform(double dt = 0.0) {
    to_device(position, device_position);
    solid.deform(device_position, dt);
  }
  void evaluate() {
    deform();
    to_device(velocity, device_velocity);
    solid.accelerate(device_velocity);
  }
  Vector<D, double> force(std::size_t i) const {
    const Vector<D, Real> a = solid.fields().acceleration[i];
    return layout.media[layout.medium_index[i]].mass * Vector<D, double>::from(a);
  }
  Matrix<D, Real> gradient(std::size_t i) const { return solid.fields().gradient[i]; }
  // Kick, drift, kick; evaluate() must have been called before the first.
  void step(double dt) {
    kick(0.5 * dt);
    for (std::size_t i = 0; i < size(); ++i)
      position[i] += dt * Vector<D, double>::from(velocity[i]);
    evaluate();
    kick(0.5 * dt);
  }
  void kick(double dt) {
    const auto acceleration = to_host(solid.fields().acceleration);
    for (std::size_t i = 0; i < size(); ++i) velocity[i] += static_cast<Real>(dt) * acceleration[i];
  }
  double kinetic_energy() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < size(); ++i) {
      const auto v = Vector<D, double>::from(velocity[i]);
      sum += 0.5 * layout.media[layout.medium_index[i]].mass * dot(v, v);
    }
    return sum;
  }
};

}  // namespace kerf::test
