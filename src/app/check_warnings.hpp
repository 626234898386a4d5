// SPDX-License-Identifier: Apache-2.0
// This header declares what `kerf check` prints besides derived numbers: the particles of each
// body, and warnings.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/derived.hpp"
#include "analysis/loose_particles.hpp"

namespace kerf {

struct Case;

// Returns the bodies with loose particles, of cases that are laid out and bonded within a second;
// none of others.
std::vector<LooseParticles> quick_loose_particles(const Case& description);

// Returns a sentence for each thing that a run of the case will not resolve or represent correctly.
// `loose`: what quick_loose_particles() has found.
std::vector<std::string> check_warnings(const Case& description, const DerivedNumbers& numbers,
                                        const std::vector<LooseParticles>& loose);
std::vector<std::string> check_warnings(const Case& description, const DerivedNumbers& numbers);

// Returns a sentence for each jet whose water reaches no body that it could cut, by where and when
// it flows, and for each dwell without a traverse after it.
std::vector<std::string> aim_warnings(const Case& description);

// Returns a sentence for each body that the particles or the contact forces cannot represent: where
// it is one particle thick, and where a jet may press it through another. Throws a UserError if no
// particle of a body is bonded.
std::vector<std::string> solid_warnings(const Case& description,
                                        const std::vector<LooseParticles>& loose);

// Returns a sentence for each body from whose shape plane faces cut that lie on rows of particles,
// which are left out.
std::vector<std::string> cut_warnings(const Case& description);

// Returns a sentence for each solid that is brittle in tension and whose strength in compression is
// not given, and for each thin soft layer that is joined to a stiffer body.
std::vector<std::string> strength_warnings(const Case& description);

// Throws that UserError with the place in the text of the case file, before a run has written
// anything; else returns what quick_loose_particles() has found.
std::vector<LooseParticles> refuse_unbonded(const Case& description, const std::string& text,
                                            const std::string& file);

inline constexpr double most_tested = 1e5;  // particles of a body, by a warning

// Returns a row for each body: its name and its particles level by level.
std::vector<std::pair<std::string, std::string>> particle_rows(const Case& description);

// Returns a sentence for each spacing that is too coarse and each grading that is too steep or too
// near to the cut, with key, value, range and remedy.
std::vector<std::string> resolution_warnings(const Case& description);

}  // namespace kerf
