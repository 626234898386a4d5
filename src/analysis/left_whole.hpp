// SPDX-License-Identifier: Apache-2.0
// Solid that stood until it left the domain was carried off, not cut.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/kerf_map.hpp"

namespace kerf {

// Notes which slots stand and which have left the domain since they stood (slot_trace).
void note_traces(const std::vector<std::uint32_t>& rows, const std::vector<std::uint8_t>& standing,
                 std::vector<std::uint8_t>& traces);

// Marks the solid that stood until it left the domain as closed, and what stands beside it, whose
// bonds to it are gone.
std::vector<std::uint8_t> closed_where_left(const Workpiece& workpiece,
                                            std::vector<std::uint8_t> standing,
                                            const std::vector<std::uint8_t>& traces);

// Returns whether a body is leaving the domain whole (BodyCut::left).
bool has_left(const WorkpieceBody& body, const KerfView& view,
              const std::vector<std::uint8_t>& traces);

}  // namespace kerf
