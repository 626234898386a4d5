// SPDX-License-Identifier: Apache-2.0
// The kerf and the machine in result.json.
#pragma once

#include <nlohmann/json.hpp>

#include "case/case.hpp"
#include "measure/kerf.hpp"

namespace kerf {

nlohmann::ordered_json shape_json(const KerfShape& shape);
// Layers have the names of the bodies of the case.
nlohmann::ordered_json kerf_json(const Kerf& kerf, const Case& description);
// The setting and what follows from it.
nlohmann::ordered_json machine_json(const Machine& machine, const Case& description);

}  // namespace kerf
