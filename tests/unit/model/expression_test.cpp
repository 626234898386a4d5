// SPDX-License-Identifier: Apache-2.0
#include "model/expression.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"

namespace kerf {
namespace {

TEST(Expression, Evaluates) {
  const Expression wave("0.1*sin(pi*x/0.2) + y^2 - z", {"x", "y", "z"});
  const double expected = 0.1 * std::sin(std::numbers::pi * 0.07 / 0.2) + 9.0 - 0.25;
  EXPECT_NEAR(wave({0.07, 3.0, 0.25}), expected, 1e-14 * expected);
  EXPECT_EQ(Expression("r < 0.5 ? 2 : 1", {"r"}).evaluate(0.25), 2.0);
  EXPECT_EQ(Expression("r < 0.5 ? 2 : 1", {"r"}).evaluate(0.75), 1.0);
  EXPECT_EQ(Expression("-5", {"x", "y", "z"})({1.0, 2.0, 3.0}), -5.0);
}

TEST(Expression, NumbersKeepAllTheirDigits) {
  for (const double value : {0.1, -1.0 / 3.0, 1e-300, 6.02214076e23, 5e-05})
    EXPECT_EQ(Expression(fmt::format("0+ t*0 + ({:.17g})", value), {"t"}).evaluate(1.0), value);
}

TEST(Expression, CopiesAreIndependent) {
  const Expression first("2*t", {"t"});
  Expression second("t", {"t"});
  second = first;
  EXPECT_EQ(second.evaluate(4.0), 8.0);
  EXPECT_EQ(first.evaluate(1.0), 2.0);
  EXPECT_EQ(second.evaluate(5.0), 10.0);
}

TEST(Expression, RefusesUnknownNames) {
  for (const char* text :
       {"u", "sine(t)", "t +", "(t", "", "t = 1", "1, 2", "\"t\"", "t; 1", "=", "t == "})
    EXPECT_THROW(Expression(text, {"t"}), UserError) << text;
  EXPECT_THROW(Expression(std::string(600, '1'), {"t"}), UserError);
  EXPECT_THROW(Expression(fmt::format("{:(>100}t{:)>100}", "", ""), {"t"}), UserError);
  EXPECT_NO_THROW(Expression("t == 1 ? 2 : t >= 3", {"t"}));
}

}  // namespace
}  // namespace kerf
