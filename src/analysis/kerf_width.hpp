// SPDX-License-Identifier: Apache-2.0
// This header declares the measurement of the widths of a kerf near its top, in the middle and near
// its bottom, and of the taper of its faces. The width of the opening during the run is
// analysis/opening_width.hpp.
#pragma once

#include <vector>

#include "analysis/kerf_sections.hpp"
#include "analysis/kerf_shape.hpp"

namespace kerf {

// Measures the top, the middle and the bottom of a kerf and its taper from the sections that the
// axis has passed, and stores them in `shape`, whose depth, thickness and `through` are known. They
// remain 0 for a kerf that is less deep than a spacing. `spacing` is that of the solid, m.
void measure_widths(const KerfMap& map, const std::vector<KerfSection>& passed,
                    const SectionProbe& probe, double spacing, KerfShape& shape);

}  // namespace kerf
