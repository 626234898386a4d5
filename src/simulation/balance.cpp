// SPDX-License-Identifier: Apache-2.0
// The equations of the balance: what was supplied, what is due, and the errors.
#include "simulation/balance.hpp"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

double length(const std::array<double, 3>& v) {
  return std::hypot(v[0], v[1], v[2]);
}

double energy_due(const Balance& balance) {
  return balance.energy_initial + balance.energy_in - balance.energy_out - balance.energy_left +
         balance.work_gravity + balance.work_constraint + balance.work_load;
}

}  // namespace

double Balance::mass_error() const {
  const double scale = mass_initial + mass_in + mass_fed;
  return scale > 0.0 ? (mass_now - (scale - mass_out - mass_erased - mass_left)) / scale : 0.0;
}

double Balance::momentum_error() const {
  std::array<double, 3> gap{};
  for (std::size_t a = 0; a < 3; ++a)
    gap[a] = momentum_now[a] - momentum_initial[a] - momentum_in[a] + momentum_out[a] +
             momentum_left[a] - impulse_gravity[a] - impulse_rigid[a] - impulse_constraint[a] -
             impulse_load[a];
  const double scale =
      std::max({length(momentum_initial), length(momentum_now), length(momentum_in),
                length(impulse_gravity), length(impulse_rigid), length(impulse_constraint),
                length(impulse_load), momentum_scale, load_scale, constraint_scale});
  return scale > 0.0 ? length(gap) / scale : 0.0;
}

double Balance::energy_total() const {
  return kinetic + pressure_work + elastic_deviatoric + elastic_strain + hourglass +
         rigid_potential + dissipated_artificial + dissipated_viscous + dissipated_fracture +
         dissipated_plastic + dissipated_density + dissipated_reinitialisation + dissipated_damping;
}

double Balance::energy_supplied() const {
  return energy_initial + energy_in + std::max(0.0, work_gravity) + std::max(0.0, work_constraint) +
         std::max(0.0, work_load);
}

double Balance::solid_energy() const {
  return elastic_strain + hourglass;
}

double Balance::energy_drift() const {
  const double scale = energy_supplied();
  return scale > 0.0 ? (energy_total() - energy_due(*this)) / scale : 0.0;
}

bool Balance::energy_is_sound() const {
  // Of matter at rest, which has no energy but noise, it is that of a motion of 1 mm/s.
  const double noise = 0.5 * mass_now * 1e-3 * 1e-3;
  const double total = energy_total(), gap = std::abs(total - energy_due(*this));
  return gap <= std::max(noise, 0.5 * std::max(std::abs(total), energy_supplied()));  // not NaN
}

double Balance::energy_from_breaks() const {
  const double scale = energy_supplied();
  return scale > 0.0 ? std::max(0.0, -dissipated_fracture) / scale : 0.0;
}

double Balance::density_loss() const {
  const double scale = energy_supplied();
  return scale > 0.0 ? (dissipated_density + dissipated_reinitialisation) / scale : 0.0;
}

double Balance::pressure_energy_gap() const {
  const double scale = energy_supplied();
  return scale > 0.0 ? (stored_water + stored_solid - pressure_work) / scale : 0.0;
}

}  // namespace kerf
