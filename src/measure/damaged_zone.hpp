// SPDX-License-Identifier: Apache-2.0
// How far beside a kerf the solid is hurt.
#pragma once

#include "measure/kerf_shape.hpp"

namespace kerf {

// Material is damaged if it no longer stands, or where the frame has the columns "damage" (broken
// bonds) or "flaw_damage", if one of them is above this.
inline constexpr double least_damage = 0.1;
// The zone ends where the next stretch outwards holds less than this part of damaged material.
inline constexpr double damaged_part = 0.1;

// Breadth of damaged material beside the kerf at half its depth, m: mean of both sides. 0 without
// a kerf. `shape` is that of the same view.
double measure_damaged_zone(const KerfView& view, const KerfMap& map, const KerfAxes& axes,
                            const KerfPath& path, const KerfShape& shape);

}  // namespace kerf
