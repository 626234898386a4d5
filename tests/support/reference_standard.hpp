// SPDX-License-Identifier: Apache-2.0
// The pair sums of the `standard` formulation as plain double loops over all pairs, each pair once,
// in double precision on Eigen vectors. This oracle shares no code with the engine except the plain
// data of a Medium. Zhang, Hu & Adams, J. Comput. Phys. 335 (2017) 605; Morris, Fox & Zhu, J.
// Comput. Phys. 136 (1997) 214.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>

#include "support/reference_contact.hpp"

namespace kerf::test {

struct StandardRate {
  double pressure = 0.0;                     // Pa
  double compression_rate = 0.0;             // 1/s
  Vector3 pressure_force = Vector3::Zero();  // N, from the mean pressure of pairs
  Vector3 damping = Vector3::Zero();         // N, from dissipation and viscosity
  Vector3 contact = Vector3::Zero();         // N
  Vector3 from_rigid = Vector3::Zero();      // N, the part of these forces from rigid bodies
  double contact_energy = 0.0;               // J
};

// P*, split into its mean and its dissipation, and U*; U towards the right is positive. The star
// state lies between the two acoustic waves: P* = p_l + Z_l (U_l - U*) = p_r - Z_r (U_r - U*).
struct StarState {
  double mean, dissipation, speed;
};
struct RiemannState {
  double density, pressure, speed, sound_speed;
};
inline StarState reference_star(const RiemannState& left, const RiemannState& right) {
  const double z_l = left.density * left.sound_speed, z_r = right.density * right.sound_speed;
  const double jump = left.speed - right.speed;
  const double c = std::min(left.sound_speed, right.sound_speed);
  const double beta = std::min(3.0 * std::max(jump, 0.0) / c, 1.0);
  const double speed =
      (z_l * left.speed + z_r * right.speed + left.pressure - right.pressure) / (z_l + z_r);
  // The parts without the velocity jump and from the velocity jump alone.
  const double mean = left.pressure - z_l * (left.pressure - right.pressure) / (z_l + z_r);
  const double wave = z_l * (left.speed - (z_l * left.speed + z_r * right.speed) / (z_l + z_r));
  return {mean, beta * wave, speed};
}

class ReferenceStandard {
 public:
  // Returns whether an intact bond joins two particles, given by their numbers.
  using Bonded = std::function<bool(std::size_t, std::size_t)>;

  // Whether the normals of walls are used; otherwise the line of centres replaces them.
  enum class Normals { unknown, known };
  ReferenceStandard(const ReferenceState& state, const Bonded& bonded,
                    Normals normals = Normals::unknown)
      : state_(state),
        bonded_(bonded),
        normal_(state.particles.size(), Vector3::Zero()),
        rates_(state.particles.size()),
        contact_(state) {
    for (std::size_t i = 0; i < rates_.size(); ++i) rates_[i].contact_energy = contact_.energy(i);
    if (normals == Normals::known) find_normals();
    for (std::size_t i = 0; i < rates_.size(); ++i) rates_[i].pressure = density_pressure(i);
    for (std::size_t i = 0; i < rates_.size(); ++i)
      for (std::size_t j = i + 1; j < rates_.size(); ++j) add_pair(i, j);
  }
  const std::vector<StandardRate>& rates() const { return rates_; }
  Vector3 force(std::size_t i) const {
    return rates_[i].pressure_force + rates_[i].damping + rates_[i].contact;
  }

 private:
  bool is(std::size_t i, Phase phase) const { return state_.medium(i).phase == phase; }
  const ReferenceParticle& at(std::size_t i) const { return state_.particles[i]; }
  // Water and detached solid.
  bool flows(std::size_t i) const { return is(i, Phase::water) || at(i).fractured; }
  // Intact, nearly incompressible solid.
  bool keeps_volume(std::size_t i) const {
    return is(i, Phase::solid) && !at(i).fractured && state_.medium(i).excess_bulk_modulus > 0.0;
  }
  double volume(std::size_t i) const {
    return flows(i) || keeps_volume(i) ? state_.medium(i).mass / state_.density(i)
                                       : state_.medium(i).volume;
  }
  double density_pressure(std::size_t i) const {
    if (!flows(i) && !keeps_volume(i)) return 0.0;
    const auto& m = state_.medium(i);
    const double compression = at(i).compression;
    const double growth = (std::pow(1.0 + compression, 7.0) - 1.0) / 7.0;
    if (keeps_volume(i))  // of a solid without damage
      return (compression < 0.0 ? m.tensile_excess : m.excess_bulk_modulus) * growth;
    const double modulus =
        is(i, Phase::solid) ? m.total_bulk_modulus : m.sound_speed * m.sound_speed * m.density;
    return std::max(0.0, modulus * growth);
  }

  // Computes the unit normal away from the walls near a fluid particle; zero where the walls nearly
  // cancel.
  void find_normals() {
    for (std::size_t i = 0; i < rates_.size(); ++i) {
      if (!flows(i)) continue;
      Vector3 sum = Vector3::Zero();
      for (std::size_t j = 0; j < rates_.size(); ++j) {
        if (j == i || flows(j)) continue;
        const auto &a = state_.medium(i), &b = state_.medium(j);
        const double h = a.phase == b.phase ? (a.smoothing_length + b.smoothing_length) / 2.0
                                            : std::max(a.smoothing_length, b.smoothing_length);
        const Vector3 separation = at(i).position - at(j).position;
        sum -= volume(j) * wendland_slope(separation.norm(), h, state_.dimension) *
               separation.normalized();
      }
      if (sum.norm() * state_.medium(i).smoothing_length > 0.02) normal_[i] = sum.normalized();
    }
  }

  void add_pair(std::size_t i, std::size_t j) {
    if (flows(i)) return add_fluid(i, j);
    if (flows(j)) return add_fluid(j, i);
    if (keeps_volume(i) && keeps_volume(j) && state_.medium(i).piece == state_.medium(j).piece)
      return add_fluid(i, j);
    if (is(i, Phase::solid)) return add_contact(i, j);
    if (is(j, Phase::solid)) return add_contact(j, i);
  }

  // `w` is fluid and the other of any phase, or both are of one nearly incompressible solid.
  void add_fluid(std::size_t w, std::size_t o) {
    const auto &a = state_.medium(w), &b = state_.medium(o);
    const bool both = flows(o) || !flows(w);
    const double h = a.phase == b.phase ? (a.smoothing_length + b.smoothing_length) / 2.0
                                        : std::max(a.smoothing_length, b.smoothing_length);
    const Vector3 separation = at(w).position - at(o).position;
    const double r = separation.norm(), slope = wendland_slope(r, h, state_.dimension);
    const Vector3 e = separation / r;
    const RiemannState left{state_.density(w), rates_[w].pressure, -at(w).velocity.dot(e),
                            a.sound_speed};
    StarState star{};
    if (both) {
      star = reference_star(
          left, {state_.density(o), rates_[o].pressure, -at(o).velocity.dot(e), b.sound_speed});
      const double closing = std::max(0.0, (at(o).velocity - at(w).velocity).dot(e));
      if (is(w, Phase::water) && is(o, Phase::water))
        star.dissipation = std::max(0.0, star.dissipation - viscosity(w, o) * closing / r);
    } else {
      const double wall = -at(o).velocity.dot(e);
      const double depth = std::max(0.0, -state_.gravity.dot(e)) * r;
      star = reference_star(left, {left.density, left.pressure + left.density * depth,
                                   2.0 * wall - left.speed, a.sound_speed});
      if (normal_[w].norm() > 0.0) {
        const double into = normal_[w].dot(at(o).velocity - at(w).velocity);
        star.dissipation = reference_star({left.density, 0.0, into, a.sound_speed},
                                          {left.density, 0.0, -into, a.sound_speed})
                               .dissipation;
      }
    }
    const Vector3 unit = -2.0 * volume(w) * volume(o) * slope * e;
    const bool at_wall = !both && normal_[w].norm() > 0.0;
    add_forces(w, o, star.mean * unit,
               star.dissipation *
                   (at_wall ? Vector3(std::max(0.0, unit.dot(normal_[w])) * normal_[w]) : unit));
    add_friction(w, o, slope / r);
    // rho' / rho = 2 sum V (v - v*) . e W', where v* . e = - U*.
    const double growth_w = 2.0 * volume(o) * slope * (at(w).velocity.dot(e) + star.speed);
    rates_[w].compression_rate += (1.0 + at(w).compression) * growth_w;
    if (!both) return;
    const double growth_o = 2.0 * volume(w) * slope * (-at(o).velocity.dot(e) - star.speed);
    rates_[o].compression_rate += (1.0 + at(o).compression) * growth_o;
  }

  void add_forces(std::size_t w, std::size_t o, const Vector3& pressure_force,
                  const Vector3& damping) {
    rates_[w].pressure_force += pressure_force;
    rates_[o].pressure_force -= pressure_force;
    rates_[w].damping += damping;
    rates_[o].damping -= damping;
    if (is(o, Phase::rigid)) rates_[w].from_rigid += pressure_force + damping;
  }

  double viscosity(std::size_t w, std::size_t o) const {
    const double mu_w = state_.medium(w).viscosity, mu_o = state_.medium(o).viscosity;
    if (!is(w, Phase::water) || !is(o, Phase::water)) return is(w, Phase::water) ? mu_w : mu_o;
    return mu_w + mu_o > 0.0 ? 2.0 * mu_w * mu_o / (mu_w + mu_o) : 0.0;
  }

  void add_friction(std::size_t w, std::size_t o, double slope_per_distance) {
    const Vector3 drag = 2.0 * viscosity(w, o) * volume(w) * volume(o) * slope_per_distance *
                         (at(w).velocity - at(o).velocity);
    rates_[w].damping += drag;
    rates_[o].damping -= drag;
    if (is(o, Phase::rigid)) rates_[w].from_rigid += drag;
  }

  static double wave_modulus(const Medium<double>& m) {
    return m.total_bulk_modulus + 4.0 / 3.0 * m.shear_modulus;
  }

  // Both are of one solid without a bond between them: a spring that acts in compression only.
  void add_contact(std::size_t s, std::size_t o) {
    const auto &a = state_.medium(s), &b = state_.medium(o);
    if (b.phase == Phase::rigid || a.piece != b.piece) return add_surface_contact(s, o);
    const Vector3 separation = at(s).position - at(o).position;
    const double rest = (a.spacing + b.spacing) / 2.0, overlap = rest - separation.norm();
    if (overlap <= 0.0 || bonded_(s, o)) return;
    const double modulus = (wave_modulus(a) + wave_modulus(b)) / 2.0;
    const double stiffness = modulus * std::pow(rest, state_.dimension - 2);
    const Vector3 normal = stiffness * overlap * separation.normalized();
    rates_[s].contact += normal;
    rates_[o].contact -= normal;
    rates_[s].contact_energy += stiffness * overlap * overlap / 4.0;
    rates_[o].contact_energy += stiffness * overlap * overlap / 4.0;
  }

  // `s` is solid and the other a solid of another piece or a rigid body.
  void add_surface_contact(std::size_t s, std::size_t o) {
    if (!contact_.are_in_contact(s, o)) return;
    add_opposite_forces(s, o, contact_.of(s, o));
    if (!is(o, Phase::rigid)) add_opposite_forces(o, s, contact_.of(o, s));
  }
  void add_opposite_forces(std::size_t i, std::size_t j, const ReferenceContactForce& force) {
    rates_[i].contact += force.normal;
    rates_[j].contact -= force.normal;
    rates_[i].damping += force.drag;
    rates_[j].damping -= force.drag;
    if (is(j, Phase::rigid)) rates_[i].from_rigid += force.normal + force.drag;
  }

  const ReferenceState& state_;
  Bonded bonded_;
  std::vector<Vector3> normal_;
  std::vector<StandardRate> rates_;
  ReferenceContact contact_;
};

}  // namespace kerf::test
