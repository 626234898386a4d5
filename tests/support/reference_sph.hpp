// SPDX-License-Identifier: Apache-2.0
// The equations of Shinohara et al. (2004) as plain double loops over all pairs, in double
// precision on three-dimensional Eigen matrices. This oracle shares no code with the
// engine except the plain data of a Medium.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "model/medium.hpp"

namespace kerf::test {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

struct ReferenceParticle {
  Vector3 position = Vector3::Zero();  // m
  Vector3 velocity = Vector3::Zero();  // m/s
  Matrix3 shear = Matrix3::Zero();     // Pa, deviatoric stress of a solid
  double compression = 0.0;
  std::size_t source = 0;
  bool fractured = false;
  bool repelling = false;
};

struct ReferenceState {
  int dimension = 2;
  std::vector<Medium<double>> media;
  std::vector<ReferenceParticle> particles;
  Vector3 gravity = Vector3::Zero();
  double epsilon = 0.0;  // artificial stress
  double exponent = 4.0;

  const Medium<double>& medium(std::size_t i) const { return media[particles[i].source]; }
  double density(std::size_t i) const {
    return medium(i).density * (1.0 + particles[i].compression);
  }
};

struct ReferenceRate {
  double compression_rate = 0.0;           // 1/s
  double pressure = 0.0;                   // Pa
  Matrix3 gradient = Matrix3::Zero();      // 1/s
  Matrix3 moment = Matrix3::Zero();        // 1, the gradient of the positions
  Matrix3 spin = Matrix3::Zero();          // 1/s, of solid
  Matrix3 shear = Matrix3::Zero();         // Pa, viscous or deviatoric
  Matrix3 artificial = Matrix3::Zero();    // R of Gray, Monaghan & Swift
  Vector3 acceleration = Vector3::Zero();  // m/s^2
  Vector3 repulsion = Vector3::Zero();     // m/s^2, part of the acceleration
  double repulsion_potential = 0.0;        // J/kg
};

// Eqs. (5), (6) as printed for 2D, and the 3D spline of Monaghan (1992).
inline double paper_kernel(double r, double h, int dimension) {
  const double s = r / h, pi = std::numbers::pi;
  if (s >= 2.0) return 0.0;
  const double inner = 2.0 / 3.0 - s * s + 0.5 * s * s * s;
  const double outer = (2.0 - s) * (2.0 - s) * (2.0 - s);
  if (dimension == 2)
    return (s < 1.0 ? 15.0 / (7.0 * pi) * inner : 5.0 / (14.0 * pi) * outer) / (h * h);
  return (s < 1.0 ? 3.0 / (2.0 * pi) * inner : 1.0 / (4.0 * pi) * outer) / (h * h * h);
}

inline double paper_kernel_slope(double r, double h, int dimension) {
  const double s = r / h, pi = std::numbers::pi;
  if (s >= 2.0) return 0.0;
  const double inner = -2.0 * s + 1.5 * s * s;
  const double outer = -3.0 * (2.0 - s) * (2.0 - s);
  if (dimension == 2)
    return (s < 1.0 ? 15.0 / (7.0 * pi) * inner : 5.0 / (14.0 * pi) * outer) / (h * h * h);
  return (s < 1.0 ? 3.0 / (2.0 * pi) * inner : 1.0 / (4.0 * pi) * outer) / (h * h * h * h);
}

class ReferenceSph {
 public:
  explicit ReferenceSph(const ReferenceState& state)
      : state_(state), rates_(state.particles.size()) {
    for_each_pair(&ReferenceSph::add_continuity);
    for (std::size_t i = 0; i < rates_.size(); ++i) set_stress(i);
    for (std::size_t i = 0; i < rates_.size(); ++i)
      if (!is_rigid(i)) rates_[i].acceleration = state_.gravity;
    for_each_pair(&ReferenceSph::add_momentum);
    for_each_pair(&ReferenceSph::add_viscosity);
    for (std::size_t i = 0; i < rates_.size(); ++i)
      for (std::size_t j = 0; j < rates_.size(); ++j) add_repulsion(i, j);
  }
  const std::vector<ReferenceRate>& rates() const { return rates_; }

 private:
  struct Pair {
    std::size_t i, j;
    double h, distance;
    Vector3 separation, velocity, gradient;
  };

  bool is_rigid(std::size_t i) const { return state_.medium(i).phase == Phase::rigid; }

  // Returns whether tension and shear act between two particles: water and water, intact solid of
  // one piece.
  bool holds_together(std::size_t i, std::size_t j) const {
    const auto &a = state_.medium(i), &b = state_.medium(j);
    if (a.phase == Phase::water || b.phase == Phase::water) return a.phase == b.phase;
    return a.piece == b.piece && !state_.particles[i].fractured && !state_.particles[j].fractured;
  }

  void for_each_pair(void (ReferenceSph::*term)(const Pair&)) {
    for (std::size_t i = 0; i < rates_.size(); ++i)
      for (std::size_t j = 0; j < rates_.size(); ++j) {
        if (i == j || is_rigid(i) || is_rigid(j)) continue;
        Pair pair{i, j, 0.0, 0.0, {}, {}, {}};
        pair.separation = state_.particles[i].position - state_.particles[j].position;
        pair.velocity = state_.particles[i].velocity - state_.particles[j].velocity;
        pair.distance = pair.separation.norm();
        pair.h = 0.5 * (state_.medium(i).smoothing_length + state_.medium(j).smoothing_length);
        pair.gradient = paper_kernel_slope(pair.distance, pair.h, state_.dimension) /
                        pair.distance * pair.separation;
        (this->*term)(pair);
      }
  }

  // (22) and the velocity gradients in (30), (36), (37).
  void add_continuity(const Pair& pair) {
    const double m_j = state_.medium(pair.j).mass;
    rates_[pair.i].compression_rate +=
        m_j * pair.velocity.dot(pair.gradient) / state_.medium(pair.i).density;
    if (!holds_together(pair.i, pair.j)) return;
    const double volume = m_j / state_.density(pair.j);
    rates_[pair.i].gradient -= volume * pair.velocity * pair.gradient.transpose();
    rates_[pair.i].moment -= volume * pair.separation * pair.gradient.transpose();
  }

  // (37) with the gradient normalised, unless an eigenvalue of M is below 0.1.
  Matrix3 spin_of(const ReferenceRate& rate) const {
    const int d = state_.dimension;
    const Eigen::MatrixXd moment = rate.moment.topLeftCorner(d, d);
    Matrix3 gradient = rate.gradient;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> values(moment, Eigen::EigenvaluesOnly);
    if (values.eigenvalues().minCoeff() >= 0.1)
      gradient.topLeftCorner(d, d) = rate.gradient.topLeftCorner(d, d) * moment.inverse();
    return 0.5 * (gradient - gradient.transpose());
  }

  // (15), (28), (30), (31), (32); section 2.3.
  void set_stress(std::size_t i) {
    const auto& medium = state_.medium(i);
    const auto& particle = state_.particles[i];
    ReferenceRate& rate = rates_[i];
    if (medium.phase == Phase::rigid) return;
    const double ratio = 1.0 + particle.compression;
    if (medium.phase == Phase::water) {
      const double b = medium.sound_speed * medium.sound_speed * medium.density / 7.0;
      rate.pressure = b * (std::pow(ratio, 7.0) - 1.0);
      rate.shear = medium.viscosity * (rate.gradient + rate.gradient.transpose() -
                                       2.0 / 3.0 * rate.gradient.trace() * Matrix3::Identity());
      return;
    }
    rate.spin = spin_of(rate);
    rate.pressure = medium.bulk_modulus * (ratio - 1.0);
    if (particle.fractured) rate.pressure = std::max(rate.pressure, 0.0);
    rate.shear = particle.shear;
    if (particle.fractured || state_.epsilon == 0.0) return;
    // Principal stresses in the dimensions of the run.
    const int d = state_.dimension;
    const Matrix3 stress = rate.shear - rate.pressure * Matrix3::Identity();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(stress.topLeftCorner(d, d));
    Eigen::MatrixXd repelling = Eigen::MatrixXd::Zero(d, d);
    for (int k = 0; k < d; ++k)
      repelling -= state_.epsilon * std::max(axes.eigenvalues()(k), 0.0) *
                   axes.eigenvectors().col(k) * axes.eigenvectors().col(k).transpose();
    rate.artificial.topLeftCorner(d, d) = repelling / std::pow(state_.density(i), 2);
  }

  // (26) with (28), and the term of Gray et al.
  void add_momentum(const Pair& pair) {
    const std::size_t i = pair.i, j = pair.j;
    double p_i = rates_[i].pressure, p_j = rates_[j].pressure;
    Matrix3 shear = Matrix3::Zero(), artificial = Matrix3::Zero();
    const bool both_solid =
        state_.medium(i).phase == Phase::solid && state_.medium(j).phase == Phase::solid;
    if (holds_together(i, j)) {
      shear = rates_[i].shear + rates_[j].shear;
      const double spacing = 0.5 * (state_.medium(i).spacing + state_.medium(j).spacing);
      const double f = paper_kernel(pair.distance, pair.h, state_.dimension) /
                       paper_kernel(spacing, pair.h, state_.dimension);
      if (both_solid)
        artificial = std::pow(f, state_.exponent) * (rates_[i].artificial + rates_[j].artificial);
    } else if (both_solid) {
      p_i = std::max(p_i, 0.0);
      p_j = std::max(p_j, 0.0);
    }
    const Matrix3 stress = shear - (p_i + p_j) * Matrix3::Identity();
    const Matrix3 sum = stress / (state_.density(i) * state_.density(j)) + artificial;
    rates_[i].acceleration += state_.medium(j).mass * (sum * pair.gradient);
  }

  // (38), (39) with C h^2, opposing approach; water beside solid takes geometric means of A and B.
  void add_viscosity(const Pair& pair) {
    const auto &a = state_.medium(pair.i), &b = state_.medium(pair.j);
    const double approach = pair.velocity.dot(pair.separation);
    if (approach >= 0.0) return;
    const double softening = 0.5 * (a.artificial_softening + b.artificial_softening);
    const double theta =
        pair.h * approach / (pair.distance * pair.distance + softening * pair.h * pair.h);
    const double linear = std::sqrt(a.artificial_linear * b.artificial_linear);
    const double quadratic = std::sqrt(a.artificial_quadratic * b.artificial_quadratic);
    const double c = 0.5 * (a.sound_speed + b.sound_speed);
    const double rho = 0.5 * (state_.density(pair.i) + state_.density(pair.j));
    const double pi = (-linear * c * theta + quadratic * theta * theta) / rho;
    rates_[pair.i].acceleration -= b.mass * pi * pair.gradient;
  }

  // (43) and its integral from d to d_0.
  void add_repulsion(std::size_t i, std::size_t j) {
    if (is_rigid(i) || !is_rigid(j) || !state_.particles[j].repelling) return;
    const Vector3 separation = state_.particles[i].position - state_.particles[j].position;
    const double d = separation.norm();
    const double d_0 = 0.5 * (state_.medium(i).spacing + state_.medium(j).spacing);
    if (d > d_0) return;
    const double strength = state_.medium(j).repulsion, q = d_0 / d;
    const Vector3 force = strength * (std::pow(q, 4) - std::pow(q, 2)) / (d * d) * separation;
    rates_[i].repulsion += force;
    rates_[i].acceleration += force;
    rates_[i].repulsion_potential +=
        strength * (std::pow(q, 4) / 4.0 - std::pow(q, 2) / 2.0 + 0.25);
  }

  const ReferenceState& state_;
  std::vector<ReferenceRate> rates_;
};

}  // namespace kerf::test
