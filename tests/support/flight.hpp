// SPDX-License-Identifier: Apache-2.0
// The smallest case that `kerf verify` can run: a block moves at 3 m/s through empty space.
#pragma once

#include <string_view>

namespace kerf::test {

inline constexpr std::string_view flight = R"(
title = "a block flies"
dimension = 2
formulation = "shinohara2004"
[time]
end = "0.1 ms"
[domain]
minimum = ["-100 mm", "-100 mm"]
maximum = ["100 mm", "100 mm"]
[[body]]
name = "block"
material = "rubber"
shape = { type = "box", minimum = ["0 mm", "0 mm"], maximum = ["8 mm", "8 mm"] }
spacing = "2 mm"
velocity = ["3 m/s", "0 m/s"]
)";

}  // namespace kerf::test
