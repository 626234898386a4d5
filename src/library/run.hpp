// SPDX-License-Identifier: Apache-2.0
// This header declares a run that other programs drive: the loop of `kerf run` step by step, with
// the same files and the same bits. All quantities are in SI units.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/public_symbol.hpp"
#include "engine/device.hpp"
#include "model/case.hpp"
#include "simulation/simulation.hpp"

namespace kerf {

class RunLoop;

struct RunOptions {
  std::filesystem::path folder;  // for the results; empty: out/<stem of the case file>
  int threads = 0;               // 0 = all cores; holds for all runs of the process
  Device device = Device::cpu;
  bool resume = false;          // continue the run in the folder, bit for bit
  bool replace = false;         // replace the run in the folder
  bool ignores_memory = false;  // run a case whose estimated memory is more than is free
  bool shows_progress = false;
  // How messages say that a run is continued, or run whatever its memory.
  std::string resume_words = "RunOptions::resume";
  std::string ignore_memory_words = "RunOptions::ignores_memory";
};

class KERF_PUBLIC Run {
 public:
  // Begins the run of a case, or continues the one in its folder. The case is checked as a case
  // file is. `case_file` names it in messages and results, and its meshes are found from there.
  // Throws UserError where the case is wrong, or the folder holds a run and no option says what to
  // do.
  explicit Run(const Case& description, const std::filesystem::path& case_file = "case.toml",
               const RunOptions& options = {});
  ~Run();
  Run(Run&& other) noexcept;
  Run& operator=(Run&& other) noexcept;

  // Each advances until it has done what it says, or until the run is over. They throw UserError
  // where the run breaks down; the message states up to which time it is saved.
  void step(std::uint64_t count = 1);
  void until(double time);                            // s
  void advance(const std::function<bool()>& enough);  // asked before each step

  // Whether finish() was called, or the run in the folder had ended before.
  bool has_finished() const;
  // Whether the end has come: the end time, a while after the cut, or a stationary cut.
  bool is_over() const;
  // Writes a checkpoint, from which RunOptions::resume continues.
  void save();
  // Runs to the end and writes the last frame, result.json and report.html. Then only
  // has_finished(), is_over() and folder() may be called.
  void finish();

  const std::filesystem::path& folder() const;
  // The case as it is computed, with every default.
  const Case& description() const;
  // The state between steps: time (s), fields of the particles, balance, probes.
  const Simulation& simulation() const;
  // A copy of the particles as they are now; valid until the next step.
  const Frame& frame();
  // What result.json would hold if the run ended now, as JSON.
  std::string result();
  // A picture of the particles, the bytes of a PNG file; `scale` multiplies its size.
  std::string picture(double scale = 1.0);

 private:
  RunLoop& loop() const;  // throws UserError when the run has finished

  std::unique_ptr<RunLoop> loop_;  // null once it has finished
  std::filesystem::path folder_;
};

}  // namespace kerf
