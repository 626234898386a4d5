// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "study/read_axis.hpp"
#include "study/study_plan.hpp"
#include "study/study_section.hpp"

namespace kerf {

// Reads [search], [calibrate] and [model] of a study into the plan.
void read_goals(StudySection& top, AxisReader& reader, StudyPlan& plan);

}  // namespace kerf
