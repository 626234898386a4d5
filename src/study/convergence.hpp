// SPDX-License-Identifier: Apache-2.0
// This header declares how far the numbers of a run depend on the spacing and the layout of its
// particles. docs/limits.md describes the rules.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "output/metric_interval.hpp"
#include "study/coarser_spacings.hpp"
#include "study/laboratory.hpp"

namespace kerf {

struct Case;

enum class SpacingRule { grid_convergence, limited_order, two_spacings, range, constant, unknown };
inline constexpr std::array<std::string_view, 6> spacing_rules{
    "grid convergence", "limited order", "two spacings", "range", "constant", "unknown"};

// What the spacing leaves open: distances from the value at the finest spacing, at least 0.
struct SpacingEffect {
  double below = 0.0, above = 0.0;
  double order = std::numeric_limits<double>::quiet_NaN();  // observed; NaN = none
  SpacingRule rule = SpacingRule::constant;
};

// Returns the effect for values at the spacings d, r d, r^2 d, ..., the finest first, r > 1; the
// first three count. With e_21 = f_2 - f_1 and e_32 = f_3 - f_2:
// - Three values with 0 < e_21 / e_32 < 1 converge with the observed order
//   p = ln(e_32 / e_21) / ln r. The effect is the grid convergence index
//   F |e_21| / (r^p - 1) to both sides, with F = 1.25 for p from 0.5 to 2.1, used up to 2 (Roache,
//   J. Fluids Eng. 116 (1994) 405; ASME V&V 20-2009, section 2). An order outside that range is
//   accidental, as no scheme here is of a higher order, and the order is limited to 1 with F = 3:
//   below it the effect is that of Eca & Hoekstra, J. Comput. Phys. 262 (2014) 104,
//   F |a| + s + |f_1 - f(1)|, of the line f(h) = f_0 + a h through the values at h = 1, r, r^2 with
//   the standard deviation s; above it F |e_21| / (r - 1).
// - Two values: F = 3 with p = 1 (Roache 1994).
// - Other sequences do not converge. The effect is the width of their range, to both sides.
// - One value says nothing, and the effect is not a number.
SpacingEffect effect_of_spacing(std::span<const double> values, double ratio);

// Returns the runs that show the effects, the cheapest first: the case at its coarser spacings, and
// `layouts` - 1 further layouts at the finer of these.
std::vector<Trial> convergence_trials(const CoarserSpacings& spacings, int layouts);

// Returns the intervals of the headline numbers that the run has. `outcomes` belong to the trials
// of convergence_trials(). The parts of spacing and layout are independent and add as the root of
// the sum of their squares. Layouts are compared with one another at the middle spacing, and the
// interval contains all their values. No amount is below 0, and no depth is above the thickness of
// the workpiece where no run has passed it.
std::vector<MetricInterval> find_intervals(const Outcome& run, const std::vector<Trial>& trials,
                                           const std::vector<Outcome>& outcomes, double ratio,
                                           int dimension);

// Returns one line, "kerf.depth  3.47 mm [2.9 mm, 4.1 mm], spacing 80%, layout 20%, ...".
std::string interval_line(const MetricInterval& interval);

}  // namespace kerf
