// SPDX-License-Identifier: Apache-2.0
// A whole run of the made-up simulation, with all that it leaves in its folder.
#pragma once

#include <filesystem>
#include <memory>

#include "app/run_loop.hpp"
#include "case/write_used.hpp"
#include "support/fake_simulation.hpp"

namespace kerf::test {

inline void run_fake(const Case& description, const std::filesystem::path& folder) {
  RunSettings settings;
  settings.description = description;
  settings.case_name = "fake";
  settings.case_text = write_used(description);
  settings.folder = folder;
  settings.quiet = true;
  RunLoop(settings, [](const Case& of) { return std::make_unique<FakeSimulation>(of); }).run();
}

}  // namespace kerf::test
