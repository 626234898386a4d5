// SPDX-License-Identifier: Apache-2.0
#include "verification/combined_rows.hpp"

#include <fmt/format.h>

#include <boost/math/statistics/linear_regression.hpp>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>

namespace kerf {

namespace {

// Returns the first row with the time and the first problem of all.
Row first_of(const std::vector<Row>& rows) {
  Row first = rows.front();
  first.seconds = 0.0;
  for (const Row& row : rows) {
    first.seconds += row.seconds;
    if (first.problem.empty()) first.problem = row.problem;
  }
  return first;
}

std::vector<double> measured_in(const std::vector<Row>& rows) {
  std::vector<double> measured;
  for (const Row& row : rows) measured.push_back(row.measured);
  return measured;
}

}  // namespace

Row mean_of(const std::vector<Row>& rows) {
  Row mean = first_of(rows);
  const std::vector<double> measured = measured_in(rows);
  mean.measured = boost::math::statistics::mean(measured);
  mean.run = fmt::format("mean of {} runs", rows.size());
  if (rows.size() > 1)
    mean.run += fmt::format(", standard deviation {:.2g}{}",
                            std::sqrt(boost::math::statistics::sample_variance(measured)),
                            mean.unit == "1" ? "" : " " + mean.unit);
  return mean;
}

Row exponent_of(const std::vector<Row>& rows, const std::vector<double>& over) {
  Row exponent = first_of(rows);
  std::vector<double> x, y;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    x.push_back(std::log(over[k]));
    y.push_back(std::log(rows[k].measured));
  }
  exponent.measured = boost::math::statistics::simple_ordinary_least_squares(x, y).second;
  exponent.unit = std::string("1");
  exponent.run = fmt::format("exponent over {} runs", rows.size());
  return exponent;
}

}  // namespace kerf
