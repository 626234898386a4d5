// SPDX-License-Identifier: Apache-2.0
// A particle that is about to join a run, on the host, and the bits of the field `flags`.
#pragma once

#include <cstdint>

#include "model/point.hpp"

namespace kerf {

namespace flag {
inline constexpr std::uint8_t repelling = 1;  // repels, eq. (43) of Shinohara et al. (2004)
inline constexpr std::uint8_t upstream = 2;   // jet water still inside its nozzle
inline constexpr std::uint8_t outside = 4;    // has left the domain: to be removed
inline constexpr std::uint8_t erased = 8;     // flowed back towards its nozzle: to be removed
inline constexpr std::uint8_t fitted = 16;   // its pairs have factors: beside a jump of the spacing
inline constexpr std::uint8_t surface = 32;  // its kernel sum is not full: near a free surface
inline constexpr std::uint8_t in_corner = 64;  // fluid in a corner between rigid walls
inline constexpr std::uint8_t at_edge = 128;   // fluid beyond the end of a rigid face
}  // namespace flag

struct NewParticle {
  Point position{};                // m
  Point velocity{};                // m/s
  std::uint32_t inlet_column = 0;  // of its nozzle, of jet water
  Point face_normal{};             // outward normal of the face nearest to a particle of a wall
  double face_depth = 0.0;         // m, of the particle below that face
  Point face_corner{};             // 1, of a particle between two faces (geometry/nearest_face.hpp)
  std::uint32_t id = 0;            // given when it joins
  std::uint16_t source = 0;        // number of its medium (simulation/media_order.hpp)
  std::uint8_t flags = 0;

  // The normal over the depth of the face, 1/m; 0 where there is none.
  Point face() const {
    Point result{};
    if (face_depth > 0.0)
      for (std::size_t a = 0; a < 3; ++a) result[a] = face_normal[a] / face_depth;
    return result;
  }
};

}  // namespace kerf
