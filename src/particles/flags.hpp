// SPDX-License-Identifier: Apache-2.0
// Bits of the field `flags`.
#pragma once

#include <cstdint>

namespace kerf {

namespace flag {
inline constexpr std::uint8_t repelling = 1;  // layer of a rigid body that repels, eq. (43)
inline constexpr std::uint8_t upstream = 2;   // jet water still inside its nozzle
inline constexpr std::uint8_t outside = 4;    // has left the domain: to be removed
inline constexpr std::uint8_t erased = 8;     // flows back towards its nozzle: to be removed
inline constexpr std::uint8_t fitted = 16;    // beside a jump of the spacing of its body
inline constexpr std::uint8_t surface = 32;   // its room is not full: it is in a free surface
}  // namespace flag

}  // namespace kerf
