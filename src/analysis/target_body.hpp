// SPDX-License-Identifier: Apache-2.0
// The solid to which the numbers of a case refer before it runs (analysis/derived.hpp).
#pragma once

namespace kerf {

struct Body;
struct Case;

// Returns the elastic body that the water of the fastest jet meets first, whatever the order of the
// bodies: where its axis enters them as laid out, else its edge, else its axis on the way of a
// nozzle that travels. Of bodies at one depth it is the softest. Where it meets none, and without a
// jet, it is the first elastic body. Bodies that are fixed count where there are no others; null
// without any.
const Body* target_body(const Case& description);

}  // namespace kerf
