// SPDX-License-Identifier: Apache-2.0
#include "output/parting_flags.hpp"

#include <fmt/format.h>

#include "model/case.hpp"
#include "output/result.hpp"

namespace kerf {

namespace {

// Of a workpiece that is not cut through, which may give way instead.
void add_flag_of_uncut(const CutSummary& cut, std::vector<ValidityFlag>& flags) {
  if (cut.was_pressed_ahead())
    flags.push_back(
        {"gave_way", ValidityFlag::State::note, cut.front_share_at_end, 1.0,
         fmt::format("The front of the water is {:.2g} thicknesses deep and the workpiece is not "
                     "cut through: it gives way. The run says nothing about a feed.",
                     cut.front_share_at_end)});
  else if (cut.was_pushed_aside())
    flags.push_back(
        {"gave_way", ValidityFlag::State::note, cut.removed_share_at_end, CutSummary::least_removed,
         fmt::format("{:.2g}% of the opening is removed, the rest is pushed aside. Its edges may "
                     "evade a nozzle that moves.",
                     100.0 * cut.removed_share_at_end)});
}

}  // namespace

void add_parting_flags(const RunOutcome& outcome, std::vector<ValidityFlag>& flags) {
  const CutSummary& cut = outcome.cut;
  const double share = cut.front_share_at_cut;
  if (cut.cracked_ahead())
    flags.push_back(
        {"crack_ahead", ValidityFlag::State::note, share, CutSummary::least_share,
         fmt::format("A crack parted the workpiece when the front of the water had passed {:.2g}% "
                     "of its thickness. A nozzle that moves leaves the crack of its impact behind.",
                     100.0 * share)});
  const auto& machine = outcome.description.machine;
  if (!machine || !(machine->traverse_speed > 0.0)) return;
  if (!cut.cut_through)
    add_flag_of_uncut(cut, flags);
  else if (cut.was_pressed_ahead())
    flags.push_back(
        {"gave_way", ValidityFlag::State::note, share, cut.greatest_share,
         fmt::format(
             "The front of the water was {:.2g} thicknesses deep when the workpiece was cut "
             "through: it gave way before. Its edges may evade a nozzle that moves.",
             share)});
  else if (cut.was_pushed_aside())
    flags.push_back(
        {"gave_way", ValidityFlag::State::note, cut.removed_share_at_cut, CutSummary::least_removed,
         fmt::format("{:.2g}% of the opening was removed when the workpiece was cut through, the "
                     "rest was pushed aside. Its edges may evade a nozzle that moves.",
                     100.0 * cut.removed_share_at_cut)});
}

}  // namespace kerf
