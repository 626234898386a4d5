// SPDX-License-Identifier: Apache-2.0
// The smallest case that `kerf verify` can run: a block moves at 3 m/s through empty space.
#pragma once

#include <string>
#include <string_view>

#include "verification/plan.hpp"

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

// The case of the block in flight, with more of its plan.
inline VerificationCase flight_case(const std::string& more = "") {
  const std::string plan = R"(
title = "flight"
)" + more + R"(
[[run]]
name = "plain"
[[check]]
quantity = "speed"
runs = "plain"
signal = "body_mean"
field = "velocity"
axis = "x"
reduce = "last"
si_unit = "m/s"
unit = "m/s"
reference = 3
tolerance = 1e-6
source = "Newton"
)";
  const EmbeddedText texts[] = {{"flight/case", flight}, {"flight/reference", plan}};
  return read_verification_cases(texts, {}).at(0);
}

}  // namespace kerf::test
