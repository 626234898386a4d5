// SPDX-License-Identifier: Apache-2.0
// This header declares the pilot run of a case: coarse and short, so that within about half a
// minute it shows whether the case is set up as it was meant.
#pragma once

#include <string>
#include <vector>

namespace kerf {

// The first line of the file of a pilot run, by which the next one knows that it may replace it.
inline constexpr const char* pilot_mark =
    "# A pilot run, made by kerf view --edit. The next pilot run replaces this file.\n";

struct PilotRun {
  std::string text;                  // of the case that runs
  std::vector<std::string> changes;  // what differs from the case, a sentence each
};

// Returns the pilot run of a case: in draft quality, with the spacings that the case gives
// coarsened as much where the coarser case is valid, and ended where it has run long enough, but
// not before the jet has arrived. Throws the CaseError of a case that is not valid.
PilotRun pilot_run(const std::string& text, const std::string& file, int threads);

}  // namespace kerf
