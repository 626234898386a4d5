// SPDX-License-Identifier: Apache-2.0
// The metrics of a machine: its setting, and the jet that follows from it.
#pragma once

#include "analysis/metric.hpp"
#include "model/case.hpp"

namespace kerf {

// A case with a machine.
struct MachineRecord {
  const Case& description;

  // Settings that the machine does not have are missing.
  static const MetricList<MachineRecord>& setting();
  static const MetricList<MachineRecord>& jet();
};

}  // namespace kerf
