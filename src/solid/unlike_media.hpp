// SPDX-License-Identifier: Apache-2.0
// Beside which unlike media of its piece a particle of a solid is: in what its bonds differ from
// those within its own medium.
#pragma once

#include <cstdint>

#include "model/medium.hpp"

namespace kerf {

namespace unlike_media {
inline constexpr std::uint8_t waves = 1;   // in their waves, which joint_limit.hpp bounds
inline constexpr std::uint8_t limits = 2;  // in the limits of their fracture criterion
}  // namespace unlike_media

struct HasUnlikeWaves {
  const std::uint8_t* bits;
  KERF_FUNCTION bool operator()(std::uint32_t i) const {
    return (bits[i] & unlike_media::waves) != 0;
  }
};

inline bool have_unlike_waves(const Medium<double>& a, const Medium<double>& b) {
  return a.density != b.density || a.bulk_modulus != b.bulk_modulus ||
         a.shear_modulus != b.shear_modulus || a.excess_bulk_modulus != b.excess_bulk_modulus ||
         a.artificial_linear != b.artificial_linear;
}
// Of two levels of one body.
inline bool have_unlike_limits(const Medium<double>& a, const Medium<double>& b) {
  return a.failure_strain != b.failure_strain || a.softening_strain != b.softening_strain ||
         a.strength_rate != b.strength_rate;
}

}  // namespace kerf
