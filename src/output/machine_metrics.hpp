// SPDX-License-Identifier: Apache-2.0
// The metrics of a machine: its setting, and the jet that follows from it.
#pragma once

#include "analysis/metric.hpp"

namespace kerf {

struct Case;

// A case with a machine.
struct MachineRecord {
  const Case& description;

  // Settings that the machine does not have are missing.
  static const MetricList<MachineRecord>& setting();
  static const MetricList<MachineRecord>& jet();
};

}  // namespace kerf
