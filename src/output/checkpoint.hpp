// SPDX-License-Identifier: Apache-2.0
// A checkpoint, checkpoint.h5, contains everything that a run needs to continue bit for bit as if
// never stopped. The file is replaced atomically, ends with a checksum over all preceding bytes,
// and contains its case. For the tools of HDF5 it is a plain HDF5 file. It holds
// - the fields of the particles: the rows STATE of particles/fields.hpp (simulation/state_io.hpp),
// - clock, counters, balance, nozzles and the shifts of a frame that travels:
//   simulation/particle_run_checkpoint.hpp,
// - what a formulation adds: save() in standard/standard.hpp and standard/solid_part.hpp,
// - the history of the cut and the clocks of the output: app/run_record.cpp.
#pragma once

#include <filesystem>
#include <string>

#include "simulation/archive.hpp"

namespace kerf {

struct Checkpoint {
  Archive simulation;  // of Simulation::save
  Archive run;         // of the run loop: clocks, counts, the history of the cut
};

// Writes a checkpoint. `case_text` is the content of case.used.toml. Throws UserError (exit_files);
// an older checkpoint at `path` then remains.
void write_checkpoint(const std::filesystem::path& path, const std::string& case_text,
                      const Checkpoint& checkpoint);

// Returns the text of the case of a checkpoint. Throws as read_checkpoint does.
std::string case_of_checkpoint(const std::filesystem::path& path);

// Reads a checkpoint. Throws UserError (exit_files) with one sentence for a file that is missing,
// damaged, not a checkpoint, of another version of the format, or of a case other than `case_text`.
Checkpoint read_checkpoint(const std::filesystem::path& path, const std::string& case_text);

}  // namespace kerf
