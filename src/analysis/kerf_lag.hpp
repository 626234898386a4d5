// SPDX-License-Identifier: Apache-2.0
// This measurement computes the lag of a cutting front: the distance of its bottom behind its top.
#pragma once

#include "analysis/kerf_sections.hpp"
#include "analysis/kerf_shape.hpp"

namespace kerf {

// Returns the lag of a nozzle that travels, m along its path, between the layers of the top and
// bottom widths: 0 where these are one layer, nan without a kerf or where its front has left the
// workpiece.
double measure_lag(const KerfMap& map, const KerfAxes& axes, const KerfPath& path,
                   const SectionProbe& probe, const KerfShape& shape);

}  // namespace kerf
