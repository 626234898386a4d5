// SPDX-License-Identifier: Apache-2.0
// How walls act on fluid where a case asks for `numerics.smooth_walls`; otherwise pairs act along
// the line of centres. A particle of a wall knows the face nearest to it: the normal n_j and its
// own depth below the face (geometry/nearest_face.hpp). Walls are the particles of rigid bodies
// and, for water, those of solids beside a face of their shape until they are damaged; their faces
// turn with the deformation (standard/turn_faces.hpp). A smooth wall pushes along its
// normal only, so that a pair acts along n_j instead of along the line of centres d_ij = r_i - r_j:
// the sums of pressure, dissipation and continuity take (d_ij . n_j) n_j in place of d_ij. Beside a
// plane wall they are scaled to those over layers parallel to its surface, spacing d apart, which a
// lattice in line with the wall has (docs/theory/riemann_sph.md):
//   wall_force_factor   f_i = sum_l d w_2(x_l) / sum_j V_j S_ij d_ij . n,   x_l = s_i + (l + 1/2)
//   d, wall_volume_factor  g_i = sum_l d w_1(x_l) / sum_j V_j W_ij,            l = 0, 1, 2, ...
// with the distance s_i of the particle from the surface, w_1(x) the integral of W and w_2(x) that
// of x S over a plane at the distance x from i.
// Water that follows a curved wall has a gradient of pressure across it (fluid/wall_curvature.hpp).
// On water that passes the end of a face the wall acts along the line from the edge, so that the
// water turns around it freely.
#pragma once

#include <cmath>

#include "core/select.hpp"
#include "fluid/facing_faces.hpp"
#include "fluid/wall_curvature.hpp"
#include "fluid/wall_layers.hpp"
#include "pairs/pair.hpp"

namespace kerf {

// Whether walls act along the normals of their faces.
template <int D, class P>
KERF_FUNCTION bool has_smooth_walls(const ParticleView<D, P>& particles) {
  return particles.face_normal != nullptr;
}

// Returns f_i, 1.
template <int D, class P>
KERF_FUNCTION typename P::Real wall_force_factor(const ParticleView<D, P>& particles, Index i) {
  using Real = typename P::Real;
  return has_smooth_walls(particles) ? Real(1) + particles.wall_force_excess[i] : Real(1);
}

// Returns g_i, 1.
template <int D, class P>
KERF_FUNCTION typename P::Real wall_volume_factor(const ParticleView<D, P>& particles, Index i) {
  using Real = typename P::Real;
  return has_smooth_walls(particles) ? Real(1) + particles.wall_volume_excess[i] : Real(1);
}

// Returns the share of the compression by smooth walls that a fluid particle does not feel. Water
// in a free surface lacks neighbours: it is not compressed as long as it has room before the wall.
// Otherwise a jet that flies past a wall would be compressed as the wall takes the place of the
// neighbours that its outermost row lacks, and would be repelled.
template <int D, class P>
KERF_FUNCTION typename P::Real room_at_wall(const ParticleView<D, P>& particles, Index i) {
  const bool is_free = has_smooth_walls(particles) && particles.has(i, flag::surface);
  return is_free ? particles.wall_room[i] : typename P::Real(0);
}

// Returns how complete a wall is whose feet lie aside of the particle by `aside`, smoothing
// lengths: 1 beside its middle, 0 beyond the end of a face.
template <class Real>
KERF_FUNCTION Real complete_part(Real aside) {
  return minimum(maximum((Real(0.5) - aside) / Real(0.35), Real(0)), Real(1));
}

// Whether particle j, of `medium`, is of a wall that acts along its normals on a fluid particle of
// another medium: a rigid one, or for water a solid whose face is known.
template <int D, class P>
KERF_FUNCTION bool is_smooth_wall(const ParticleView<D, P>& particles, Index j,
                                  const Medium<typename P::Real>& medium,
                                  const Medium<typename P::Real>& of_fluid) {
  if (medium.phase == Phase::rigid) return true;
  if (medium.phase != Phase::solid || of_fluid.phase != Phase::water) return false;
  if (!has_smooth_walls(particles) || particles.fractured[j]) return false;
  const auto& normal = particles.face_normal[j];
  return dot(normal, normal) > typename P::Real(0);
}
// The same of the pair of a fluid particle i.
template <int D, class P>
KERF_FUNCTION bool is_at_smooth_wall(const ParticleView<D, P>& particles, const Pair<D, P>& pair) {
  return particles.is_fluid(pair.i) &&
         is_smooth_wall(particles, pair.j, *pair.medium_j, *pair.medium_i);
}

// A pair seen from its fluid particle, whichever of the two that is.
template <int D, class P>
struct WallPair {
  using RealVector = Vector<D, typename P::Real>;
  Index fluid, wall;
  RealVector separation, velocity;  // m, m/s, of the fluid relative to the wall
  RealVector of_wall, of_face;      // 1, normals of the wall beside the fluid, of the wall particle

  KERF_FUNCTION static WallPair of(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                                   bool fluid_i) {
    if (fluid_i) {
      const auto of_wall = particles.face_normal[pair.i];
      return {pair.i, pair.j, pair.separation, pair.velocity, of_wall, seen_face(particles, pair)};
    }
    const typename P::Real back(-1);
    const RealVector separation = back * pair.separation, velocity = back * pair.velocity;
    const auto of_wall = pair.of_j(particles.face_normal[pair.j]);
    return {pair.j,   pair.i,  separation,
            velocity, of_wall, seen_face(particles, pair.i, separation)};
  }
};

// How a wall particle acts on a fluid particle.
template <int D, class Real>
struct SmoothWallArm {
  Vector<D, Real> arm;  // m, in place of the separation, from the wall
  bool is_smooth;       // false: the separation itself, in a corner
};

template <int D, class P>
KERF_FUNCTION SmoothWallArm<D, typename P::Real> smooth_wall_arm(
    const ParticleView<D, P>& particles, const WallPair<D, P>& pair) {
  using Real = typename P::Real;
  const bool has_face = dot(pair.of_face, pair.of_face) > Real(0);
  const bool is_plane = dot(pair.of_wall, pair.of_wall) > Real(0);
  if (!is_plane && (particles.has(pair.fluid, flag::in_corner) || !has_face))
    return {pair.separation, false};
  const Real above = dot(pair.separation, pair.of_face);
  const bool is_facing = above > Real(0) && above > particles.face_depth[pair.wall] &&
                         !particles.has(pair.fluid, flag::at_edge);
  const auto normal = is_facing ? pair.of_face : pair.of_wall;  // 0: a face that looks elsewhere
  const Real along = dot(pair.separation, normal);
  return {(along > Real(0) ? along : Real(0)) * normal, true};
}
// The same of the pair of a fluid particle i.
template <int D, class P>
KERF_FUNCTION SmoothWallArm<D, typename P::Real> smooth_wall_arm(
    const ParticleView<D, P>& particles, const Pair<D, P>& pair) {
  if (!has_smooth_walls(particles)) return {pair.separation, false};
  return smooth_wall_arm(particles, WallPair<D, P>::of(particles, pair, true));
}

// Finds the smooth wall beside a fluid particle, for the next step.
template <int D, class P, class Kernel>
struct SmoothWallSum {
  using Real = typename P::Real;
  using RealVector = Vector<D, Real>;
  static constexpr bool includes_rigid = false;
  struct Sum {
    FacingFaces<D, Real> faces{};
    Real all{};               // 1/m, sum V_j S_ij r_ij over all its particles
    Real force{}, volume{};   // 1/m, 1: what the factors scale
    Real spacing{}, reach{};  // m, the largest ones
    WallCurvature<D, Real> curvature{};
    Real distance = Real(1e30);  // m, from the nearest piece of the surface
    RealVector nearest{};        // m, from the nearest point of the surface to i
    bool is_passing = false;     // i lies beyond the end of that piece and does not come to it
  };
  // Normals that differ by this are not those of a plane or smoothly curved wall.
  static constexpr double least_alignment = 0.98;
  static constexpr double least_wall = 0.02;  // of h sum a, as in FluidContinuity
  static constexpr double most_factor = 1.5, least_factor = 0.6;
  static constexpr double half_width = D == 2 ? 0.5 : 0.7072;  // of pieces that cover a surface
  static constexpr double least_beyond = 0.1;                  // spacings beyond the end of a face
  static constexpr double most_coming = 0.25;  // of the speed, that towards the edge

  KERF_FUNCTION void add(const ParticleView<D, P>& particles, const Pair<D, P>& pair,
                         Sum& sum) const {
    if (!has_smooth_walls(particles)) return;
    if (!is_at_smooth_wall(particles, pair)) return;
    if (!(pair.distance > Real(0))) return;
    const Real volume = pair.medium_j->volume, weight = volume * pair.slope_per_distance;
    const Real spacing = pair.medium_j->spacing;
    sum.spacing = spacing > sum.spacing ? spacing : sum.spacing;
    sum.reach = pair.smoothing_length > sum.reach ? pair.smoothing_length : sum.reach;
    sum.all += weight * pair.distance;
    sum.force += weight * norm(smooth_wall_arm(particles, pair).arm);
    sum.volume += volume * Kernel::value(pair.distance, pair.smoothing_length);
    const auto face = FaceInFront<D, Real>::of(particles, pair);
    const Real width = (Real(1) + particles.face_growth[pair.j]) * spacing;
    if (dot(face.normal, face.normal) > Real(0)) find_nearest(pair, width, face, sum);
    if (!(face.along > Real(0)) || !(face.height > Real(-0.5) * spacing)) return;
    sum.faces.add(face);
    sum.curvature.add(face.weight, face.foot, face.normal, pair.velocity);
  }

  KERF_FUNCTION void finish(const ParticleView<D, P>& particles, Index i, const Sum& sum) const {
    if (!has_smooth_walls(particles)) return;
    auto& wall = particles.next_smooth_wall[i];
    wall = SmoothWall<D, Real>::none();
    if (!(sum.all > Real(0))) return;
    wall.is_corner = !(sum.faces.all > Real(0.1) * sum.all);
    if (wall.is_corner) return;
    const Real length = norm(sum.faces.normal);
    wall.room = room(sum.distance / sum.spacing);
    const auto before = particles.face_normal[i];
    const bool was_plane = dot(before, before) > Real(0) && !particles.has(i, flag::at_edge);
    wall.is_edge = sum.is_passing;
    if (wall.is_edge)
      wall.normal = (Real(1) / norm(sum.nearest)) * sum.nearest;
    else if (sum.faces.all * sum.reach > Real(least_wall) &&
             length > Real(least_alignment) * sum.faces.all)
      find_plane(sum, was_plane, wall);
    else
      wall.is_corner = is_concave(sum);
  }

 private:
  // Finds the point of the surface nearest to i. The surface consists of pieces about each
  // foot, as wide as the spacing has become, in 3D discs that cover squares of this width.
  KERF_FUNCTION static void find_nearest(const Pair<D, P>& pair, Real width,
                                         const FaceInFront<D, Real>& face, Sum& sum) {
    const Real spacing = pair.medium_j->spacing, height = face.height;
    const RealVector across = height * face.normal;  // from the plane of the piece to i
    const RealVector aside =
        Real(-1) * (face.foot + across);  // from the foot to i, along the plane
    const Real length = norm(aside), beyond = length - Real(half_width) * width;
    const bool is_beside = beyond > Real(0);
    if (!is_beside && !(height > Real(-0.5) * spacing)) return;
    // Behind the plane of its piece the distance of a particle is negative.
    const Real distance = is_beside ? std::sqrt(height * height + beyond * beyond) : height;
    if (!(distance < sum.distance)) return;
    sum.distance = distance;
    sum.nearest = is_beside ? across + (beyond / length) * aside : across;
    const Real coming = -dot(sum.nearest, pair.velocity);
    sum.is_passing = beyond > Real(least_beyond) * spacing &&
                     coming < Real(most_coming) * norm(sum.nearest) * norm(pair.velocity);
  }
  // A row of water at rest is half a spacing from a wall. The room falls from 1 at 0.45 to 0 at 0.2
  // of a spacing.
  KERF_FUNCTION static Real room(Real distance) {
    return between(Real(4) * distance - Real(0.8), Real(0), Real(1));
  }
  // Between two faces that look at each other's side their feet move apart against their normals:
  // the covariance of both is negative. At an edge it is positive.
  KERF_FUNCTION static bool is_concave(const Sum& sum) {
    const Real inverse = Real(1) / sum.faces.all;
    const Real covariance =
        -inverse * sum.faces.height - inverse * inverse * dot(sum.faces.foot, sum.faces.normal);
    return covariance < Real(-0.02) * sum.spacing;
  }
  KERF_FUNCTION void find_plane(const Sum& sum, bool was_plane, SmoothWall<D, Real>& wall) const {
    wall.normal = (Real(1) / norm(sum.faces.normal)) * sum.faces.normal;
    if (!was_plane || !(sum.force * sum.reach > Real(least_wall))) return;
    // Near the end of a face the feet lie to one side, and the wall is not complete.
    const Real part = complete_part(sum.faces.aside(wall.normal) / sum.reach);
    const Real height = sum.faces.height / sum.faces.all;
    const auto layers = WallLayers<D, Real>::template at<Kernel>(height, sum.spacing, sum.reach);
    wall.force_excess = part * limited_excess(layers.force / sum.force);
    wall.volume_excess = part * limited_excess(layers.volume / sum.volume);
    wall.centripetal = part * sum.curvature.centripetal(sum.faces.all, sum.spacing);
  }
  KERF_FUNCTION static Real between(Real value, Real least, Real most) {
    return value < least ? least : value > most ? most : value;
  }
  KERF_FUNCTION static Real limited_excess(Real factor) {
    return between(factor, Real(least_factor), Real(most_factor)) - Real(1);
  }
};

}  // namespace kerf
