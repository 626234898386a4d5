// SPDX-License-Identifier: Apache-2.0
#include "model/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <numbers>

#include "core/error.hpp"

namespace kerf {

namespace {

constexpr std::size_t longest_expression = 500;
constexpr int deepest_brackets = 30;

void refuse(const std::string& text, const std::string& what) {
  throw UserError(fmt::format("the expression \"{}\" cannot be used: {}", text, what));
}

bool ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

// muParser also accepts assignments, strings and lists of values; Kerf refuses them.
void check_characters(const std::string& text) {
  if (text.size() > longest_expression)
    throw UserError(fmt::format("the expression is longer than {} characters", longest_expression));
  if (!ascii(text)) throw UserError("the expression has characters other than ASCII");
  if (text.find_first_of("\"'") != std::string::npos) refuse(text, "quotes are not allowed");
  int depth = 0, deepest = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') deepest = std::max(deepest, ++depth);
    if (text[i] == ')') --depth;
    if (text[i] != '=') continue;
    const bool comparison = (i > 0 && std::string("=<>!").find(text[i - 1]) != std::string::npos) ||
                            (i + 1 < text.size() && text[i + 1] == '=');
    if (!comparison) refuse(text, "'=' assigns; to compare, write '=='");
  }
  if (deepest > deepest_brackets) refuse(text, "its brackets are nested too deeply");
}

std::string listed(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

struct Expression::Implementation {
  std::string text;
  std::vector<std::string> variables;
  std::array<double, 3> values{};
  mu::Parser parser;

  Implementation(const std::string& formula, const std::vector<std::string>& names)
      : text(formula), variables(names) {
    require(names.size() <= values.size(), "an expression has more than three variables");
    check_characters(text);
    try {
      parser.DefineConst("pi", std::numbers::pi);
      for (std::size_t i = 0; i < variables.size(); ++i) parser.DefineVar(variables[i], &values[i]);
      parser.SetExpr(text);
      parser.Eval();
    } catch (const mu::Parser::exception_type& error) {
      explain(error);
    }
    if (parser.GetNumResults() != 1) refuse(text, "it has more than one value");
  }

  [[noreturn]] void explain(const mu::Parser::exception_type& error) const {
    std::string message = error.GetMsg();
    while (!message.empty() && (message.back() == '.' || message.back() == ' ')) message.pop_back();
    throw UserError(fmt::format(
        "the expression \"{}\" cannot be used: {}; it may use {} and pi, + - * / ^, "
        "comparisons, \"a ? b : c\" and functions such as sin, cos, tan, exp, ln, sqrt, abs, min, "
        "max",
        text, message, listed(variables)));
  }
};

Expression::Expression(const std::string& text, const std::vector<std::string>& variables)
    : implementation_(std::make_unique<Implementation>(text, variables)) {}

Expression::Expression(const Expression& other)
    : Expression(other.implementation_->text, other.implementation_->variables) {}

Expression& Expression::operator=(const Expression& other) {
  if (this != &other) *this = Expression(other);
  return *this;
}

Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;

double Expression::operator()(const std::array<double, 3>& values) const {
  implementation_->values = values;
  return implementation_->parser.Eval();
}

}  // namespace kerf
