// SPDX-License-Identifier: Apache-2.0
// An estimate of the time step of a run, from the limits that the engines use (time/time_step.hpp,
// solid/joint_limit.hpp), at the state that the water has where it hits.
#pragma once

#include "analysis/derived.hpp"

namespace kerf {

struct Material;

// The materials that meet; null where a case has none.
struct MeetingMaterials {
  const Material* water = nullptr;
  const Material* solid = nullptr;
};

// Returns the estimate, s. `numbers` has the speeds of the case.
double estimated_step(const Case& description, const DerivedNumbers& numbers,
                      const MeetingMaterials& meeting);

}  // namespace kerf
