// SPDX-License-Identifier: Apache-2.0
// This header finds varied keys that change nothing, since no body and no jet has their material.
#pragma once

#include <string>
#include <vector>

#include "study/axis.hpp"

namespace kerf {

struct Case;

// Returns the names of the materials of the bodies and jets of a case, each once, and those that
// the axes give to one.
std::vector<std::string> used_materials(const Case& description, const std::vector<Axis>& axes);

// Returns why a key changes nothing, with the materials that are used; "" where it is of no
// material, or of one of `used`.
std::string unused_material(const KeyPath& path, const std::vector<std::string>& used);

}  // namespace kerf
