// SPDX-License-Identifier: Apache-2.0
// GradientAtWall completes the pressure gradient and the divergence of fluid beside a smooth rigid
// wall. Such a wall acts along its normal n only (fluid/rigid_wall.hpp), so that its particles have
// no part in what changes along it, and their part across it is that of a mirror image at the speed
// of the particle. The missing parts follow from the fluid beside, by
//   M^f = sum V_j S_ij d_ij d_ij^T over fluid,  M^w the same over the wall,  k (M^f + M^w) = 1
// within matter, with the kernel gradient normalisation k and t for the directions along the wall:
//   a_i      += k s / rho_i sum V_j (p_j - p_i) S_ij d_t,     s = tr_t M^w / tr_t M^f
//   div v_i  += k s sum V_j S_ij d_t . v_ij
//   div v_i  += k (n.M^w n - 2 y sum_w V_j S_ij d_n) / n.M^f n  sum V_j S_ij d_n n.v_ij
// with the distance y of i from the wall, and sums over a plane wall scaled by its factor f_i. They
// vanish in uniform pressure and uniform motion (docs/theory/riemann_sph.md). The wall takes the
// reaction.
#pragma once

#include "core/tensor.hpp"
#include "fluid/rigid_wall.hpp"

namespace kerf {

template <int D, class P>
struct GradientAtWall {
  using Real = typename P::Real;
  using RealVector = Vector<D, Real>;
  static constexpr bool includes_rigid = false;
  struct Sum {
    RealVector pressure{};                      // Pa/m, sum V_j (p_j - p_i) S_ij d_ij
    Matrix<D, Real> motion{}, fluid{}, wall{};  // 1/s: sum V S d v^T; 1: M^f, M^w
    RealVector normal{};                        // 1/m, sum a n_j with a = V_j S_ij d_ij . n_j
    Real facing{}, height{};                    // 1/m, sum a; 1, sum a y_j
  };
  // Of what the full support has: with less fluid beside it there is no gradient to complete.
  static constexpr double least_fluid = 0.2;
  Real kernel_gradient_normalisation;

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!(pair.distance > Real(0))) return;
    const RealVector& d = pair.separation;
    if (pair.medium_j->phase == Phase::rigid) {
      const Real weight = pair.medium_j->volume * pair.slope_per_distance;
      add_product(sum.wall, weight * d, d);
      const auto normal = pair.of_j(particles.face_normal[pair.j]);
      const Real along = dot(d, normal), height = along - particles.face_depth[pair.j];
      if (!(height > Real(0))) return;
      sum.normal += (weight * along) * normal;
      sum.facing += weight * along;
      sum.height += weight * along * height;
    } else if (particles.is_fluid(pair.j)) {
      const Real weight = volume_of(particles, pair.j, *pair.medium_j) * pair.slope_per_distance;
      sum.pressure += (weight * (particles.pressure[pair.j] - particles.pressure[pair.i])) * d;
      add_product(sum.motion, weight * d, pair.velocity);
      add_product(sum.fluid, weight * d, d);
    }
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const Real length = norm(sum.normal);
    if (!(length > Real(0))) return;
    const RealVector n = (Real(1) / length) * sum.normal;
    const Real fluid_across = across(sum.fluid, n), fluid_along = sum.fluid.trace() - fluid_across;
    const Real factor = kernel_gradient_normalisation * wall_force_factor(particles, i);
    Real divergence = Real(0);
    if (fluid_along > Real(least_fluid * (D - 1))) {
      const Real share = factor * (sum.wall.trace() - across(sum.wall, n)) / fluid_along;
      push(particles, i,
           (share / particles.density(i)) * (sum.pressure - dot(sum.pressure, n) * n));
      divergence += share * (sum.motion.trace() - across(sum.motion, n));
    }
    if (fluid_across > Real(least_fluid)) {
      const Real missing = across(sum.wall, n) - Real(2) * sum.height;
      divergence += factor * missing / fluid_across * across(sum.motion, n);
    }
    particles.compression_rate[i] -= (Real(1) + particles.compression[i]) * divergence;
  }

 private:
  KERF_FUNCTION static void add_product(Matrix<D, Real>& sum, const RealVector& a,
                                        const RealVector& b) {
    for (int r = 0; r < D; ++r)
      for (int c = 0; c < D; ++c) sum(r, c) += a[r] * b[c];
  }
  // Returns n . m n.
  KERF_FUNCTION static Real across(const Matrix<D, Real>& m, const RealVector& n) {
    Real sum = Real(0);
    for (int r = 0; r < D; ++r)
      for (int c = 0; c < D; ++c) sum += n[r] * m(r, c) * n[c];
    return sum;
  }
  KERF_FUNCTION static void push(const ParticleView<D, P>& particles, Index i,
                                 const RealVector& acceleration) {
    particles.pressure_acceleration[i] += acceleration;
    particles.acceleration[i] += acceleration;
    particles.repulsion[i] += acceleration;
  }
};

// A loop over the fluid particles beside smooth rigid walls. Those in a corner, and beyond the end
// of a face, feel the wall along other lines (fluid/rigid_wall.hpp).
template <int D, class P, class Loop>
struct BesideRigidWalls {
  ParticleView<D, P> particles;
  NeighbourView list;
  Loop loop;

  KERF_FUNCTION void operator()(Index i) const {
    if (!particles.is_fluid(i) || particles.has(i, flag::in_corner) ||
        particles.has(i, flag::at_edge))
      return;
    for (Index k = list.begin[i] + list.same_fluid[i]; k < list.end[i]; ++k)
      if (particles.medium(particles.mirrors.particle(list.neighbour[k])).phase == Phase::rigid) {
        loop(i);
        return;
      }
  }
};

}  // namespace kerf
