// SPDX-License-Identifier: Apache-2.0
// Contact of bodies of the `standard` formulation as plain double loops
// (docs/theory/solid_contact.md). This oracle shares no code with the engine except the plain data
// of a Medium.
#pragma once

#include <cmath>
#include <utility>

#include "support/reference_sph.hpp"

namespace kerf::test {

// Wendland C2, support 2 h: dW/dr = - 5 alpha / h q (1 - q/2)^3.
inline double wendland_slope(double r, double h, int dimension) {
  const double q = r / h, pi = std::numbers::pi;
  if (q >= 2.0) return 0.0;
  const double alpha = dimension == 2 ? 7.0 / (4.0 * pi * h * h) : 21.0 / (16.0 * pi * h * h * h);
  return -5.0 * alpha / h * q * std::pow(1.0 - q / 2.0, 3);
}

// Wendland C2: W = alpha (1 - q/2)^4 (2 q + 1).
inline double wendland(double r, double h, int dimension) {
  const double q = r / h, pi = std::numbers::pi;
  if (q >= 2.0) return 0.0;
  const double alpha = dimension == 2 ? 7.0 / (4.0 * pi * h * h) : 21.0 / (16.0 * pi * h * h * h);
  return alpha * std::pow(1.0 - q / 2.0, 4) * (2.0 * q + 1.0);
}

struct ReferenceContactForce {
  Vector3 normal = Vector3::Zero();  // N
  Vector3 drag = Vector3::Zero();    // N
};

class ReferenceContact {
 public:
  explicit ReferenceContact(const ReferenceState& state)
      : state_(state), on_solids_(state.particles.size()), on_rigid_(state.particles.size()) {
    for (std::size_t i = 0; i < on_solids_.size(); ++i) {
      if (state.medium(i).phase != Phase::solid || !is_body(i)) continue;
      on_solids_[i] = overlap(i, Phase::solid);
      on_rigid_[i] = overlap(i, Phase::rigid);
    }
  }

  // Returns whether the particles belong to two different bodies.
  bool are_in_contact(std::size_t i, std::size_t j) const {
    return i != j && is_body(i) && is_body(j) && state_.medium(i).piece != state_.medium(j).piece;
  }
  double energy(std::size_t i) const { return on_solids_[i].energy + on_rigid_[i].energy; }

  // Returns the force on i from j by the contact energy of i; the opposite force acts on j.
  ReferenceContactForce of(std::size_t i, std::size_t j) const {
    const auto &a = state_.medium(i), &b = state_.medium(j);
    const Overlap& own = b.phase == Phase::rigid ? on_rigid_[i] : on_solids_[i];
    const Vector3 separation = at(i).position - at(j).position;
    const double h = length(a, b);
    if (own.slope == 0.0 || separation.norm() >= 2.0 * h) return {};
    const double slope = wendland_slope(separation.norm(), h, state_.dimension);
    ReferenceContactForce force;
    force.normal =
        -own.slope * b.volume / first_contact(a, b).first * slope * separation.normalized();
    const double coefficient = std::min(a.friction, b.friction);
    if (coefficient == 0.0) return force;
    const Vector3 normal = own.gradient.normalized(), speed = at(i).velocity - at(j).velocity;
    const Vector3 along = speed - normal.dot(speed) * normal;
    const double creep =
        coefficient * own.slope * own.gradient.norm() * a.spacing / (a.mass * a.longitudinal_speed);
    force.drag =
        -coefficient * std::abs(force.normal.dot(normal)) / std::max(along.norm(), creep) * along;
    return force;
  }

 private:
  // The contact energy of a particle and its derivatives.
  struct Overlap {
    double slope = 0.0;   // derivative of the energy with respect to the kernel sum, J
    double energy = 0.0;  // J
    Vector3 gradient = Vector3::Zero();  // of the kernel sum, 1/m
  };

  const ReferenceParticle& at(std::size_t i) const { return state_.particles[i]; }
  bool is_body(std::size_t i) const {
    return state_.medium(i).phase != Phase::water && !at(i).fractured;
  }
  static double length(const Medium<double>& a, const Medium<double>& b) {
    return a.phase == b.phase ? (a.smoothing_length + b.smoothing_length) / 2.0
                              : std::max(a.smoothing_length, b.smoothing_length);
  }

  // Returns the kernel sum at `a` of a lattice of `b` that fills a half-space, and its derivative
  // with respect to the approach; the mean over the positions opposite a particle and between two.
  std::pair<double, double> first_contact(const Medium<double>& a, const Medium<double>& b) const {
    const double h = length(a, b), d = b.spacing, first = (a.spacing + d) / 2.0;
    const int reach = 2 + static_cast<int>(2.0 * h / d), side = 2 * reach + 1;
    const int deep = state_.dimension == 3 ? side : 1;
    double kernel_sum = 0.0, slope = 0.0;
    for (double aside : {0.0, 0.5})
      for (int k = 0; k < side * deep * (reach + 1); ++k) {
        const int x = k % side - reach, z = k / side % deep - (deep > 1 ? reach : 0);
        const Vector3 to((x + aside) * d, first + k / (side * deep) * d,
                         deep > 1 ? (z + aside) * d : 0.0);
        const double volume = std::pow(d, state_.dimension) / 2.0, r = to.norm();
        kernel_sum += volume * wendland(r, h, state_.dimension);
        slope -= volume * wendland_slope(r, h, state_.dimension) * to[1] / r;
      }
    return {kernel_sum, slope};
  }

  Overlap overlap(std::size_t i, Phase phase) const {
    Overlap result;
    double kernel_sum = 0.0;
    const auto& a = state_.medium(i);
    for (std::size_t j = 0; j < state_.particles.size(); ++j) {
      const auto& b = state_.medium(j);
      if (!are_in_contact(i, j) || b.phase != phase) continue;
      const Vector3 separation = at(i).position - at(j).position;
      const double h = length(a, b), r = separation.norm();
      if (r >= 2.0 * h) continue;
      const double full = first_contact(a, b).first;
      kernel_sum += b.volume / full * wendland(r, h, state_.dimension);
      result.gradient += b.volume / full * wendland_slope(r, h, state_.dimension) * separation / r;
    }
    if (kernel_sum <= 1.0) return {};
    const auto [full, slope] = first_contact(a, a);
    const double share = phase == Phase::rigid ? 1.0 : 0.5;
    const double stiffness = a.volume * (a.total_bulk_modulus + 4.0 / 3.0 * a.shear_modulus) *
                             std::pow(full / (slope * a.spacing), 2) * share;
    result.slope = stiffness * (kernel_sum - 1.0);
    result.energy = stiffness * (kernel_sum - 1.0) * (kernel_sum - 1.0) / 2.0;
    return result;
  }

  const ReferenceState& state_;
  std::vector<Overlap> on_solids_, on_rigid_;
};

}  // namespace kerf::test
