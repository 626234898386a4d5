// SPDX-License-Identifier: Apache-2.0
// The script that opens the frames of a run in ParaView.
#pragma once

#include <string>

namespace kerf {

// Returns a Python script that shows the series <name>.vtkhdf.series beside it as spheres of the
// particles' size, coloured by category with the names in a legend.
std::string paraview_macro(const std::string& name);

}  // namespace kerf
