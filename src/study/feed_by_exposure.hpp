// SPDX-License-Identifier: Apache-2.0
// This header declares the greatest feed of a nozzle that stands in the run: one run tells up to
// which feed its cut is certain, and up to which it is possible (docs/theory/exposure.md).
#pragma once

#include "study/limit_answer.hpp"
#include "study/limit_plan.hpp"
#include "study/searches.hpp"

namespace kerf {

// Runs the case in each layout that is asked, and at the coarser spacing of drafts. The bracket
// goes from the least feed that is certain to the greatest that is possible; `problem` where a run
// tells none. No feed exceeds the speed of the jet, and none is certain that a run denies.
ThresholdAnswer feed_by_exposure(const LimitPlan& plan, Laboratory& laboratory);

// Adds the feeds that were found to the words: expected instead of certain where a run ended before
// its jet was through.
void describe_feeds(const LimitPlan& plan, const LimitAnswer& answer, LimitWords& words);

}  // namespace kerf
