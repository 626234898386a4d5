// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace kerf::test {

// A jet splits a soft block whose spacing is doubled twice away from the jet; the pairs beside the
// jumps have factors, since most of its stiffness is in its density.
inline constexpr const char* jet_on_graded_block = R"(title = "Jet on a graded block"
dimension = 2
[time]
end = "16 ms"
[domain]
minimum = ["-150 mm", "-20 mm"]
maximum = ["150 mm", "100 mm"]
[materials.curd]
base = "tofu"
poisson_ratio = 0.493
criterion = "crack_band"
failure_strain = 0.05
fracture_energy = "10 J/m2"
[[body]]
name = "block"
material = "curd"
shape = { type = "box", minimum = ["-64 mm", "0 mm"], maximum = ["64 mm", "48 mm"] }
spacing = "2 mm"
grading = { levels = 2, width = "24 mm" }
[[body]]
name = "plate"
role = "rigid"
shape = { type = "box", minimum = ["-80 mm", "-8 mm"], maximum = ["80 mm", "0 mm"] }
spacing = "2 mm"
[[jet]]
name = "jet"
material = "water"
speed = "8 m/s"
width = "10 mm"
position = ["0 mm", "48 mm"]
standoff = "20 mm"
spacing = "2 mm"
[output]
frame_interval = "1 ms"
series_interval = "0.5 ms"
)";

}  // namespace kerf::test
