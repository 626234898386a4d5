// SPDX-License-Identifier: Apache-2.0
// Artificial stress of Gray, Monaghan & Swift (2001), against the tensile instability of a solid;
// off by default. In the principal axes of the stress, R = -epsilon sigma / rho^2
// where sigma > 0, else 0; each pair gets
//   dv_i/dt = sum_j m_j (R_i + R_j) f^n . nabla_i W_ij,   f = W(d_ij) / W(spacing).
#pragma once

#include <Eigen/Dense>

#include "core/tensor.hpp"
#include "kernels/cubic_spline.hpp"
#include "pairs/pair.hpp"

namespace kerf {

// Returns the tensor with its negative principal values set to zero, by Eigen's closed forms.
template <int D, class T>
KERF_FUNCTION SymmetricTensor<D, T> tensile_part(const SymmetricTensor<D, T>& tensor) {
  Eigen::Matrix<T, D, D> in_plane;
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) in_plane(a, b) = tensor(a, b);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<T, D, D>> solver;
  solver.computeDirect(in_plane);
  auto result = SymmetricTensor<D, T>::zero();
  for (int k = 0; k < D; ++k) {
    const T value = solver.eigenvalues()(k);
    if (!(value > T(0))) continue;
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b)
        result(a, b) += value * solver.eigenvectors()(a, k) * solver.eigenvectors()(b, k);
  }
  return result;
}

template <int D, class P>
struct TensileRepulsion {
  using Real = typename P::Real;
  static constexpr bool includes_rigid = false;
  struct Sum {
    Vector<D, Real> repulsive{};
    Real opposed_power{};
  };
  Real exponent;  // n

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!pair.cohesive || pair.medium_i->phase != Phase::solid) return;
    const Real h = pair.smoothing_length;
    const Real spacing = Real(0.5) * (pair.medium_i->spacing + pair.medium_j->spacing);
    const Real f = CubicSpline<D>::value(pair.distance, h) / CubicSpline<D>::value(spacing, h);
    const auto stress = particles.artificial_stress[pair.i] + particles.artificial_stress[pair.j];
    const auto force = (pair.medium_j->mass * std::pow(f, exponent)) * (stress * pair.gradient);
    sum.repulsive += force;
    sum.opposed_power -= Real(0.5) * dot(pair.velocity, force);
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    particles.acceleration[i] += sum.repulsive;
    particles.artificial_power[i] += sum.opposed_power;
  }
};

// R of one particle, from its stress -p + s.
template <int D, class P>
struct ArtificialStressTensor {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  Real epsilon;

  KERF_FUNCTION void operator()(Index i) const {
    auto result = SymmetricTensor<D, Real>::zero();
    if (particles.medium(i).phase == Phase::solid && !particles.fractured[i]) {
      auto stress = particles.shear[i];
      for (int a = 0; a < 3; ++a) stress(a, a) -= particles.pressure[i];
      const Real density = particles.density(i);
      result = tensile_part(stress);
      result *= -epsilon / (density * density);
    }
    particles.artificial_stress[i] = result;
  }
};

}  // namespace kerf
