// SPDX-License-Identifier: Apache-2.0
#include "study/least_squares.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/random.hpp"

namespace kerf {
namespace {

// A normal number by Box & Muller, from the random numbers of a seed.
double normal(std::uint64_t seed, std::uint64_t n) {
  return std::sqrt(-2.0 * std::log(random_number(seed, 2 * n))) *
         std::cos(2.0 * std::numbers::pi * random_number(seed, 2 * n + 1));
}

// For 1 and 2 degrees of freedom Student's distribution has closed forms: Cauchy's, and
// P = t / sqrt(2 + t^2).
TEST(LeastSquares, StudentsFactorIsThatOfTheClosedForms) {
  for (const double coverage : {0.5, 0.68, 0.9, 0.95, 0.99}) {
    EXPECT_NEAR(student_factor(1, coverage) / std::tan(0.5 * std::numbers::pi * coverage), 1.0,
                1e-9);
    EXPECT_NEAR(
        student_factor(2, coverage) / (coverage * std::sqrt(2.0 / (1.0 - coverage * coverage))),
        1.0, 1e-9);
  }
  // For many degrees of freedom it is the normal distribution.
  EXPECT_NEAR(student_factor(1000000, 0.95), 1.959964, 1e-4);
}

// Gauss's formulas for a line: slope Sxy / Sxx, its error s / sqrt(Sxx), that of the line at x
// s sqrt(1/n + (x - mean)^2 / Sxx).
TEST(LeastSquares, ALineHasTheErrorsOfItsClosedForm) {
  const std::vector<double> x{1.0, 2.0, 3.5, 4.0, 7.0, 9.0}, y{2.1, 3.9, 7.2, 7.7, 14.4, 17.8};
  const auto count = static_cast<double>(x.size());
  double mean_x = 0.0, mean_y = 0.0, sxx = 0.0, sxy = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / count;
    mean_y += y[i] / count;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxx += (x[i] - mean_x) * (x[i] - mean_x);
    sxy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  const double slope = sxy / sxx;
  for (std::size_t i = 0; i < x.size(); ++i)
    squares += std::pow(y[i] - mean_y - slope * (x[i] - mean_x), 2);
  const double s = std::sqrt(squares / (count - 2.0));

  Eigen::MatrixXd matrix(6, 2);
  Eigen::VectorXd data(6);
  for (Eigen::Index i = 0; i < 6; ++i) {
    matrix.row(i) << 1.0, x[static_cast<std::size_t>(i)];
    data[i] = y[static_cast<std::size_t>(i)];
  }
  const Fit fit = fit_linear(matrix, data);
  ASSERT_EQ(fit.problem, "");
  EXPECT_NEAR(fit.parameters[1] / slope, 1.0, 1e-12);
  EXPECT_NEAR(fit.residual / s, 1.0, 1e-10);
  EXPECT_NEAR(fit.standard_error(1) / (s / std::sqrt(sxx)), 1.0, 1e-10);
  const double at = 12.0;
  const double error = s * std::sqrt(1.0 + 1.0 / count + (at - mean_x) * (at - mean_x) / sxx);
  Eigen::VectorXd derivatives(2);
  derivatives << 1.0, at;
  EXPECT_NEAR(fit.half_prediction(derivatives, 0.95) / (student_factor(4, 0.95) * error), 1.0,
              1e-10);
}

// Of 1000 data sets with normal scatter the 95% interval contains the true value in 950, within
// three standard deviations of such a count, 21.
TEST(LeastSquares, IntervalsHaveTheirNominalCoverage) {
  int covered = 0, predicted = 0;
  for (std::uint64_t set = 0; set < 1000; ++set) {
    Eigen::MatrixXd matrix(7, 2);
    Eigen::VectorXd data(7);
    for (Eigen::Index i = 0; i < 7; ++i) {
      const auto x = static_cast<double>(i);
      matrix.row(i) << 1.0, x;
      data[i] = 3.0 - 0.5 * x + 0.2 * normal(set, static_cast<std::uint64_t>(i));
    }
    const Fit fit = fit_linear(matrix, data);
    covered += std::abs(fit.parameters[1] + 0.5) <= fit.half_interval(1, 0.95);
    Eigen::VectorXd derivatives(2);
    derivatives << 1.0, 8.0;
    const double datum = 3.0 - 4.0 + 0.2 * normal(set, 20);
    predicted +=
        std::abs(derivatives.dot(fit.parameters) - datum) <= fit.half_prediction(derivatives, 0.95);
  }
  EXPECT_NEAR(covered, 950, 21);
  EXPECT_NEAR(predicted, 950, 21);
}

TEST(LeastSquares, ANonlinearModelReachesItsMinimum) {
  const Model decay = [](const Eigen::VectorXd& p) {
    ModelValue value{Eigen::VectorXd(8), Eigen::MatrixXd(8, 2)};
    for (Eigen::Index i = 0; i < 8; ++i) {
      const double t = 0.5 * static_cast<double>(i);
      value.values[i] = p[0] * std::exp(-p[1] * t);
      value.derivatives.row(i) << std::exp(-p[1] * t), -p[0] * t * std::exp(-p[1] * t);
    }
    return value;
  };
  Eigen::VectorXd truth(2), start(2);
  truth << 4.0, 0.7;
  start << 1.0, 3.0;
  const Fit fit = fit_model(decay, decay(truth).values, start);
  ASSERT_EQ(fit.problem, "");
  EXPECT_NEAR(fit.parameters[0], 4.0, 1e-6);
  EXPECT_NEAR(fit.parameters[1], 0.7, 1e-6);
}

TEST(LeastSquares, UndeterminedParametersAreRefused) {
  Eigen::MatrixXd same(5, 2);
  same.col(0).setOnes();
  same.col(1).setConstant(3.0);
  EXPECT_THAT(fit_linear(same, Eigen::VectorXd::Ones(5)).problem,
              testing::HasSubstr("do not determine the parameters"));
  EXPECT_THAT(fit_linear(Eigen::MatrixXd::Ones(2, 2), Eigen::VectorXd::Ones(2)).problem,
              testing::HasSubstr("2 runs are too few for 2 parameters"));
}

}  // namespace
}  // namespace kerf
