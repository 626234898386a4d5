// SPDX-License-Identifier: Apache-2.0
// The parts of the sentence that states the result of a run (verdict_of).
#pragma once

#include <string>
#include <vector>

namespace kerf {

struct NamedLayer;
struct RunOutcome;

// Names the jet that the verdict is on: the first one (docs/metrics.md), or the one whose way was
// cut in an outcome as that jet sees it.
std::string the_jet(const RunOutcome& outcome, bool begins_sentence = true);
// Returns the finest spacing of the bodies, m; infinite without any.
double finest_spacing(const RunOutcome& outcome);
// Returns the least length that means anything beside the spacing of the particles, m.
double least_length(const RunOutcome& outcome);

// Returns a list of names in words.
std::string join_names(const std::vector<std::string>& names);
// Names the bodies in the way of the jet by their fate: "liver is cut through, vessel is whole";
// empty where there is one body.
std::string layers_clause(const RunOutcome& outcome);
// Names the bodies in the way of the jet below its face that stand where the cut has passed beside
// them.
std::string beside_clause(const RunOutcome& outcome);
// Whether a body is more than a jet width wide on both sides of the axis, so that no path of a cut
// leads past it.
bool fills_the_way(const NamedLayer& layer, const RunOutcome& outcome);

// Returns whether the water has exerted a force on the workpiece, or on any solid where the jet
// aims at none.
bool has_touched(const RunOutcome& outcome);
// Whether the case has a body that a jet could cut.
bool has_workpiece(const Case& description);
// Says that it has not, and what became of the workpiece meanwhile.
std::string untouched_sentence(const RunOutcome& outcome);

// Returns whether the jet has made the workpiece measurably thinner.
bool makes_dent(const RunOutcome& outcome);
// Says how deep the dent is, and how far the workpiece has moved if that is more; empty where there
// is neither.
std::string dent_clause(const RunOutcome& outcome);
// Says how far the workpiece has moved, and whether across the jet, as the sides of a cut that
// slide apart; empty where it is at most `least`, m.
std::string motion_clause_beyond(const RunOutcome& outcome, double least);
// Says in how many pieces the workpiece is, if in more than at the start.
std::string pieces_clause(const RunOutcome& outcome);
// Says that nothing breaks, the dent, and whether the solid has begun to soften.
std::string dent_sentence(const RunOutcome& outcome);

// Returns whether no body that a jet could cut is in the way of the jet as laid out.
bool aims_at_nothing(const RunOutcome& outcome);
// Says so, and why, or whether its water has met one since.
std::string aimless_sentence(const RunOutcome& outcome);
// Whether solid has broken that was not loose as laid out.
bool has_broken(const RunOutcome& outcome);

// Returns whether the first of several jets met no solid before the workpiece was cut through, or
// by the end, so that what another jet did is not credited to it.
bool is_of_other_jet(const RunOutcome& outcome);
// Whether the first jet had met solid, but the way of another was cut.
bool is_cut_beside_first(const RunOutcome& outcome);
// Returns such an outcome as the case would have it with that jet in the first place.
RunOutcome as_of_cutting_jet(const RunOutcome& outcome);
// Says so, and what another jet did.
std::string other_jet_sentence(const RunOutcome& outcome);

// Says what became of the workpiece of a run without a jet.
std::string jetless_sentence(const RunOutcome& outcome);

// Says whether the cut under a nozzle with which a frame travels is the same all along its path.
std::string stationary_sentence(const RunOutcome& outcome);

}  // namespace kerf
