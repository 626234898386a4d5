// SPDX-License-Identifier: Apache-2.0
// This header declares least-squares fits with intervals: docs/theory/reduced_model.md.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Dense>

namespace kerf {

struct Fit {
  std::string problem;  // why there is no fit; empty = there is one
  Eigen::VectorXd parameters;
  Eigen::MatrixXd covariance;  // of the parameters
  double residual = 0.0;       // standard deviation of the data about the fit
  int freedom = 0;             // number of data minus number of parameters
  double explained = 0.0;      // R^2, the explained share of the variance

  double standard_error(int parameter) const;
  // Returns the half-width of the interval that covers a parameter with this probability.
  double half_interval(int parameter, double coverage) const;
  // Returns the half-width for a new datum, scatter included, from its derivatives by the
  // parameters.
  double half_prediction(const Eigen::VectorXd& derivatives, double coverage) const;
};

// Returns the two-sided quantile of Student's t: the half-width in standard errors.
double student_factor(int freedom, double coverage);

// Fits data = matrix * parameters by a QR decomposition with column pivoting.
Fit fit_linear(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& data);

// Fits y = parameters[0] + parameters[1] (x - origin) to points (x, y).
Fit fit_line(const std::vector<std::pair<double, double>>& points, double origin);

// The values of a model at some parameters and their derivatives, one row for each datum.
struct ModelValue {
  Eigen::VectorXd values;
  Eigen::MatrixXd derivatives;
};
using Model = std::function<ModelValue(const Eigen::VectorXd& parameters)>;

// Fits a model that is not linear in its parameters by the Gauss-Newton method; a step is halved
// until it reduces the residual. Values that are not finite mark parameters at which the model is
// undefined.
Fit fit_model(const Model& model, const Eigen::VectorXd& data, const Eigen::VectorXd& start);

}  // namespace kerf
