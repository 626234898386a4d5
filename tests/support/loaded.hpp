// SPDX-License-Identifier: Apache-2.0
// The particles of a ReferenceState on the device with their neighbour list, and their results in
// the order of the ReferenceState.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "core/precision.hpp"
#include "neighbours/neighbour_list.hpp"
#include "particles/reorder.hpp"
#include "shinohara2004/rates.hpp"
#include "simulation/media.hpp"
#include "support/reference_sph.hpp"

namespace kerf::test {

struct ListChoice {
  double minimum = 0.0, maximum = 0.014;  // m, of the domain along every axis
  double skin = 5e-4;                     // m
  bool splits = false;                    // neighbours of the same fluid come first
};

template <int D, class P, class Scheme = JointPairs>
class Loaded {
 public:
  using Real = typename P::Real;

  Loaded(const ReferenceState& state, const ListChoice& choice) {
    load_media(state);
    load_particles(state);
    auto minimum = Vector<D, double>::zero(), maximum = minimum;
    double longest = 0.0;
    for (int a = 0; a < D; ++a) {
      minimum[a] = choice.minimum;
      maximum[a] = choice.maximum;
    }
    for (const auto& medium : state.media) longest = std::max(longest, medium.smoothing_length);
    list = NeighbourList<D, P, Scheme>(minimum, maximum, 2.0 * longest, choice.skin);
    if (choice.splits) list.sort_neighbours_by_class();
    rebuild();
  }

  void rebuild() {
    particles.build_position = particles.position;
    sort_particles(particles, list.cell_numbers(particles));
    list.build(particles);
  }

  // Index in the arrays of each particle of the ReferenceState.
  std::vector<std::size_t> places() const {
    const auto id = to_host(particles.id);
    std::vector<std::size_t> place(id.size());
    for (std::size_t k = 0; k < id.size(); ++k) place[id[k]] = k;
    return place;
  }

  // Neighbours of each particle of the ReferenceState, as indices into it, in the list's order.
  std::vector<std::vector<std::size_t>> neighbours() const {
    const auto id = to_host(particles.id);
    const NeighbourView view = list.view();
    std::vector<std::vector<std::size_t>> result(id.size());
    for (std::size_t k = 0; k < id.size(); ++k)
      for (Index n = view.begin[k]; n < view.end[k]; ++n)
        result[id[k]].push_back(id[view.neighbour[n]]);
    return result;
  }

  Particles<D, P> particles;
  NeighbourList<D, P, Scheme> list;

 private:
  void load_media(const ReferenceState& state) {
    std::vector<Medium<Real>> media;
    for (const auto& medium : state.media) media.push_back(Medium<Real>::from(medium));
    to_device(media, particles.media);
  }

  void load_particles(const ReferenceState& state) {
    particles.resize(static_cast<Index>(state.particles.size()));
    for (std::size_t k = 0; k < state.particles.size(); ++k) {
      const ReferenceParticle& from = state.particles[k];
      particles.position[k] = Vector<D, double>::from(from.position);
      particles.velocity[k] = Vector<D, Real>::from(from.velocity);
      particles.compression[k] = static_cast<Real>(from.compression);
      auto shear = SymmetricTensor<D, Real>::zero();
      for (int a = 0; a < 3; ++a) shear(a, a) = static_cast<Real>(from.shear(a, a));
      for (int a = 0; a < D; ++a)
        for (int b = a + 1; b < D; ++b) shear(a, b) = static_cast<Real>(from.shear(a, b));
      particles.shear[k] = shear;
      particles.pressure_work[k] = Real(0);
      particles.inlet_column[k] = 0;
      particles.id[k] = static_cast<std::uint32_t>(k);
      particles.source[k] = static_cast<std::uint16_t>(from.source);
      particles.fractured[k] = from.fractured ? 1 : 0;
      if (particles.undamaged.size() > k)
        particles.undamaged[k] = state.medium(k).tensile_excess > 0.0 ? 1 : 0;
      particles.flags[k] = from.repelling ? flag::repelling : std::uint8_t{0};
    }
  }
};

// Convert vectors and tensors of the engine to Eigen, with zeros in the third dimension.
template <int D, class T>
Vector3 as_eigen(const Vector<D, T>& v) {
  Vector3 result = Vector3::Zero();
  for (int a = 0; a < D; ++a) result[a] = static_cast<double>(v[a]);
  return result;
}
template <int D, class T>
Matrix3 as_eigen(const Matrix<D, T>& m) {
  Matrix3 result = Matrix3::Zero();
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) result(a, b) = static_cast<double>(m(a, b));
  return result;
}
template <int D, class T>
Matrix3 as_eigen(const SkewTensor<D, T>& w) {
  Matrix3 result = Matrix3::Zero();
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) result(a, b) = static_cast<double>(w(a, b));
  return result;
}
template <int D, class T>
Matrix3 as_eigen(const SymmetricTensor<D, T>& s) {
  Matrix3 result = Matrix3::Zero();
  for (int a = 0; a < 3; ++a) result(a, a) = static_cast<double>(s(a, a));
  for (int a = 0; a < D; ++a)
    for (int b = a + 1; b < D; ++b) result(a, b) = result(b, a) = static_cast<double>(s(a, b));
  return result;
}

}  // namespace kerf::test
