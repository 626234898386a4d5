// SPDX-License-Identifier: Apache-2.0
// The metrics of the balance of mass, momentum and energy, for series.csv, result.json and the
// report.
#pragma once

#include "analysis/metric.hpp"
#include "simulation/balance.hpp"

namespace kerf {

// The terms of the balance; vectors have three components.
const MetricList<Balance>& balance_terms();
// The errors of the balance: missing mass, momentum and energy, relative to what came in.
const MetricList<Balance>& balance_errors();

}  // namespace kerf
