// SPDX-License-Identifier: Apache-2.0
// The table series.csv has the numbers of a run over time, one row per output time. No column
// depends on the clock of the machine, so a resumed run ends with the same bytes as an
// uninterrupted one.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "analysis/cut.hpp"
#include "simulation/balance.hpp"
#include "simulation/simulation.hpp"

namespace kerf {

struct Case;

// The data of a row.
struct SeriesSample {
  double time = 0.0;  // s
  std::uint64_t step = 0;
  std::size_t particles = 0;
  StepInfo last_step;
  Balance balance;
  CutState cut;
  std::vector<double> probes;  // as Simulation::probe_values
};

// A column: its name, its unit ("1" = a number or a text) and its entry in a row.
struct SeriesColumn {
  std::string name;
  std::string unit;
  std::function<std::string(const SeriesSample&)> text;
};

// Returns the columns of a case's series in order. This is the only list of them.
std::vector<SeriesColumn> series_columns(const Case& description);
// Returns name and unit as one word, "front_depth_m", "momentum_now_x_N_s_per_m".
std::string header_of(const SeriesColumn& column);

class SeriesWriter {
 public:
  SeriesWriter(std::filesystem::path path, const Case& description);

  // Begins an empty table. Throws UserError (exit_files), as all that follow.
  void start();
  void append(const SeriesSample& sample);
  // Keeps the rows up to `step`, of which there must be `rows`, and drops those that a killed run
  // wrote after them. Refuses a table of another run.
  void cut_back(std::uint64_t step, std::size_t rows);
  // Synchronises the rows with the disk; to be called before a checkpoint relies on them.
  void sync() const;
  std::size_t rows() const { return rows_; }

 private:
  std::string header() const;

  std::filesystem::path path_;
  std::vector<SeriesColumn> columns_;
  std::size_t rows_ = 0;
};

// A table that was read: entries by the name of the column without its unit.
class SeriesTable {
 public:
  // Reads the table. Throws UserError (exit_files) when the file is missing or not a series of this
  // case.
  SeriesTable(const std::filesystem::path& path, const Case& description);
  std::size_t rows() const { return rows_; }
  std::vector<double> numbers(const std::string& name) const;
  const std::vector<std::string>& texts(const std::string& name) const;

 private:
  std::map<std::string, std::vector<std::string>> columns_;
  std::size_t rows_ = 0;
};

}  // namespace kerf
