// SPDX-License-Identifier: Apache-2.0
// Water beside a plane wall, or in the corner between two, whose lattice has any angle against its
// face, with a pressure and a motion that are linear.
#pragma once

#include <cmath>

#include "fluid/lattice_sums.hpp"
#include "kernels/wendland_c2.hpp"
#include "support/standard_mixture.hpp"
#include "time/verlet.hpp"

namespace kerf::test::at_wall {

inline constexpr double spacing = 1e-3, centre = 0.01, sound_speed = 50.0, density = 1000.0;
inline constexpr int reach =
    5;  // rows of water and wall on each side of the particle that is judged

// The water moves by v = motion (x - f), with the foot f of the particle that is judged on the
// wall; its compression changes by `steepness` (x - x_i).
struct LinearField {
  Matrix3 frame = Matrix3::Identity();  // columns: along the wall, its normal, along the wall
  Matrix3 motion = Matrix3::Zero();     // 1/s
  Vector3 steepness = Vector3::Zero();  // 1/m
  double compression = 1e-3;
  double height = 0.5;     // of the first row above the wall, spacings
  double viscosity = 0.0;  // Pa s
  Phase wall = Phase::rigid;
  bool has_faces = true;   // whether the particles of the wall know theirs
  bool in_corner = false;  // a second wall has the first column of the frame for its normal
};

template <int D, class P>
class AtWall {
 public:
  using Real = typename P::Real;

  explicit AtWall(const LinearField& field) : field_(field), loaded_(state(), {0.0, 0.02, 5e-4}) {
    auto& particles = loaded_.particles;
    const auto place = loaded_.places();
    for (std::size_t k = 0; k < place.size(); ++k) {
      if (state_.particles[k].source == 0 || !field.has_faces) continue;
      const auto& position = state_.particles[k].position;
      const int face =
          field.in_corner && height_above(0, position) < height_above(1, position) ? 0 : 1;
      particles.face_normal[place[k]] = Vector<D, Real>::from(Vector3(field.frame.col(face)));
      particles.face_depth[place[k]] = Real(-height_above(face, position));
    }
    water_ = place[0];
    // The normal of the wall is known after one step, the factors of its sums after two.
    for (int step = 0; step < 3; ++step) {
      evaluate();
      for_each_index(particles.size(), UpdateSurfaceFlags<D, P>{particles.view()});
      const std::uint8_t flags = particles.flags[water_];
      is_in_corner_ = (flags & flag::in_corner) != 0;
      thrust::fill(particles.flags.begin(), particles.flags.end(), std::uint8_t(0));
      if (is_in_corner_) particles.flags[water_] = flag::in_corner;
    }
  }
  bool is_in_corner() const { return is_in_corner_; }
  Vector3 acceleration() const {
    return as_eigen(
        Vector<D, double>::from(Vector<D, Real>(loaded_.particles.acceleration[water_])));
  }
  // The reaction of the wall is the part that is no pair of water.
  Vector3 repulsion() const {
    return as_eigen(Vector<D, double>::from(Vector<D, Real>(loaded_.particles.repulsion[water_])));
  }
  double compression_rate() const { return loaded_.particles.compression_rate[water_]; }
  // The sum of the forces on all particles, N, and the sum of their magnitudes.
  Vector3 total_force() const {
    Vector3 sum = Vector3::Zero();
    for (Index i = 0; i < loaded_.particles.size(); ++i) sum += force_on(i);
    return sum;
  }
  double sum_of_forces() const {
    double sum = 0.0;
    for (Index i = 0; i < loaded_.particles.size(); ++i) sum += force_on(i).norm();
    return sum;
  }

 private:
  Vector3 force_on(Index i) const {
    const auto& particles = loaded_.particles;
    const Vector<D, Real> a = particles.acceleration[i];
    const double mass = state_.media[particles.source[i]].mass;
    return mass * as_eigen(Vector<D, double>::from(a));
  }
  void evaluate() {
    auto& particles = loaded_.particles;
    const StandardRates<D, P> rates({}, state_.media, lattice_sums<D, WendlandC2<D>>(1.3));
    thrust::fill(particles.solid_initial_overlap.begin(), particles.solid_initial_overlap.end(), 1);
    thrust::fill(particles.rigid_initial_overlap.begin(), particles.rigid_initial_overlap.end(), 1);
    Array<ConcentrationGradient<D, Real>> gradient(particles.size());
    rates.evaluate(particles.view(), particles.size(), loaded_.list.view(), MixtureBonds<D, P>{},
                   pointer(gradient));
    complete_at_walls(rates, loaded_);
  }
  Vector3 from_water(const Vector3& x) const {
    return x - Vector3(centre, centre, D == 3 ? centre : 0.0);
  }
  // Returns the height above the wall whose normal is the column `face` of the frame, m.
  double height_above(int face, const Vector3& x) const {
    return field_.frame.col(face).dot(from_water(x)) + field_.height * spacing;
  }
  bool is_in_wall(const Vector3& x) const {
    return height_above(1, x) <= 0.0 || (field_.in_corner && height_above(0, x) <= 0.0);
  }
  const ReferenceState& state() {
    state_.dimension = D;
    auto water = mixture_water(spacing, D);
    water.smoothing_length = 1.3 * spacing;
    water.viscosity = field_.viscosity;
    water.volume = std::pow(spacing, D);
    water.mass = density * water.volume;
    auto wall = field_.wall == Phase::rigid ? mixture_rigid(spacing) : mixture_solid(spacing, D, 1);
    wall.smoothing_length = water.smoothing_length;
    wall.volume = water.volume;
    state_.media = {water, wall};
    constexpr int side = 2 * reach + 1, count = side * side * (D == 3 ? side : 1);
    add_water(Vector3::Zero());  // the particle that is judged comes first
    for (int n = 0; n < count; ++n) {
      const Vector3 node(n % side - reach, n / side % side - reach,
                         D == 3 ? n / (side * side) - reach : 0);
      const bool is_water = node[1] >= 0.0 && (node[0] >= 0.0 || !field_.in_corner);
      if (is_water && !node.isZero()) add_water(spacing * node);
      add_wall(spacing * node);
    }
    return state_;
  }
  void add_water(const Vector3& along_wall) {
    ReferenceParticle particle;
    const Vector3 offset = field_.frame * along_wall;
    particle.position = offset + Vector3(centre, centre, D == 3 ? centre : 0.0);
    particle.velocity = field_.motion * (offset + field_.height * spacing * field_.frame.col(1));
    particle.compression = field_.compression + field_.steepness.dot(offset);
    state_.particles.push_back(particle);
  }
  // The lattice of the wall is not in line with its face, unless the frame is the identity.
  void add_wall(const Vector3& node) {
    ReferenceParticle particle;
    particle.source = 1;
    particle.position = node + Vector3(centre, centre, D == 3 ? centre : 0.0);
    if (is_in_wall(particle.position)) state_.particles.push_back(particle);
  }

  LinearField field_;
  ReferenceState state_;
  Loaded<D, P, ContactPairs> loaded_;
  std::size_t water_ = 0;
  bool is_in_corner_ = false;
};

template <int D>
Matrix3 turned(double angle) {
  const Vector3 axis = D == 3 ? Vector3(0.3, -0.5, 0.8).normalized() : Vector3(Vector3::UnitZ());
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

}  // namespace kerf::test::at_wall
