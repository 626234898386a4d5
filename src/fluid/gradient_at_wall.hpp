// SPDX-License-Identifier: Apache-2.0
// GradientAtWall completes the pressure gradient and the divergence of fluid beside a smooth wall.
// Such a wall acts along its normal n only (fluid/smooth_wall.hpp), so that its particles have
// no part in what changes along it, and their part across it is that of a mirror image at the speed
// of the particle. The missing parts follow from the fluid beside it. With the moments
//   M^f = sum V_j S_ij d_ij d_ij^T over fluid,  M^w the same over the layers of the wall,
// k (M^f + M^w) = 1 within matter, the kernel gradient normalisation k, and t along the wall:
//   a_i      += k s_t / rho_i sum V_j (p_j - p_i) S_ij d_t,   s_t = m_t / (1/k - m_t)
//   div v_i  += k s_t sum V_j S_ij d_t . v_ij,                m_t = tr_t M^w / (D - 1)
//   div v_i  += k (m_n - 2 y sum_l d w_2(x_l)) / (1/k - m_n) sum V_j S_ij d_n n.v_ij
// with m_n = n.M^w n, the sum over layers (fluid/wall_layers.hpp) and the distance y of i from the
// wall, where no face ends beside it. All
// vanish in uniform pressure and uniform motion (docs/theory/riemann_sph.md).
//   Near an edge the arms a_ij of the wall (fluid/smooth_wall.hpp) lack a part of d_ij, so that
// uniform pressure would drive water along the face. Water at rest gets it back,
//   a_i      += p_i / rho_i b_i,   div v_i += b_i . v_iw,
//   b_i       = 2 k e_i max(1 - 5 rho_i v_iw^2 / p_i, 0) sum_w V_j S_ij (d_ij - a_ij),
// with its velocity v_iw past the wall, and e_i from 0 in the middle of a face to 1 at its end. The
// faces beside i take the reaction (fluid/faces_beside.hpp).
#pragma once

#include "core/matrix.hpp"
#include "core/select.hpp"
#include "fluid/faces_beside.hpp"
#include "fluid/particle_concentration.hpp"
#include "fluid/smooth_wall.hpp"
#include "neighbours/list_entries.hpp"

namespace kerf {

template <int D, class P, class Kernel>
struct GradientAtWall {
  using Real = typename P::Real;
  using RealVector = Vector<D, Real>;
  static constexpr bool includes_rigid = false;
  struct Sum {
    RealVector pressure{};      // Pa/m, sum V_j (p_j - p_i) S_ij d_ij over fluid
    Matrix<D, Real> motion{};   // 1/s, sum V S d v^T over fluid
    FacesBeside<D, P> faces{};  // in front of which i lies
    RealVector velocity{};      // 1/s, of i relative to them, with their weights
    // 1/m, sum a_j times twice the distance, in spacings, of the depth of j from those of layers.
    Real unevenness{};
    RealVector lacking{};     // 1/m, sum V_j S_ij (d_ij - a_ij) over the wall
    Real spacing{}, reach{};  // m, the largest ones of the wall
  };
  Real kernel_gradient_normalisation;
  WallCompletion completion = WallCompletion::of_all_rates;

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!(pair.distance > Real(0))) return;
    const RealVector& d = pair.separation;
    if (is_at_smooth_wall(particles, pair)) {
      const Real weight = pair.medium_j->volume * pair.slope_per_distance;
      sum.lacking += weight * (d - smooth_wall_arm(particles, pair).arm);
      add_face(particles, pair, sum);
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
    const Real aside = sum.faces.aside(n) / particles.medium(i).smoothing_length;
    const bool is_beyond = particles.has(i, flag::at_edge);
    // The wall has to go on to all sides.
    if (!is_beyond && complete_part(aside) == Real(1)) complete(particles, i, sum, n);
    const Real end = is_beyond ? Real(1) : end_part(aside, sum.unevenness / sum.faces.all);
    if (end > Real(0) && particles.kernel_sum[i] >= Real(full_concentration))
      hold_at_rest(particles, i, sum, end);
  }

 private:
  static constexpr double slowness = 5.0;  // of water that counts as at rest, see above

  // Returns how near the end of a face is whose feet lie aside of the particle by `aside`,
  // smoothing lengths. Beside a plane face in stairs, whose particles lie at any depth, they lie
  // aside by 0.08 (rms), beside one in layers by less than 0.01. `unevenness`: see Sum.
  KERF_FUNCTION static Real end_part(Real aside, Real unevenness) {
    const Real stairs = minimum(Real(3) * unevenness, Real(1));
    const Real begin = Real(0.02) + Real(0.13) * stairs, length = Real(0.08) + Real(0.27) * stairs;
    return minimum(maximum((aside - begin) / length, Real(0)), Real(1));
  }
  // `end`: how near the end of the face is, 1 beyond it.
  KERF_FUNCTION void hold_at_rest(const ParticleView<D, P>& particles, Index i, const Sum& sum,
                                  Real end) const {
    const Real p = particles.pressure[i], density = particles.density(i);
    if (!(p > Real(0))) return;
    const RealVector speed = (Real(1) / sum.faces.all) * sum.velocity;
    const Real rest = Real(1) - Real(slowness) * density * dot(speed, speed) / p;
    if (!(rest > Real(0))) return;
    const RealVector lacking = (Real(2) * end * rest * kernel_gradient_normalisation) * sum.lacking;
    sum.faces.push(particles, i, (p / density) * lacking);
    diverge(particles, i, dot(lacking, speed));
  }
  KERF_FUNCTION void complete(const ParticleView<D, P>& particles, Index i, const Sum& sum,
                              const RealVector& n) const {
    const Real height = sum.faces.height / sum.faces.all;
    const auto wall = WallLayers<D, Real>::template at<Kernel>(height, sum.spacing, sum.reach);
    if (!(wall.across > Real(0))) return;
    const Real share = share_of(wall.along);
    sum.faces.push(particles, i,
                   (share / particles.density(i)) * (sum.pressure - dot(sum.pressure, n) * n));
    const Real missing = wall.across - Real(2) * height * wall.force;
    const Real share_across = share_of(wall.across) * missing / wall.across;
    const Real motion_across = across(sum.motion, n);
    const Real divergence =
        share * (sum.motion.trace() - motion_across) + share_across * motion_across;
    diverge(particles, i, divergence);
  }
  KERF_FUNCTION void diverge(const ParticleView<D, P>& particles, Index i, Real divergence) const {
    if (completion == WallCompletion::of_all_rates)
      particles.compression_rate[i] -= (Real(1) + particles.compression[i]) * divergence;
  }
  KERF_FUNCTION static void add_face(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                                     Sum& sum) {
    const auto face = FaceInFront<D, Real>::of(particles, pair);
    if (!face.looks_at_fluid()) return;
    sum.faces.add_face(face, pair);
    sum.spacing = maximum(sum.spacing, Real(pair.medium_j->spacing));
    sum.reach = maximum(sum.reach, pair.smoothing_length);
    sum.velocity += face.weight * pair.velocity;
    const Real layers = face.depth / pair.medium_j->spacing;
    sum.unevenness += face.weight * std::abs(Real(2) * (layers - std::floor(layers)) - Real(1));
  }
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
};

// A loop over the fluid particles beside smooth walls. Those in a corner feel the wall along other
// lines (fluid/smooth_wall.hpp); those in a free surface have too few neighbours.
template <int D, class P, class Loop>
struct BesideSmoothWalls {
  ParticleView<D, P> particles;
  NeighbourView list;
  Loop loop;

  KERF_FUNCTION void operator()(Index i) const {
    particles.wall_push[i] = WallPush<D, typename P::Real>::none();
    if (!particles.is_fluid(i) || particles.has(i, flag::in_corner) ||
        particles.has(i, flag::surface))
      return;
    for (Index k = list.begin[i] + list.same_fluid[i]; k < list.end[i]; ++k) {
      const Index j = particles.mirrors.particle(list.neighbour[k]);
      if (is_smooth_wall(particles, j, particles.medium(j), particles.medium(i))) return loop(i);
    }
  }
};

}  // namespace kerf
