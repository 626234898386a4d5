// SPDX-License-Identifier: Apache-2.0
#include "study/least_squares.hpp"

#include <fmt/format.h>

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

namespace kerf {

namespace {

// Computes the residual, R^2 and the covariance s^2 (J^T J)^-1 at the fitted parameters, with s^2
// the sum of squares over the degrees of freedom.
void add_statistics(Fit& fit, const Eigen::MatrixXd& derivatives, const Eigen::VectorXd& errors,
                    const Eigen::VectorXd& data) {
  fit.freedom = static_cast<int>(data.size() - derivatives.cols());
  const double squares = errors.squaredNorm();
  const double variance = squares / fit.freedom;
  fit.residual = std::sqrt(variance);
  fit.covariance = variance * (derivatives.transpose() * derivatives).inverse();
  const double spread = (data.array() - data.mean()).matrix().squaredNorm();
  fit.explained = spread > 0.0 ? 1.0 - squares / spread : 1.0;
}

Fit too_few(Eigen::Index data, Eigen::Index parameters) {
  Fit fit;
  fit.problem = fmt::format("{} runs are too few for {} parameters; at least {} are needed", data,
                            parameters, parameters + 1);
  return fit;
}

Fit undetermined() {
  Fit fit;
  fit.problem = "the runs do not determine the parameters: vary each variable independently";
  return fit;
}

using Solver = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;

// Scales the columns to equal norms, so that the test of their rank does not depend on units.
struct Scaled {
  explicit Scaled(const Eigen::MatrixXd& matrix)
      : sizes(matrix.colwise().norm().cwiseMax(std::numeric_limits<double>::min())),
        solver(matrix * sizes.cwiseInverse().asDiagonal()) {
    constexpr double dependent = 1e-9;
    solver.setThreshold(dependent);
  }
  bool is_full() const { return solver.rank() == sizes.size(); }
  Eigen::VectorXd solve(const Eigen::VectorXd& data) const {
    return solver.solve(data).cwiseQuotient(sizes.transpose());
  }

  Eigen::RowVectorXd sizes;
  Solver solver;
};

double squares_at(const ModelValue& value, const Eigen::VectorXd& data) {
  if (!value.values.allFinite()) return std::numeric_limits<double>::infinity();
  return (data - value.values).squaredNorm();
}

}  // namespace

double student_factor(int freedom, double coverage) {
  const boost::math::students_t distribution(freedom);
  return boost::math::quantile(distribution, 0.5 + 0.5 * coverage);
}

double Fit::standard_error(int parameter) const {
  return std::sqrt(covariance(parameter, parameter));
}

double Fit::half_interval(int parameter, double coverage) const {
  return student_factor(freedom, coverage) * standard_error(parameter);
}

double Fit::half_prediction(const Eigen::VectorXd& derivatives, double coverage) const {
  const double variance = residual * residual + derivatives.dot(covariance * derivatives);
  return student_factor(freedom, coverage) * std::sqrt(variance);
}

Fit fit_linear(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& data) {
  if (matrix.rows() <= matrix.cols()) return too_few(matrix.rows(), matrix.cols());
  const Scaled scaled(matrix);
  if (!scaled.is_full()) return undetermined();
  Fit fit;
  fit.parameters = scaled.solve(data);
  add_statistics(fit, matrix, data - matrix * fit.parameters, data);
  return fit;
}

Fit fit_line(const std::vector<std::pair<double, double>>& points, double origin) {
  const auto count = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd matrix(count, 2);
  Eigen::VectorXd data(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& [x, y] = points[static_cast<std::size_t>(i)];
    matrix.row(i) << 1.0, x - origin;
    data[i] = y;
  }
  return fit_linear(matrix, data);
}

Fit fit_model(const Model& model, const Eigen::VectorXd& data, const Eigen::VectorXd& start) {
  constexpr int most_steps = 200, most_halvings = 40;
  constexpr double tolerance = 1e-12;  // relative decrease of the sum of squares
  if (data.size() <= start.size()) return too_few(data.size(), start.size());
  Fit fit;
  fit.parameters = start;
  ModelValue value = model(start);
  double squares = squares_at(value, data);
  for (int step = 0; step < most_steps; ++step) {
    const Scaled scaled(value.derivatives);
    if (!scaled.is_full()) return undetermined();
    const Eigen::VectorXd change = scaled.solve(data - value.values);
    double share = 1.0, next = std::numeric_limits<double>::infinity();
    ModelValue tried;
    for (int halving = 0; halving < most_halvings && !(next < squares); ++halving, share *= 0.5) {
      tried = model(fit.parameters + share * change);
      next = squares_at(tried, data);
    }
    if (!(next < squares)) break;
    fit.parameters += 2.0 * share * change;  // the loop halved it once more
    const bool is_converged = squares - next <= tolerance * squares;
    value = tried;
    squares = next;
    if (is_converged) break;
  }
  add_statistics(fit, value.derivatives, data - value.values, data);
  return fit;
}

}  // namespace kerf
