// SPDX-License-Identifier: Apache-2.0
// The depth of a cut follows from what is open of the initial layout: solid that is removed,
// detached or torn. A dent, however deep, is closed.
#pragma once

#include <vector>

#include "analysis/cut.hpp"
#include "analysis/kerf_map.hpp"

namespace kerf {

// Open particles of the initial layout that are closer than this make a path: the diagonal of a
// cubic cell (1.73) does, two particles on both sides of a whole one (2) do not.
inline constexpr double open_reach = 1.8;  // spacings

// Returns the depth below the face, m along the jet, of the deepest open place within a jet width
// of the path of the axis to which a path of open places leads there from the face. Open are open
// particles and what the layout leaves empty between solids (analysis/void_places.hpp). A face is
// where nothing of the workpiece lies above, or only bodies that are cut through; depths are below
// the first body on the line along the jet, or below the face at the axis where the former is a
// step above that (analysis/jet_face.hpp), and at most the length of the workpiece in the space of
// the jet. `bodies`: the verdicts so far, in the order of Workpiece::bodies.
double measure_cut_depth(const KerfView& view, const KerfAxes& axes,
                         const std::vector<BodyCut>& bodies);

}  // namespace kerf
