// SPDX-License-Identifier: Apache-2.0
// The sources of particles: the bodies of a case, then its jets. The field `source` of a frame is
// the number of one.
#pragma once

#include <string>
#include <vector>

namespace kerf {

struct Case;

std::vector<std::string> source_names(const Case& description);

// Returns the material of each source, an index into Case::materials; -1 for a rigid body.
std::vector<int> source_materials(const Case& description);

}  // namespace kerf
