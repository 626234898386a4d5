// SPDX-License-Identifier: Apache-2.0
// What acts between particles of water in the `standard` formulation: Riemann solutions
// (fluid/riemann.hpp), or the means and diffusion of delta-SPH (fluid/delta_sph.hpp,
// fluid/density_diffusion.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace kerf {

enum class WaterScheme : std::uint8_t { riemann, delta_sph };
inline constexpr std::array<std::string_view, 2> water_scheme_words{"riemann", "delta_sph"};

}  // namespace kerf
