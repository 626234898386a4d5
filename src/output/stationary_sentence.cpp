// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "model/case.hpp"
#include "output/readable.hpp"
#include "output/result.hpp"
#include "output/verdict_parts.hpp"

namespace kerf {

std::string stationary_sentence(const RunOutcome& outcome) {
  if (!outcome.stationary) return "";
  const StationaryCut& cut = *outcome.stationary;
  const std::string travelled = readable(cut.travelled, "m");
  if (cut.reached)
    return fmt::format(
        " The cut is stationary after {} of travel: {} deep, and its front lags by {}.", travelled,
        readable(cut.depth, "m"), readable(cut.lag, "m"));
  if (std::isnan(cut.change))
    return fmt::format(" The cut did not become stationary within {} of travel.", travelled);
  return fmt::format(
      " The cut did not become stationary within {} of travel: over the last {:g} jet widths it "
      "changed by {:.1f}%.",
      travelled, stretch_widths, 100.0 * cut.change);
}

}  // namespace kerf
