// SPDX-License-Identifier: Apache-2.0
// checkpoint.h5: everything a run needs to go on bitwise as if never stopped. The file is replaced
// atomically, ends with a checksum over all before, and holds the case it is of. To HDF5's own
// tools it is a plain HDF5 file.
#pragma once

#include <filesystem>
#include <string>

#include "simulation/archive.hpp"

namespace kerf {

struct Checkpoint {
  Archive simulation;  // of Simulation::save
  Archive run;         // of the run loop: clocks, counts, the history of the cut
};

// `case_text` is the content of case.used.toml. Throws UserError (exit_files); an older checkpoint
// at `path` is then still there.
void write_checkpoint(const std::filesystem::path& path, const std::string& case_text,
                      const Checkpoint& checkpoint);

// Throws UserError (exit_files) with one sentence for a file that is missing, torn, not a
// checkpoint, of another version of the format, or of a case other than `case_text`.
Checkpoint read_checkpoint(const std::filesystem::path& path, const std::string& case_text);

}  // namespace kerf
