// SPDX-License-Identifier: Apache-2.0
// This header declares the goals of a study: a threshold, an optimum, a calibration, a model.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/axis.hpp"

namespace kerf {

// The condition on a run: a number of its result lies on one side of a bound. Under a nozzle that
// stands in place of one that moves, the cut and the share of its path that is cut through are
// those of the feed (cuts() in study/metrics.hpp).
struct Condition {
  std::string metric = "cut_through";
  double bound = 0.5;     // SI
  bool at_least = true;   // otherwise at most
  std::string written{};  // the bound with its unit, as the user wrote it; "" = by the program
  // Whether it asks of such a run whether its feed cuts.
  bool is_of_feed(const std::map<std::string, double>& metrics) const;
  // Returns by how much the share of the path that is cut through may be too small: a part of the
  // workpiece that has left the domain whole, cut or not, counts as standing. In 2D all of it lies
  // in the plane of the path; in 3D it may have lain beside the path, and is not counted.
  double uncertain_share(const std::map<std::string, double>& metrics) const;
  // Whether the condition would hold if what has left the domain whole had been cut.
  bool may_hold(const std::map<std::string, double>& metrics) const;
  bool holds(const std::map<std::string, double>& metrics) const;
  // Returns by how much a run satisfies the condition, 1; below 0 it does not. For cut-through it
  // is the remaining share of the time of the run, or minus that of the thickness; otherwise the
  // distance of the metric from the bound, over the bound.
  double margin(const std::map<std::string, double>& metrics) const;
  std::string text() const;
};

// The least (or greatest) value of one key at which the condition holds. The condition is expected
// to hold at no value below the least one and at every value above it; for the greatest value it is
// the reverse.
struct ThresholdGoal {
  Axis axis;          // its range is searched
  bool least = true;  // otherwise the greatest
  Condition condition;
  double tolerance = 0.05;  // half-width of the bracket over its middle
  double draft = 0.5;       // resolution of the drafts over that of the study; 1 = none
  int most_runs = 24;
  int repeats = 1;  // layouts in which the bracket must hold
  // The first value that is run. The search leaves it by factors of 2 towards the threshold, and
  // the ends of the range are the last values that it tries. Without it the range is divided.
  std::optional<double> start;
  // Returns whether the run lies beyond the threshold: for a least value, where the condition
  // holds.
  bool is_beyond(const std::map<std::string, double>& metrics) const {
    return condition.holds(metrics) == least;
  }
};

// The setting of the axes of the study at which a metric is least (or greatest) while the condition
// holds.
struct OptimumGoal {
  std::vector<Axis> axes;  // each a range
  std::string metric;
  bool least = true;
  Condition condition;
  double tolerance = 0.02;  // of the range of each axis
  double draft = 0.5;
  int most_runs = 30;
  int repeats = 1;
};

// The value of a material's key at which a cut is as measured.
struct CalibrationGoal {
  Axis axis;                  // the key that is fitted; its range is searched
  Setting at;                 // the setting of the measured cut
  std::vector<Axis> at_axes;  // its keys
  std::string metric;         // the measured quantity; with "cut_through" cutting begins at `at`
  double measured = 0.0;      // SI
  double uncertainty = 0.0;   // SI, standard uncertainty of `measured`
  std::string shown_unit;     // of `measured`, as the study file has it; "" = none
  double shown_factor = 1.0;  // SI units that one of them has
  double tolerance = 0.05;    // relative, of the key
  int most_runs = 16;
  std::vector<Setting> predict;  // settings at which the metric is predicted
  // Returns a value of the metric in the unit of `measured`.
  std::string metric_text(double value) const;
};

enum class ModelForm { power, threshold_linear, threshold_power };

// A formula of a metric in varied keys: docs/theory/reduced_model.md.
struct ModelGoal {
  ModelForm form = ModelForm::threshold_power;
  std::string metric = "kerf.depth";
  std::string drive;                   // the key or metric that has the threshold
  std::vector<std::string> variables;  // further keys or metrics, each with an exponent
  double floor = 0.0;                  // SI; runs with a smaller metric are left out
  int table_points = 9;                // of model.csv along each variable
};

}  // namespace kerf
