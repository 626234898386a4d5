// SPDX-License-Identifier: Apache-2.0
// This header declares the groups by which particles of the moving picture are coloured: body,
// material and piece. The value of a particle is the number of its group.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/frame.hpp"

namespace kerf {

struct Case;

struct ViewerGroups {
  std::string key, label;
  std::vector<std::string> names;  // 256 at most
};

// Returns the groups of a frame; only those that tell particles apart.
std::vector<ViewerGroups> viewer_groups(const Frame& frame, const Case& description);

// Returns the group of every particle; nothing where `key` is not the key of groups.
std::optional<std::vector<float>> group_values(const std::string& key, const Frame& frame,
                                               const Case& description);

}  // namespace kerf
