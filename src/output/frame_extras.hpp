// SPDX-License-Identifier: Apache-2.0
// Arrays of a frame for users of ParaView that follow from its columns and from the case.
#pragma once

#include "output/vtkhdf.hpp"

namespace kerf {

// Returns the number of each particle's material among FrameLegend::materials.
std::vector<std::uint8_t> materials_of(const Frame& frame, const FrameLegend& legend);

// Returns the Cauchy stress, Pa, tension positive, six numbers per particle; empty where the frame
// has no deviatoric stress.
std::vector<float> full_stress(const Frame& frame);

// Where each particle was in the first frame, m, and how far it has moved since; not a number for
// water and for particles that the first frame does not have.
struct FrameMotion {
  std::vector<std::array<double, 3>> reference;
  std::vector<std::array<float, 3>> displacement;
};
FrameMotion motion_of(const Frame& frame, const FrameLegend& legend);

}  // namespace kerf
