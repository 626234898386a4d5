// SPDX-License-Identifier: Apache-2.0
// A formula of a case file, such as "0.1*sin(pi*x/0.2)", ready to be evaluated (by muParser).
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace kerf {

// The variable of expressions in time.
inline constexpr std::array<std::string_view, 1> time_variable{"t"};

// Arguments are SI numbers. Only one thread may use an object at a time; copies are independent.
class Expression {
 public:
  // Throws a UserError that states the error in the text and its position: an unknown variable
  // or function, a syntax error, an assignment, more than one value.
  Expression(const std::string& text, const std::vector<std::string>& variables);
  Expression(const Expression& other);
  Expression& operator=(const Expression& other);
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;
  ~Expression();

  // Returns the value of the expression with its variables set to the first of `values`.
  double operator()(const std::array<double, 3>& values) const;
  // Returns the value of the expression with its first variable set to `value`.
  double evaluate(double value) const { return (*this)({value, 0.0, 0.0}); }

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace kerf
