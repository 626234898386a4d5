// SPDX-License-Identifier: Apache-2.0
// Solid that stood until it left the domain was carried off, not cut.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/kerf_map.hpp"

namespace kerf {

// Marks as standing the rests of pieces that the edge of the domain divides: they stood in the last
// frame, and beside them solid has left that did. What is left of such a piece is no debris,
// however little it is.
void keep_divided(const Workpiece& workpiece, const Frame& frame,
                  const std::vector<std::uint32_t>& rows,
                  const std::vector<std::uint32_t>& body_piece,
                  const std::vector<std::uint8_t>& traces, std::vector<std::uint8_t>& standing);

// Notes which slots stand and which have left the domain since they stood (slot_trace).
void note_traces(const std::vector<std::uint32_t>& rows, const std::vector<std::uint8_t>& standing,
                 std::vector<std::uint8_t>& traces);

// Marks the solid that stood until it left the domain as closed, and what stands beside it, whose
// bonds to it are gone; and what stood in the last frame as standing (keep_divided). Without traces
// nothing has left.
std::vector<std::uint8_t> closed_where_left(const Workpiece& workpiece,
                                            std::vector<std::uint8_t> standing,
                                            const std::vector<std::uint8_t>& traces);

// Returns whether a body is leaving the domain whole (BodyCut::left).
bool has_left(const WorkpieceBody& body, const KerfView& view,
              const std::vector<std::uint8_t>& traces);

}  // namespace kerf
