// SPDX-License-Identifier: Apache-2.0
// Least squares with intervals: docs/theory/reduced_model.md.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Dense>

namespace kerf {

struct Fit {
  std::string problem;  // why there is none; empty when there is one
  Eigen::VectorXd parameters;
  Eigen::MatrixXd covariance;  // of the parameters
  double residual = 0.0;       // standard deviation of the data about the fit
  int freedom = 0;             // data less parameters
  double explained = 0.0;      // R^2, share of the variance of the data that the fit explains

  double standard_error(int parameter) const;
  // Half of the interval around a parameter that covers it with this probability.
  double half_interval(int parameter, double coverage) const;
  // The same for a new datum whose derivatives by the parameters these are, its scatter included.
  double half_prediction(const Eigen::VectorXd& derivatives, double coverage) const;
};

// Student's t: the half-width, in standard errors, that covers with this probability.
double student_factor(int freedom, double coverage);

// The parameters of data = matrix * parameters, by QR with pivots.
Fit fit_linear(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& data);

// What a model says of the data at some parameters, and its derivatives by them, one row per datum.
struct ModelValue {
  Eigen::VectorXd values;
  Eigen::MatrixXd derivatives;
};
using Model = std::function<ModelValue(const Eigen::VectorXd& parameters)>;

// The parameters of a model that is not linear in them, by Gauss and Newton with steps halved until
// they help. A model says by values that are not finite where it has no meaning.
Fit fit_model(const Model& model, const Eigen::VectorXd& data, const Eigen::VectorXd& start);

}  // namespace kerf
