// SPDX-License-Identifier: Apache-2.0
#include "study/reduced_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "input/units.hpp"
#include "study/run_table.hpp"

namespace kerf {

namespace {

constexpr double coverage = 0.95;

// The indices of the parameters of a power law with a threshold.
constexpr int at_threshold = 1, at_exponent = 2;

std::vector<ModelDatum> usable(const ModelGoal& goal, const std::vector<ModelDatum>& data) {
  std::vector<ModelDatum> result;
  for (const ModelDatum& datum : data)
    if (datum.value > goal.floor) result.push_back(datum);
  return result;
}

Eigen::VectorXd values_of(const std::vector<ModelDatum>& data) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(data.size()));
  for (std::size_t i = 0; i < data.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = data[i].value;
  return values;
}

}  // namespace

ReducedModel::ReducedModel(const ModelGoal& goal, const std::vector<ModelDatum>& data)
    : goal_(goal) {
  const auto used = usable(goal, data);
  used_ = static_cast<int>(used.size());
  for (const ModelDatum& datum : used)
    for (const auto& [name, value] : datum.variables) {
      const auto [range, is_new] = ranges_.try_emplace(name, ModelRange{value, value});
      range->second.low = std::min(range->second.low, value);
      range->second.high = std::max(range->second.high, value);
    }
  if (used.empty())
    fit_.problem = fmt::format("no run has {} above {:.6g}", goal.metric, goal.floor);
  else if (goal.form == ModelForm::threshold_linear)
    fit_threshold_linear(used);
  else
    fit_powers(used);
}

// Fits value = slope (drive - threshold) by the line value = a + slope drive, with threshold =
// -a / slope; the covariance follows from the derivatives of the threshold.
void ReducedModel::fit_threshold_linear(const std::vector<ModelDatum>& data) {
  const auto count = static_cast<Eigen::Index>(data.size());
  Eigen::MatrixXd matrix(count, 2);
  for (Eigen::Index i = 0; i < count; ++i)
    matrix.row(i) << 1.0, data[static_cast<std::size_t>(i)].variables.at(goal_.drive);
  fit_ = fit_linear(matrix, values_of(data));
  if (!fit_.problem.empty()) return;
  const double intercept = fit_.parameters[0], slope = fit_.parameters[1];
  Eigen::Matrix2d change;
  change << 0.0, 1.0, -1.0 / slope, intercept / (slope * slope);
  fit_.parameters << slope, -intercept / slope;
  fit_.covariance = (change * fit_.covariance * change.transpose()).eval();
}

// Computes ln value = ln factor + exponent ln(drive - threshold) + sum of exponent_k ln variable_k
// and its derivatives by the parameters.
ModelValue ReducedModel::powers(const std::vector<ModelDatum>& data,
                                const Eigen::VectorXd& parameters) const {
  const bool has_drive = !goal_.drive.empty();
  const bool has_threshold = has_drive && goal_.form == ModelForm::threshold_power;
  const auto count = static_cast<Eigen::Index>(data.size());
  ModelValue result{Eigen::VectorXd(count), Eigen::MatrixXd::Zero(count, parameters.size())};
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& variables = data[static_cast<std::size_t>(i)].variables;
    Eigen::Index column = 0;
    double sum = parameters[column];
    result.derivatives(i, column++) = 1.0;
    if (has_drive) {
      const double threshold = has_threshold ? parameters[column] : 0.0;
      const double excess = variables.at(goal_.drive) - threshold;
      const double exponent = parameters[has_threshold ? at_exponent : at_threshold];
      if (has_threshold) result.derivatives(i, column++) = -exponent / excess;
      result.derivatives(i, column++) = std::log(excess);
      sum += exponent * std::log(excess);
    }
    for (const std::string& name : goal_.variables) {
      result.derivatives(i, column) = std::log(variables.at(name));
      sum += parameters[column] * result.derivatives(i, column);
      ++column;
    }
    result.values[i] = sum;
  }
  return result;
}

// Returns start parameters: the threshold is set to several values below the data, at which the
// other parameters are linear, and the best fit is taken.
Eigen::VectorXd ReducedModel::power_start(const std::vector<ModelDatum>& data) const {
  const Eigen::VectorXd logarithms = values_of(data).array().log().matrix();
  const double lowest = ranges_.at(goal_.drive).low, span = ranges_.at(goal_.drive).high - lowest;
  const auto count = static_cast<Eigen::Index>(names().size());
  Eigen::VectorXd best(count);
  double least = std::numeric_limits<double>::infinity();
  for (const double below : {0.02, 0.05, 0.1, 0.2, 0.4, 0.8, 1.6}) {
    Eigen::VectorXd trial = Eigen::VectorXd::Ones(count);
    trial[at_threshold] = lowest - below * span;
    const ModelValue value = powers(data, trial);
    Eigen::MatrixXd matrix(value.derivatives.rows(), count - 1);
    matrix << value.derivatives.col(0), value.derivatives.rightCols(count - 2);
    const Fit fit = fit_linear(matrix, logarithms);
    if (!fit.problem.empty() || fit.residual >= least) continue;
    least = fit.residual;
    best << fit.parameters[0], trial[at_threshold], fit.parameters.tail(count - 2);
  }
  return std::isfinite(least) ? best : Eigen::VectorXd();
}

void ReducedModel::fit_powers(const std::vector<ModelDatum>& data) {
  const Eigen::VectorXd logarithms = values_of(data).array().log().matrix();
  const auto count = static_cast<Eigen::Index>(names().size());
  if (goal_.form == ModelForm::power) {
    const Eigen::VectorXd any = Eigen::VectorXd::Zero(count);
    fit_ = fit_linear(powers(data, any).derivatives, logarithms);
    return;
  }
  const Eigen::VectorXd start = power_start(data);
  if (start.size() == 0) {
    fit_.problem = "the runs do not determine the parameters: vary each variable independently";
    return;
  }
  fit_ = fit_model([&](const Eigen::VectorXd& parameters) { return powers(data, parameters); },
                   logarithms, start);
}

std::vector<std::string> ReducedModel::names() const {
  if (goal_.form == ModelForm::threshold_linear) return {"slope", "threshold"};
  std::vector<std::string> names{"ln factor"};
  if (goal_.form == ModelForm::threshold_power) names.emplace_back("threshold");
  if (!goal_.drive.empty()) names.push_back("exponent of " + goal_.drive);
  for (const std::string& name : goal_.variables) names.push_back("exponent of " + name);
  return names;
}

std::vector<ModelParameter> ReducedModel::parameters() const {
  std::vector<ModelParameter> result;
  if (!fit_.problem.empty()) return result;
  const auto known = names();
  for (std::size_t i = 0; i < known.size(); ++i) {
    const auto index = static_cast<int>(i);
    const double half = fit_.half_interval(index, coverage), value = fit_.parameters[index];
    result.push_back({known[i], value, value - half, value + half});
  }
  return result;
}

ModelPrediction ReducedModel::predict(const std::map<std::string, double>& variables) const {
  if (goal_.form == ModelForm::threshold_linear) {
    const double slope = fit_.parameters[0];
    const double excess = variables.at(goal_.drive) - fit_.parameters[1];
    if (excess <= 0.0) return {};
    Eigen::VectorXd derivatives(2);
    derivatives << excess, -slope;
    const double half = fit_.half_prediction(derivatives, coverage);
    return {slope * excess, std::max(0.0, slope * excess - half), slope * excess + half};
  }
  const ModelValue value = powers({{variables, 0.0}}, fit_.parameters);
  if (!std::isfinite(value.values[0])) return {};
  const double half = fit_.half_prediction(value.derivatives.row(0).transpose(), coverage);
  return {std::exp(value.values[0]), std::exp(value.values[0] - half),
          std::exp(value.values[0] + half)};
}

std::string ReducedModel::formula() const {
  if (goal_.form == ModelForm::threshold_linear)
    return fmt::format("{} = slope ({} - threshold)", goal_.metric, goal_.drive);
  std::string text = goal_.metric + " = factor";
  if (goal_.form == ModelForm::threshold_power)
    text += fmt::format(" ({} - threshold)^exponent", goal_.drive);
  else if (!goal_.drive.empty())
    text += fmt::format(" {}^exponent", goal_.drive);
  for (const std::string& name : goal_.variables) text += fmt::format(" {}^exponent", name);
  return text;
}

std::string ReducedModel::table_csv(
    const std::function<std::string(const std::string&)>& unit) const {
  std::vector<std::string> variables;
  if (!goal_.drive.empty()) variables.push_back(goal_.drive);
  for (const std::string& name : goal_.variables) variables.push_back(name);
  std::vector<std::string> head;
  for (const std::string& name : variables) head.push_back(with_unit(name, unit(name)));
  for (const char* which : {"", " low", " high"})
    head.push_back(with_unit(goal_.metric + which, unit(goal_.metric)));
  std::string text = fmt::format("{}\r\n", fmt::join(head, ","));
  const auto points = static_cast<std::size_t>(goal_.table_points);
  std::size_t rows = 1;
  for (std::size_t i = 0; i < variables.size(); ++i) rows *= points;
  for (std::size_t row = 0; row < rows; ++row) {
    std::map<std::string, double> point;
    std::size_t left = row;
    for (auto name = variables.rbegin(); name != variables.rend(); ++name, left /= points) {
      const ModelRange range = ranges_.at(*name);
      const double share = static_cast<double>(left % points) / (goal_.table_points - 1);
      point[*name] = between(range.low, range.high, share, false);
    }
    const ModelPrediction value = predict(point);
    for (const std::string& name : variables) text += shortest(point[name]) + ",";
    text += fmt::format("{:.6g},{:.6g},{:.6g}\r\n", value.value, value.low, value.high);
  }
  return text;
}

}  // namespace kerf
