// SPDX-License-Identifier: Apache-2.0
// GradientAtWall completes the pressure gradient and the divergence of fluid beside a smooth rigid
// wall. Such a wall acts along its normal n only (fluid/rigid_wall.hpp), so that its particles have
// no part in what changes along it, and their part across it is that of a mirror image at the speed
// of the particle. The missing parts follow from the fluid beside it. With the moments
//   M^f = sum V_j S_ij d_ij d_ij^T over fluid,  M^w the same over the wall, times its factor f_i,
// k (M^f + M^w) = 1 within matter, the kernel gradient normalisation k, and t along the wall:
//   a_i      += k s_t / rho_i sum V_j (p_j - p_i) S_ij d_t,   s_t = m_t / (1/k - m_t)
//   div v_i  += k s_t sum V_j S_ij d_t . v_ij,                m_t = tr_t M^w / (D - 1)
//   div v_i  += k (m_n - 2 f_i y sum_w V_j S_ij d_n) / (1/k - m_n) sum V_j S_ij d_n n.v_ij
// with m_n = n.M^w n and the distance y of i from the wall, where no face ends beside it. All
// vanish in uniform pressure and uniform motion (docs/theory/riemann_sph.md). The wall takes the
// reaction.
#pragma once

#include "core/matrix.hpp"
#include "core/select.hpp"
#include "fluid/rigid_wall.hpp"
#include "neighbours/list_entries.hpp"

namespace kerf {

template <int D, class P>
struct GradientAtWall {
  using Real = typename P::Real;
  using RealVector = Vector<D, Real>;
  static constexpr bool includes_rigid = false;
  struct Sum {
    RealVector pressure{};             // Pa/m, sum V_j (p_j - p_i) S_ij d_ij over fluid
    Matrix<D, Real> motion{}, wall{};  // 1/s: sum V S d v^T over fluid; 1: M^w / f_i
    FacingFaces<D, Real> faces{};      // in front of which i lies
  };
  Real kernel_gradient_normalisation;

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!(pair.distance > Real(0))) return;
    const RealVector& d = pair.separation;
    if (pair.medium_j->phase == Phase::rigid) {
      const Real weight = pair.medium_j->volume * pair.slope_per_distance;
      add_outer(sum.wall, weight * d, d);
      const auto normal = pair.of_j(particles.face_normal[pair.j]);
      const Real along = dot(d, normal), height = along - particles.face_depth[pair.j];
      if (!(height > Real(0))) return;
      const RealVector foot = particles.face_depth[pair.j] * normal - d;
      sum.faces.add(weight * along, normal, foot, height);
    } else if (particles.is_fluid(pair.j)) {
      const Real weight = volume_of(particles, pair.j, *pair.medium_j) * pair.slope_per_distance;
      sum.pressure += (weight * (particles.pressure[pair.j] - particles.pressure[pair.i])) * d;
      add_outer(sum.motion, weight * d, pair.velocity);
    }
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    const Real length = norm(sum.faces.normal);
    if (!(length > Real(0))) return;
    const RealVector n = (Real(1) / length) * sum.faces.normal;
    // The wall has to go on to all sides.
    const Real aside = sum.faces.aside(n) / particles.medium(i).smoothing_length;
    if (complete_part(aside) < Real(1)) return;
    const Real factor = wall_force_factor(particles, i);
    const Real across_wall = factor * across(sum.wall, n);
    const Real along_wall = (factor * sum.wall.trace() - across_wall) / Real(D - 1);
    const Real share = share_of(along_wall);
    push(particles, i, (share / particles.density(i)) * (sum.pressure - dot(sum.pressure, n) * n));
    const Real missing = across_wall - Real(2) * factor * sum.faces.height;
    const Real share_across = share_of(across_wall) * missing / across_wall;
    const Real motion_across = across(sum.motion, n);
    const Real divergence =
        share * (sum.motion.trace() - motion_across) + share_across * motion_across;
    particles.compression_rate[i] -= (Real(1) + particles.compression[i]) * divergence;
  }

 private:
  // Returns k m / (1/k - m) for the part m of the wall in a moment; half the moment is that of a
  // particle on the wall itself.
  KERF_FUNCTION Real share_of(Real moment) const {
    const Real k = kernel_gradient_normalisation, whole = Real(1) / k;
    const Real part = minimum(moment, Real(0.6) * whole);
    return k * part / (whole - part);
  }
  // Returns n . m n.
  KERF_FUNCTION static Real across(const Matrix<D, Real>& m, const RealVector& n) {
    return dot(n, m * n);
  }
  KERF_FUNCTION static void push(const ParticleView<D, P>& particles, Index i,
                                 const RealVector& acceleration) {
    particles.pressure_acceleration[i] += acceleration;
    particles.acceleration[i] += acceleration;
    particles.repulsion[i] += acceleration;
  }
};

// A loop over the fluid particles beside smooth rigid walls. Those in a corner, and beyond the end
// of a face, feel the wall along other lines (fluid/rigid_wall.hpp); those in a free surface have
// too few neighbours.
template <int D, class P, class Loop>
struct BesideRigidWalls {
  ParticleView<D, P> particles;
  NeighbourView list;
  Loop loop;

  KERF_FUNCTION void operator()(Index i) const {
    if (!particles.is_fluid(i) || particles.has(i, flag::in_corner) ||
        particles.has(i, flag::at_edge) || particles.has(i, flag::surface))
      return;
    for (Index k = list.begin[i] + list.same_fluid[i]; k < list.end[i]; ++k)
      if (particles.medium(particles.mirrors.particle(list.neighbour[k])).phase == Phase::rigid) {
        loop(i);
        return;
      }
  }
};

}  // namespace kerf
