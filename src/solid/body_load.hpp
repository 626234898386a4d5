// SPDX-License-Identifier: Apache-2.0
// ApplyLoads is the force of given loads on solids (docs/theory/loads.md). A load acts on each of
// its particles with a share; at the factor q(t) of the load the force is
//   f = q A t     traction t per area of the reference configuration, A the area of the particle,
//   f = q m g     acceleration g,
//   f = - q p cof(F) A n    pressure p, A n the area vector; cof(F) = J F^-T turns and stretches it
//                           with the surface (Nanson's formula).
// A detached particle has no face: tractions and pressures do not act on it, nor on those behind it
// that take a part of the opposite sense (simulation/pressure_all_around.hpp).
#pragma once

#include "core/matrix.hpp"
#include "parallel/ordered_sum.hpp"
#include "particles/fields.hpp"

namespace kerf {

template <int D>
struct LoadShare {
  std::uint32_t load;
  Index bearer;                // the particle of the solid that has the face
  bool of_face;                // a traction or pressure
  bool follows;                // whether the force turns with the surface
  Vector<D, double> full;      // N (2D: N/m), at the factor 1 and without deformation
  Vector<D, double> turned{};  // the same, on the surface in the current step of the solid
};

// A particle with loads: its shares and the force on it.
template <int D>
struct LoadSite {
  Index particle;           // of the solid
  Index first, last;        // shares
  double mass;              // kg (2D: kg/m)
  Vector<D, double> force;  // N (2D: N/m), in the current step
};

// Returns cof(H + 1), which maps area vectors.
template <int D, class T>
KERF_FUNCTION Matrix<D, double> cofactor(const Matrix<D, T>& h) {
  Matrix<D, double> f, cofactors;
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) f(a, b) = double(h(a, b)) + (a == b ? 1.0 : 0.0);
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) {
      if constexpr (D == 2) {
        cofactors(a, b) = (a == b ? 1.0 : -1.0) * f(1 - a, 1 - b);
      } else {
        const int i = (a + 1) % 3, j = (a + 2) % 3, k = (b + 1) % 3, l = (b + 2) % 3;
        cofactors(a, b) = f(i, k) * f(j, l) - f(i, l) * f(j, k);
      }
    }
  return cofactors;
}

// Turns the loads that follow the surface with it, at the deformation of the current step of the
// solid; its later substeps keep them.
template <int D, class P>
struct TurnLoads {
  const Matrix<D, typename P::Real>* gradient;  // H, by particle of the solid
  const LoadSite<D>* sites;
  LoadShare<D>* shares;

  KERF_FUNCTION void operator()(Index k) const {
    const auto turn = cofactor(gradient[sites[k].particle]);
    for (Index n = sites[k].first; n < sites[k].last; ++n)
      if (shares[n].follows) shares[n].turned = turn * shares[n].full;
  }
};

// Adds the acceleration by loads. `particle_of`: the index of each particle of the solid among all
// particles, or `no_particle`.
template <int D, class P>
struct ApplyLoads {
  using Real = typename P::Real;
  ParticleView<D, P> particles;
  const Index* particle_of;
  Index no_particle;
  const std::uint8_t* detached;  // by particle of the solid
  const double* factor;          // q, by load
  const LoadShare<D>* shares;
  LoadSite<D>* sites;

  KERF_FUNCTION void operator()(Index k) const {
    LoadSite<D>& site = sites[k];
    site.force = Vector<D, double>::zero();
    const Index i = particle_of[site.particle];
    if (i == no_particle || particles.is_constrained(i)) return;
    auto force = Vector<D, double>::zero();
    for (Index n = site.first; n < site.last; ++n) {
      const LoadShare<D>& share = shares[n];
      if (share.of_face && (detached[site.particle] || detached[share.bearer])) continue;
      force += factor[share.load] * share.turned;
    }
    const auto acceleration = Vector<D, Real>::from((1.0 / site.mass) * force);
    particles.acceleration[i] += acceleration;
    site.force = site.mass * Vector<D, double>::from(acceleration);  // as rounded
  }
};

// The force of all loads, its sum by magnitude, and their work over the step that has ended.
template <int D, class P>
struct LoadSum {
  enum Slot { force = 0, work = D, magnitude, slots };
  ParticleView<D, P> particles;
  const Index* particle_of;
  Index no_particle;
  const LoadSite<D>* sites;

  KERF_FUNCTION void add(Index k, Terms<slots>& sum) const {
    const LoadSite<D>& site = sites[k];
    const Index i = particle_of[site.particle];
    if (i == no_particle) return;
    for (int a = 0; a < D; ++a) sum.value[force + a] += site.force[a];
    sum.value[magnitude] += norm(site.force);
    sum.value[work] += dot(site.force, particles.position[i] - particles.start_position[i]);
  }
};

}  // namespace kerf
