// SPDX-License-Identifier: Apache-2.0
#include "output/parting_flags.hpp"

#include <fmt/format.h>

#include "model/case.hpp"
#include "output/result.hpp"

namespace kerf {

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
  if (cut.gave_way() && machine && machine->traverse_speed > 0.0)
    flags.push_back(
        {"gave_way", ValidityFlag::State::note, share, CutSummary::greatest_share,
         fmt::format(
             "The front of the water was {:.2g} thicknesses deep when the workpiece was cut "
             "through: it gave way before. Its edges may evade a nozzle that moves.",
             share)});
}

}  // namespace kerf
