// SPDX-License-Identifier: Apache-2.0
// The schemes for pairs of water particles in the `standard` formulation: Riemann solutions
// (fluid/riemann.hpp), or delta-SPH with mean pressures and density diffusion
// (fluid/delta_sph.hpp, fluid/delta_sph.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace kerf {

enum class WaterScheme : std::uint8_t { riemann, delta_sph };
inline constexpr std::array<std::string_view, 2> water_scheme_words{"riemann", "delta_sph"};

}  // namespace kerf
