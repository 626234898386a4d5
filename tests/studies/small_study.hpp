// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace kerf::test {

// A case that runs in a fraction of a second.
inline constexpr const char* small_study_case = R"(title = "small"
dimension = 2
[time]
end = "6 ms"
[domain]
minimum = ["-40 mm", "-20 mm"]
maximum = ["40 mm", "40 mm"]
[materials.curd]
base = "tofu"
poisson_ratio = 0.45
failure_strain = 0.1
[[body]]
name = "block"
material = "curd"
shape = { type = "box", minimum = ["-12 mm", "0 mm"], maximum = ["12 mm", "8 mm"] }
spacing = "2 mm"
[[jet]]
name = "jet"
material = "water"
speed = "5 m/s"
width = "6 mm"
position = ["0 mm", "8 mm"]
standoff = "4 mm"
spacing = "2 mm"
[output]
frame_interval = "6 ms"
picture_times = ["0 ms"]
)";

}  // namespace kerf::test
