// SPDX-License-Identifier: Apache-2.0
// This header declares the runs of a calibration: the metric at values of the key.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "study/goals.hpp"
#include "study/laboratory.hpp"
#include "study/metric_jump.hpp"

namespace kerf {

// A key is given by its logarithm, where it is not called a value.
class CalibrationRuns {
 public:
  CalibrationRuns(const CalibrationGoal& goal, double refinement, Laboratory& laboratory)
      : goal_(goal), refinement_(refinement), laboratory_(laboratory) {}

  Trial trial(double value, const Setting& setting) const;
  // Returns the metric of a run; throws if it has none.
  double metric_of(const Outcome& outcome) const;
  // Makes runs at values that must have the metric, and returns it.
  std::vector<double> measure(const std::vector<double>& values);
  // Makes runs of which some may lack the metric, such as a time of cut-through where nothing is
  // cut through.
  void try_values(const std::vector<double>& values);
  // Returns the metric of the run at a key, which is made unless there is one. A run so near to
  // another that it would tell nothing new is not made: the method of the root steps by rounding
  // errors where a run has exactly the measured value.
  double metric_at(double key);
  // Returns the key of the run that metric_at() uses.
  double made_run(double key) const;

  // Samples the range in one round and returns two neighbours between which the metric crosses the
  // measured value. Where there are none, the way is halved between runs with the metric and their
  // neighbours without it, as the value may lie there.
  std::optional<std::pair<double, double>> find_crossing();
  // Returns why there is no crossing.
  std::string no_crossing() const;

  int made() const { return static_cast<int>(known_.size() + lacking_.size()); }
  int left() const { return goal_.most_runs - made(); }
  const MetricByKey& known() const { return known_; }
  // Returns the runs with those that lack the metric, which miss every value of it.
  MetricByKey all() const;

 private:
  bool has_metric(const Outcome& outcome) const;
  MetricByKey::const_iterator run_beside(double key) const;
  std::optional<std::pair<double, double>> crossing() const;
  std::optional<double> key_before_lacking() const;

  const CalibrationGoal& goal_;
  double refinement_;
  Laboratory& laboratory_;
  MetricByKey known_;
  std::vector<double> lacking_;  // keys at which runs have no such metric
};

}  // namespace kerf
