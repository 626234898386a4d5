// SPDX-License-Identifier: Apache-2.0
// A case of a few particles and the files that a run of it leaves.
#pragma once

#include <filesystem>
#include <string>

#include "app/run_loop.hpp"
#include "engine/device.hpp"
#include "input/read.hpp"
#include "support/small_block.hpp"

namespace kerf::test {

inline const std::string small_case = std::string(small_block) + R"([output]
frame_interval = "0.2 ms"
picture_times = ["0.4 ms"]
series_interval = "0.02 ms"
)";

inline RunLoopSettings small_settings(const std::filesystem::path& folder, Existing existing) {
  RunLoopSettings settings =
      settings_of_case(parse_case(small_case, "small.toml"), "small.toml", folder);
  settings.existing = existing;
  settings.quiet = true;
  settings.catches_signals = false;
  return settings;
}

// Makes the run up to its end.
inline void run_small(const std::filesystem::path& folder) {
  RunLoop(small_settings(folder, Existing::refuse), make_simulation).run();
}

}  // namespace kerf::test
