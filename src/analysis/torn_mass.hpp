// SPDX-License-Identifier: Apache-2.0
// How much of a body is torn near the jets, from whichever side: while this grows, a later end of
// the run may find the body cut through. docs/metrics.md has the definition.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/cut.hpp"
#include "analysis/kerf_map.hpp"

namespace kerf {

// Marks the slots that are so near to the way of a jet that a crack there may part the body: those
// no farther from it than the layers of the sides reach (analysis/body_sides.hpp).
std::vector<std::uint8_t> mark_near_jets(const Workpiece& workpiece);

// Notes the torn mass of each body that is in the way, can break and is not judged yet
// (BodyCut::torn): of the slots marked in `near` the mass of what does not stand and, of what does,
// the share of its bonds that are broken. Debris counts as a whole, so that it adds nothing when it
// crumbles; what has left the domain unbroken counts as unbroken. `view.standing` is that of
// closed_where_left.
void note_torn(const KerfView& view, const std::vector<std::uint8_t>& near,
               std::vector<BodyCut>& bodies);

}  // namespace kerf
