// SPDX-License-Identifier: Apache-2.0
// How far the foot of a cutting front trails behind its head.
#pragma once

#include "measure/kerf_sections.hpp"
#include "measure/kerf_shape.hpp"

namespace kerf {

// Of a nozzle that travels, m along its way: head and foot are the layers of the widths at the top
// and at the bottom. 0 where these are one, nan without a kerf or where its front has left the
// workpiece.
double measure_lag(const KerfMap& map, const KerfAxes& axes, const KerfPath& path,
                   const SectionProbe& probe, const KerfShape& shape);

}  // namespace kerf
