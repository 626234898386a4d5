// SPDX-License-Identifier: Apache-2.0
// The keys by which a material fractures: its criterion, the limits that the criterion takes, and
// their growth with the rate of strain.
#pragma once

#include "model/case.hpp"

namespace kerf {

class Section;
struct LibraryMaterial;

// Where neither the case nor the base names a criterion, it follows from the limits.
void choose_criterion(const Section& section, const LibraryMaterial* base, Formulation formulation,
                      Material& material);

// Refuses limits that the criterion does not take or lacks, and sets those to 0 that give way to
// others.
void resolve_fracture(Section& section, Formulation formulation, Material& material);

}  // namespace kerf
