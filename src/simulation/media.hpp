// SPDX-License-Identifier: Apache-2.0
// From the case's bodies and jets to what the loops need of each.
#pragma once

#include <vector>

#include "case/case.hpp"
#include "particles/medium.hpp"
#include "particles/nozzle.hpp"

namespace kerf {

// One medium per body, then one per jet.
std::vector<Medium<double>> make_media(const Case& description, const std::vector<Nozzle>& nozzles);

template <class T>
Medium<T> convert(const Medium<double>& m) {
  Medium<T> out;
  out.phase = m.phase;
  out.constrained = m.constrained;
  out.cavitates = m.cavitates;
  out.piece = m.piece;
  out.spacing = static_cast<T>(m.spacing);
  out.smoothing_length = static_cast<T>(m.smoothing_length);
  out.mass = static_cast<T>(m.mass);
  out.volume = static_cast<T>(m.volume);
  out.density = static_cast<T>(m.density);
  out.sound_speed = static_cast<T>(m.sound_speed);
  out.longitudinal_speed = static_cast<T>(m.longitudinal_speed);
  out.tait_coefficient = static_cast<T>(m.tait_coefficient);
  out.tait_exponent = static_cast<T>(m.tait_exponent);
  out.viscosity = static_cast<T>(m.viscosity);
  out.bulk_modulus = static_cast<T>(m.bulk_modulus);
  out.shear_modulus = static_cast<T>(m.shear_modulus);
  out.failure_strain = static_cast<T>(m.failure_strain);
  out.artificial_linear = static_cast<T>(m.artificial_linear);
  out.artificial_quadratic = static_cast<T>(m.artificial_quadratic);
  out.artificial_softening = static_cast<T>(m.artificial_softening);
  out.repulsion = static_cast<T>(m.repulsion);
  return out;
}

}  // namespace kerf
