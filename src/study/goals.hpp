// SPDX-License-Identifier: Apache-2.0
// What a study may be asked for.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/axis.hpp"

namespace kerf {

// Whether a run is good: a number of its result on one side of a bound.
struct Condition {
  std::string metric = "cut_through";
  double bound = 0.5;    // SI
  bool at_least = true;  // else at most
  bool holds(const std::map<std::string, double>& metrics) const;
  std::string text() const;
};

// The least (or greatest) value of one key at which the condition holds. Below the least value it
// nowhere holds, above it everywhere; for the greatest value the other way round.
struct ThresholdGoal {
  Axis axis;          // its range is searched
  bool least = true;  // else the greatest
  Condition condition;
  double tolerance = 0.05;  // half of the bracket over its middle
  double draft = 0.5;       // resolution of the first runs over that of the study; 1 = no drafts
  int most_runs = 24;
  int repeats = 1;  // layouts at which the bracket must hold
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

// A material's key from one measured cut.
struct CalibrationGoal {
  Axis axis;                  // the key that is fitted; its range is searched
  Setting at;                 // the setting of the measured cut
  std::vector<Axis> at_axes;  // its keys
  std::string metric;         // what was measured; with "cut_through" the setting is a threshold
  double measured = 0.0;      // SI
  double uncertainty = 0.0;   // SI, standard uncertainty of it
  double tolerance = 0.05;    // of the key
  int most_runs = 16;
  std::vector<Setting> predict;  // other settings, to be predicted with the fitted key
};

enum class ModelForm { power, threshold_linear, threshold_power };

// Depth (or another metric) as a formula of varied keys: docs/theory/reduced_model.md.
struct ModelGoal {
  ModelForm form = ModelForm::threshold_power;
  std::string metric = "kerf.depth";
  std::string drive;                   // key or metric with the threshold
  std::vector<std::string> variables;  // further keys or metrics, each with an exponent
  double floor = 0.0;                  // SI; runs with less count as no cut and are left out
  int table_points = 9;                // of the exported table, along each variable
};

}  // namespace kerf
