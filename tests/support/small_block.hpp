// SPDX-License-Identifier: Apache-2.0
// The text of a case of a few particles: a jet on a block in 2D.
#pragma once

namespace kerf::test {

inline constexpr const char* small_block = R"(title = "A small block"
dimension = 2
[time]
end = "0.4 ms"
[[body]]
name = "block"
material = "tofu"
shape = { type = "box", minimum = ["-8 mm", "0 mm"], maximum = ["8 mm", "6 mm"] }
spacing = "2 mm"
[[jet]]
name = "jet"
speed = "5 m/s"
width = "4 mm"
position = ["0 mm", "6 mm"]
standoff = "2 mm"
spacing = "2 mm"
)";

}  // namespace kerf::test
