// SPDX-License-Identifier: Apache-2.0
// A complete run of the fake simulation with all files that it writes into its folder.
#pragma once

#include <filesystem>
#include <memory>

#include "app/run_loop.hpp"
#include "input/write_used.hpp"
#include "support/fake_simulation.hpp"

namespace kerf::test {

inline void run_fake(const Case& description, const std::filesystem::path& folder) {
  RunLoopSettings settings;
  settings.description = description;
  settings.case_name = "fake";
  settings.case_text = write_used(description);
  settings.folder = folder;
  settings.quiet = true;
  RunLoop(settings, [](const Case& of) { return std::make_unique<FakeSimulation>(of); }).run();
}

}  // namespace kerf::test
