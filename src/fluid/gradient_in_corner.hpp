// SPDX-License-Identifier: Apache-2.0
// GradientInCorner completes the pressure gradient and the divergence of fluid along the edge e in
// which two walls meet, in three dimensions. In a corner the pairs with a wall act along the line
// of centres (fluid/smooth_wall.hpp), so that its mirror images do not change along e, and a wall
// that is not in line with e pushes along it. As beside a plane wall (fluid/gradient_at_wall.hpp),
// a wall has no part along e, and what is missing follows from the fluid f beside it:
//   a_i     += e/rho_i [ s sum_f V_j (p_j - p_i) S_ij d_e
//                        - k sum_w V_j (2 p_i + rho_i max(-g.d, 0)) S_ij d_e ]
//   div v_i += s sum_f V_j S_ij d_e v_ij,e - 2 k sum_w V_j S_ij d_e v_ij,e,
//   s        = 1 / sum_f V_j S_ij d_e^2 - k,
// with the kernel gradient normalisation k; the sums over the wall w take back what it has given.
// e is normal to the normals of both walls, so that it is the null vector of
//   N = sum a_j n_j n_j^T / sum a_j,   e e^T = adj N / tr adj N  (Cayley and Hamilton),
// and a third wall, whose normal has a part along e, leaves nothing to complete.
#pragma once

#include "core/matrix.hpp"
#include "core/select.hpp"
#include "fluid/faces_beside.hpp"
#include "fluid/smooth_wall.hpp"
#include "neighbours/list_entries.hpp"

namespace kerf {

template <int D, class P>
struct GradientInCorner {
  using Real = typename P::Real;
  using RealVector = Vector<D, Real>;
  static constexpr bool includes_rigid = false;
  struct Sum {
    RealVector pressure{};      // Pa/m, sum V_j (p_j - p_i) S_ij d_ij over fluid
    RealVector given{};         // Pa/m, the sum over the wall above, of d_ij
    Matrix<D, Real> motion{};   // 1/s, sum V S d v^T over fluid
    Matrix<D, Real> passing{};  // 1/s, the same over the wall
    Matrix<D, Real> moment{};   // 1, sum V S d d^T over fluid
    Matrix<D, Real> normals{};  // 1/m, sum a n n^T
    FacesBeside<D, P> faces{};
    Real reach{};  // m, the largest one of the wall
  };
  RealVector gravity;  // m/s^2
  Real kernel_gradient_normalisation;
  WallCompletion completion = WallCompletion::of_all_rates;
  // Shares of N: of the second wall beside the first one, and of a third one.
  static constexpr double least_second = 0.02, most_third = 0.02;
  static constexpr double most_aside = 0.15;   // smoothing lengths, along e
  static constexpr double least_moment = 0.4;  // of 1 / k; the fluid alone has 0.6 of it

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!(pair.distance > Real(0))) return;
    const RealVector& d = pair.separation;
    const Real pressure = particles.pressure[pair.i];
    if (is_at_smooth_wall(particles, pair)) {
      const Real weight = pair.medium_j->volume * pair.slope_per_distance;
      const Real rise = particles.density(pair.i) * maximum(-dot(gravity, d), Real(0));
      sum.given += (weight * (Real(2) * pressure + rise)) * d;
      add_outer(sum.passing, weight * d, pair.velocity);
      add_face(particles, pair, sum);
    } else if (particles.is_fluid(pair.j)) {
      const Real weight = volume_of(particles, pair.j, *pair.medium_j) * pair.slope_per_distance;
      sum.pressure += (weight * (particles.pressure[pair.j] - pressure)) * d;
      add_outer(sum.motion, weight * d, pair.velocity);
      add_outer(sum.moment, weight * d, d);
    }
  }
  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    if (!(sum.faces.all > Real(0))) return;
    const Real inverse = Real(1) / sum.faces.all, k = kernel_gradient_normalisation;
    const auto normals = inverse * sum.normals;
    const auto across = adjugate(normals);
    const Real second = across.trace();
    if (!(second > Real(least_second))) return;
    if (determinant(normals) > Real(most_third) * second) return;
    const auto along = (Real(1) / second) * across;  // e e^T
    const RealVector aside = along * (inverse * sum.faces.foot);
    if (!(norm(aside) < Real(most_aside) * sum.reach)) return;
    const Real moment = (along * sum.moment).trace();
    const Real share = Real(1) / maximum(moment, Real(least_moment) / k) - k;
    const RealVector force = along * (share * sum.pressure - k * sum.given);
    sum.faces.push(particles, i, (Real(1) / particles.density(i)) * force);
    if (completion == WallCompletion::of_accelerations) return;
    const Real divergence = (along * (share * sum.motion + (Real(-2) * k) * sum.passing)).trace();
    particles.compression_rate[i] -= (Real(1) + particles.compression[i]) * divergence;
  }

 private:
  KERF_FUNCTION static void add_face(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                                     Sum& sum) {
    sum.reach = maximum(sum.reach, pair.smoothing_length);
    const auto face = FaceInFront<D, Real>::of(particles, pair);
    if (!face.looks_at_fluid()) return;
    sum.faces.add_face(face, pair);
    add_outer(sum.normals, face.weight * face.normal, face.normal);
  }
};

// A loop over the fluid particles in corners but those in a free surface.
template <int D, class P, class Loop>
struct InCorners {
  ParticleView<D, P> particles;
  Loop loop;

  KERF_FUNCTION void operator()(Index i) const {
    if (particles.is_fluid(i) && particles.has(i, flag::in_corner) &&
        !particles.has(i, flag::surface))
      loop(i);
  }
};

}  // namespace kerf
