// SPDX-License-Identifier: Apache-2.0
// The solid in the window of a travelling frame as it is laid out, as a frame of unbroken solid.
#pragma once

#include "model/medium.hpp"
#include "simulation/frame.hpp"
#include "simulation/media_order.hpp"
#include "standard/solid_members.hpp"

namespace kerf {

template <int D>
Frame make_layout(const SolidMembers<D>& members, const std::vector<Medium<double>>& media,
                  const std::vector<MediumOrigin>& origins) {
  Frame frame;
  frame.dimension = D;
  frame.id = members.id;
  std::uint8_t planes = 0;
  for (Index s = 0; s < members.size(); ++s) {
    const Medium<double>& medium = media[members.medium_index[s]];
    std::array<double, 3> x{};
    for (int a = 0; a < D; ++a) x[static_cast<std::size_t>(a)] = members.reference[s][a];
    frame.position.push_back(x);
    frame.velocity.push_back({});
    frame.category.push_back(Category::solid);
    frame.source.push_back(origins[members.medium_index[s]].source);
    frame.spacing.push_back(static_cast<float>(medium.spacing));
    frame.mass.push_back(static_cast<float>(medium.mass));
    frame.density.push_back(static_cast<float>(medium.density));
    frame.pressure.push_back(0.0f);
    frame.upstream.push_back(0);
    planes = static_cast<std::uint8_t>(medium.joined_mirrors >> MirrorPlanes<D>::shift);
  }
  const std::uint32_t lowest =
      frame.id.empty() ? 0 : *std::min_element(frame.id.begin(), frame.id.end());
  frame.piece.assign(frame.id.size(), lowest);
  frame.body_piece = frame.piece;
  if (planes != 0) frame.joined_planes.assign(frame.id.size(), planes);
  return frame;
}

}  // namespace kerf
