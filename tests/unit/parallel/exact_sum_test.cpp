// SPDX-License-Identifier: Apache-2.0
// Exact sums equal those of whole numbers of any length, rounded to the nearest double, in every
// order and division.
#include "parallel/exact_sum.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace kerf {
namespace {

using Whole = boost::multiprecision::cpp_int;

// The number in units of 2^-1074, the least double.
Whole in_least_doubles(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const auto digits = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  const int shift = exponent - 53 + 1074;
  return shift >= 0 ? Whole(Whole(digits) << shift) : Whole(digits >> -shift);
}

// Whether no double is nearer to the sum, and of two that are as near x is the even one.
void expect_nearest(double x, const Whole& sum) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Whole error = abs(in_least_doubles(x) - sum);
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof x);
  for (const double towards : {-infinity, infinity}) {
    const Whole other = abs(in_least_doubles(std::nextafter(x, towards)) - sum);
    EXPECT_LE(error, other) << x;
    if (error == other) {
      EXPECT_EQ(bits % 2, 0u) << x;
    }
  }
}

// Numbers of both signs over many powers of ten, some of which nearly cancel.
std::vector<double> signed_numbers(unsigned seed, double least, double most) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> sign(-1.0, 1.0), power(least, most);
  std::vector<double> result;
  for (int n = 0; n < 3000; ++n) {
    result.push_back(sign(engine) * std::pow(10.0, power(engine)));
    if (n % 3 == 0) result.push_back(-result[result.size() / 2] * (1.0 + 1e-15));
  }
  return result;
}

double sum_of(const std::vector<double>& values) {
  ExactSum sum;
  for (const double x : values) sum.add(x);
  return sum.value();
}

TEST(ExactSum, IsTheNearestNumberToTheSum) {
  unsigned seed = 0;
  for (const double most : {1.0, 8.0, 150.0, 300.0})
    for (const double least : {-300.0, -8.0, 0.0}) {
      const auto values = signed_numbers(++seed, least, most);
      Whole exact = 0;
      for (const double x : values) exact += in_least_doubles(x);
      expect_nearest(sum_of(values), exact);
    }
}

TEST(ExactSum, RoundsHalvesToEven) {
  const double half = std::ldexp(1.0, -53), least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(sum_of({1.0, half}), 1.0);
  EXPECT_EQ(sum_of({1.0 + 2.0 * half, half}), 1.0 + 4.0 * half);
  EXPECT_EQ(sum_of({1.0, half, least}), 1.0 + 2.0 * half);
  EXPECT_EQ(sum_of({-1.0, -half, -least}), -1.0 - 2.0 * half);
  EXPECT_EQ(sum_of({-1.0, -half, least}), -1.0);
}

TEST(ExactSum, OfTheLeastAndTheLargestNumbers) {
  constexpr double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(sum_of({}), 0.0);
  EXPECT_EQ(sum_of({least, least, least}), 3.0 * least);
  EXPECT_EQ(sum_of({most, most, least, -most, -most}), least);
  EXPECT_EQ(sum_of({-most, least, most, -2.0 * least}), -least);
  EXPECT_EQ(sum_of({most, most}), std::numeric_limits<double>::infinity());
}

TEST(ExactSum, ANumberThatIsNotFiniteIsNotLost) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double x : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(std::isnan(sum_of({1.0, x, 2.0})));
    ExactSum part, whole;
    part.add(x);
    whole.add(part);
    EXPECT_TRUE(std::isnan(whole.value()));
    EXPECT_TRUE(std::isnan(ExactSum::of(whole.parts()).value()));
    whole.clear();
    whole.add(1.0);
    EXPECT_EQ(whole.value(), 1.0);
  }
}

// Two million numbers carry more than once.
TEST(ExactSum, OfManyNumbers) {
  ExactSum sum;
  for (int n = 0; n < 1000000; ++n) {
    sum.add(0.1);
    sum.add(1.0 - std::ldexp(1.0, -53));
  }
  const Whole exact =
      1000000 * (in_least_doubles(0.1) + in_least_doubles(1.0 - std::ldexp(1.0, -53)));
  expect_nearest(sum.value(), exact);
}

TEST(ExactSum, OrderAndDivisionDoNotMatter) {
  std::mt19937_64 engine(7);
  auto values = signed_numbers(99, -12.0, 9.0);
  const double once = sum_of(values);
  for (const std::size_t parts : {1u, 2u, 3u, 8u, 64u}) {
    std::shuffle(values.begin(), values.end(), engine);
    std::vector<ExactSum> part(parts);
    for (const double x : values) part[engine() % parts].add(x);
    ExactSum joined;
    for (const ExactSum& each : part) joined.add(each);
    EXPECT_EQ(joined.value(), once);
    // As messages between ranks, whose words are added.
    ExactSum::Parts all{};
    for (ExactSum& each : part) {
      const auto words = each.parts();
      for (std::size_t k = 0; k < words.size(); ++k) all[k] += words[k];
    }
    EXPECT_EQ(ExactSum::of(all).value(), once);
  }
}

TEST(ExactSum, IsEmptyAfterClear) {
  ExactSum sum;
  for (const double x : signed_numbers(3, -300.0, 300.0)) sum.add(x);
  sum.clear();
  sum.add(-2.5);
  EXPECT_EQ(sum.value(), -2.5);
}

}  // namespace
}  // namespace kerf
