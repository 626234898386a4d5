// SPDX-License-Identifier: Apache-2.0
// This header declares the reduced model, a formula fitted to the runs of a study:
// docs/theory/reduced_model.md.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "study/goals.hpp"
#include "study/least_squares.hpp"

namespace kerf {

// The numbers of one run to which the model is fitted.
struct ModelDatum {
  std::map<std::string, double> variables;  // the drive and the others, SI
  double value = 0.0;                       // the metric, SI
};

struct ModelRange {
  double low = 0.0, high = 0.0;
};

struct ModelParameter {
  std::string name;
  double value = 0.0;
  double low = 0.0, high = 0.0;  // the interval that covers the parameter with 95%
};

// The prediction for a setting, with the interval that covers a run of it with 95%.
struct ModelPrediction {
  double value = 0.0, low = 0.0, high = 0.0;
};

class ReducedModel {
 public:
  // Fits the data whose value is above the goal's floor.
  ReducedModel(const ModelGoal& goal, const std::vector<ModelDatum>& data);

  // Returns why there is no model; empty when there is one.
  const std::string& problem() const { return fit_.problem; }
  std::vector<ModelParameter> parameters() const;
  // Returns the ranges of the data that were used, in which the model is valid.
  const std::map<std::string, ModelRange>& ranges() const { return ranges_; }
  ModelPrediction predict(const std::map<std::string, double>& variables) const;
  const Fit& fit() const { return fit_; }
  int used() const { return used_; }
  std::string formula() const;
  // Returns predictions on a grid over the ranges as a table for controllers. All values are in SI
  // units, which `unit` returns for a name.
  std::string table_csv(const std::function<std::string(const std::string&)>& unit) const;

 private:
  void fit_threshold_linear(const std::vector<ModelDatum>& data);
  void fit_powers(const std::vector<ModelDatum>& data);
  ModelValue powers(const std::vector<ModelDatum>& data, const Eigen::VectorXd& parameters) const;
  Eigen::VectorXd power_start(const std::vector<ModelDatum>& data) const;
  std::vector<std::string> names() const;

  ModelGoal goal_;
  Fit fit_;
  std::map<std::string, ModelRange> ranges_;
  int used_ = 0;
};

}  // namespace kerf
