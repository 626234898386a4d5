// SPDX-License-Identifier: Apache-2.0
// The media of a run, from the bodies and jets of its case.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/nozzle.hpp"
#include "model/medium.hpp"

namespace kerf {

struct Body;
struct Case;

// Returns the number of the piece of each body; bodies joined to one another share one.
std::vector<std::uint16_t> pieces_of(const std::vector<Body>& bodies);

// The media in the order of simulation/media_order.hpp. `particles`: how many each body has.
std::vector<Medium<double>> make_media(const Case& description, const std::vector<Nozzle>& nozzles,
                                       const std::vector<std::size_t>& particles);

}  // namespace kerf
