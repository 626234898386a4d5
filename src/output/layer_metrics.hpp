// SPDX-License-Identifier: Apache-2.0
// The layers of a kerf as result.json lists them.
#pragma once

#include "analysis/kerf.hpp"

namespace kerf {

// A layer of a kerf by the name of its body.
struct NamedLayer {
  std::string name;
  KerfLayer layer;

  static const MetricList<NamedLayer>& metrics();
};

inline constexpr const char* cut_on_part_of_way = "cut through on a part of the way";

// Returns the fate of a layer in words: `cut through`; `cut through on a part of the way`, where
// all of its thickness is removed on less than half of the way of the nozzle; `parted` or, where no
// sides of it are parted, `broken through`, where it is cut through and not all of its thickness is
// removed; `punched out` around a plug; `cut in part`; `whole`, where nothing of it is fractured;
// or `not under the jet`.
std::string fate_of(const KerfLayer& layer);

// The layers with the names of the bodies of the case.
std::vector<NamedLayer> named_layers(const Kerf& kerf, const Case& description);

}  // namespace kerf
