// SPDX-License-Identifier: Apache-2.0
#include "output/parting_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "analysis/workpiece_motion.hpp"
#include "model/case.hpp"
#include "output/readable.hpp"
#include "output/result.hpp"
#include "output/verdict_parts.hpp"

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

// Whether the case itself moves a body in the way of the jet.
bool is_moved_by_case(const RunOutcome& outcome) {
  const auto& verdicts = outcome.cut.bodies;
  return std::any_of(verdicts.begin(), verdicts.end(), [&](const BodyVerdict& verdict) {
    const Body& body = outcome.description.bodies.at(std::size_t(verdict.body));
    return !body.displacement[0].empty() ||
           first_velocity(body, outcome.description.dimension) != std::array<double, 3>{};
  });
}

// Of a workpiece that was pressed ahead by more than its thickness: when it is cut depends on what
// holds it. Sides of a cut that slide apart do not give way: no support below would hold them. The
// front, which runs past a body that is narrow, tells of one that is cut whether it moved before.
void add_flag_of_sag(const RunOutcome& outcome, std::vector<ValidityFlag>& flags) {
  if (!outcome.kerf || is_moved_by_case(outcome)) return;
  const CutSummary& cut = outcome.cut;
  const double thickness = outcome.kerf->shape.thickness;
  const double sag = outcome.kerf->of<Dent>().sag;
  if (!(thickness > 0.0) || !(sag > thickness)) return;
  if (cut.cut_through && !(cut.front_share_at_cut > 2.0)) return;
  const auto& workpiece = outcome.description.workpiece;
  const bool travels = workpiece && workpiece->frame == WorkpieceFrame::travelling;
  flags.push_back(
      {"sagged", ValidityFlag::State::warning, sag, thickness,
       fmt::format(
           "The workpiece has given way by {}, {:.2g} times its thickness: the depth and the time "
           "of a cut depend on what holds it{}.",
           readable(sag, "m"), sag / thickness,
           travels ? ", the ends of the window. Widen the window until they no longer change, or "
                     "simulate a workpiece on a support in a frame at rest"
                   : ". Support it, as by a rigid body below it")});
}

// Of several jets, of which the first met nothing or another cut.
void add_flag_of_other_jet(const RunOutcome& outcome, std::vector<ValidityFlag>& flags) {
  const auto& jets = outcome.description.jets;
  const std::string& first = jets.front().name;
  const std::string what =
      is_cut_beside_first(outcome)
          ? fmt::format("What is cut is the way of another jet than the first, {}: that of {}.",
                        first, jets.at(static_cast<std::size_t>(outcome.cut.cut_jet)).name)
          : fmt::format(
                "What is cut or broken is the work of another jet than the first, {}, "
                "which had met no solid by then.",
                first);
  flags.push_back(
      {"other_jet",
       ValidityFlag::State::warning,
       {},
       {},
       what + fmt::format(" The front is that of {}, and the depth of the cut and the kerf are "
                          "measured along its axis: name the jet that cuts first in the case.",
                          first)});
}

}  // namespace

void add_parting_flags(const RunOutcome& outcome, std::vector<ValidityFlag>& flags) {
  const CutSummary& cut = outcome.cut;
  if (is_of_other_jet(outcome)) return add_flag_of_other_jet(outcome, flags);
  const double share = cut.front_share_at_cut;
  add_flag_of_sag(outcome, flags);
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
