// SPDX-License-Identifier: Apache-2.0
#include "study/read_goals.hpp"

namespace kerf {

void read_goals(StudySection&, AxisReader&, StudyPlan&) {}

}  // namespace kerf
