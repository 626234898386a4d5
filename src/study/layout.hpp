// SPDX-License-Identifier: Apache-2.0
// This header declares the layouts of a case: the same problem with its particles elsewhere.
#pragma once

namespace kerf {

struct Case;

// Returns whether the seeds of the bodies change the case: a body has jitter, or a material with
// random flaws.
bool has_random_layout(const Case& description);

// Returns whether change_layout() changes the case: it has a random layout, or a jet that no
// symmetry plane holds in its place.
bool has_other_layouts(const Case& description);

// Changes the layout of a case; layout 0 is the case itself. A case with a random layout gets other
// seeds. In any other case the nozzles are moved along x by up to half a spacing of their water, so
// that the jet meets the lattice of the workpiece elsewhere: by the distance of `layout` times the
// golden ratio from the nearest whole number. Multiples of the golden ratio are spread evenly
// (Knuth, The Art of Computer Programming, vol. 3, section 6.4).
void change_layout(Case& description, int layout);

}  // namespace kerf
