// SPDX-License-Identifier: Apache-2.0
#include "verification/table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/version.hpp"

namespace kerf {

namespace {

std::string verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::fail:
      return "FAIL";
    case Verdict::reported:
      return "reported";
    case Verdict::coarse:
      return "coarser";
  }
  return "";
}

std::string number(double value) {
  return std::isnan(value) ? "none" : fmt::format("{:.4g}", value);
}

std::string expected(const Row& row) {
  if (row.reference && row.scatter)
    return fmt::format("{} ± {}", number(*row.reference), number(*row.scatter));
  if (row.reference) return number(*row.reference);
  if (row.at_least && row.at_most)
    return fmt::format("{} to {}", number(*row.at_least), number(*row.at_most));
  if (row.at_least) return fmt::format(">= {}", number(*row.at_least));
  if (row.at_most) return fmt::format("<= {}", number(*row.at_most));
  return "-";
}

std::string percent(const std::optional<double>& value, const char* format) {
  if (!value || std::isnan(*value)) return "-";
  return fmt::format(fmt::runtime(format), 100.0 * *value);
}

std::string unit_of(const Row& row) {
  return row.unit == "1" ? "" : row.unit;
}

bool is_as_written(const std::string& placement) {
  return placement.empty() || placement == Placement{}.text();
}

// Returns the name of the run of a row, with its placement if that is not as written.
std::string run_of(const Row& row) {
  return is_as_written(row.placement) ? row.run : fmt::format("{} ({})", row.run, row.placement);
}

// Returns where a row holds: "written", "elsewhere", both, or "nowhere"; "-" if it is not judged.
std::string places_of(const Row& row) {
  if (row.verdict == Verdict::reported || row.verdict == Verdict::coarse) return "-";
  std::string places;
  for (const std::string& placement : row.holds_in)
    places += fmt::format("{}{}", places.empty() ? "" : ", ",
                          is_as_written(placement) ? "written" : "elsewhere");
  return places.empty() ? "nowhere" : places;
}

constexpr auto layout = "{:<12} {:<34} {:<13} {:>9} {:>13} {:<7} {:>8} {:>6}  {:<8} {:>6}\n";

constexpr std::string_view theory_head =
    "| quantity | run | measured | reference | error | within | verdict | holds | s |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";

std::string theory_line(const Row& row) {
  return fmt::format("| {} | {} | {} {}{} | {} | {} | {} | {} | {} | {:.0f} |\n", row.quantity,
                     row.run, number(row.measured), unit_of(row),
                     is_as_written(row.placement) ? "" : " (elsewhere)", expected(row),
                     percent(row.error, "{:+.2f}%"), percent(row.tolerance, "{:.3g}%"),
                     verdict_name(row.verdict), places_of(row), row.seconds);
}

// Returns the value of Kerf, with its range where it has one.
std::string value_with_range(const Row& row) {
  if (!row.low || !row.high) return number(row.measured);
  return fmt::format("{} ({} to {})", number(row.measured), number(*row.low), number(*row.high));
}

constexpr std::string_view experiment_head =
    "| quantity | run | measured | Kerf | error | within | | verdict | s |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";

std::string experiment_line(const Row& row) {
  const std::string unit = row.unit == "1" ? "" : " " + row.unit;
  const bool has_measurement = row.reference || row.at_least || row.at_most;
  return fmt::format("| {} | {} | {}{} | {}{} | {} | {} | {} | {} | {:.0f} |\n", row.quantity,
                     row.run, expected(row), has_measurement ? unit : "", value_with_range(row),
                     unit, percent(row.error, "{:+.0f}%"), percent(row.tolerance, "{:.3g}%"),
                     row.is_calibrated ? "calibrated" : "predicted", verdict_name(row.verdict),
                     row.seconds);
}

nlohmann::json optional_json(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return *value;
}

}  // namespace

std::string table_head() {
  return fmt::format(fmt::runtime(layout), "case", "quantity", "run", "measured", "reference",
                     "unit", "error", "within", "verdict", "s");
}

std::string table_row(const Row& row) {
  std::string line = fmt::format(fmt::runtime(layout), row.case_name, row.quantity, run_of(row),
                                 number(row.measured), expected(row), unit_of(row),
                                 percent(row.error, "{:+.2f}%"), percent(row.tolerance, "{:.3g}%"),
                                 verdict_name(row.verdict), fmt::format("{:.1f}", row.seconds));
  if (!row.problem.empty()) line += fmt::format("    {}\n", row.problem);
  return line;
}

std::string to_json(const std::vector<Row>& rows) {
  nlohmann::json result;
  result["program"] = std::string("kerf ") + program_version;
  result["passed"] = !has_failed(rows);
  result["rows"] = nlohmann::json::array();
  for (const Row& row : rows)
    result["rows"].push_back({{"case", row.case_name},
                              {"placement", row.placement},
                              {"quantity", row.quantity},
                              {"run", row.run},
                              {"unit", row.unit},
                              {"measured", optional_json(row.measured)},
                              {"reference", optional_json(row.reference)},
                              {"relative_error", optional_json(row.error)},
                              {"tolerance", optional_json(row.tolerance)},
                              {"scatter", optional_json(row.scatter)},
                              {"low", optional_json(row.low)},
                              {"high", optional_json(row.high)},
                              {"calibrated", row.is_calibrated},
                              {"at_least", optional_json(row.at_least)},
                              {"at_most", optional_json(row.at_most)},
                              {"verdict", verdict_name(row.verdict)},
                              {"holds_in", row.holds_in},
                              {"problem", row.problem},
                              {"source", row.source},
                              {"seconds", row.seconds}});
  return result.dump(2) + "\n";
}

std::string to_markdown(const VerificationCase& verification, const Findings& findings,
                        TableKind kind, const std::string& figures) {
  std::string table, sources, last;
  for (const Row& row : findings.rows) {
    if (row.case_name != verification.name) continue;
    table += kind == TableKind::theory ? theory_line(row) : experiment_line(row);
    if (row.quantity != last) sources += fmt::format("- {}: {}\n", row.quantity, row.source);
    last = row.quantity;
  }
  if (table.empty()) return "";
  const auto there = findings.elsewhere.find(verification.name);
  const std::string elsewhere =
      there == findings.elsewhere.end() ? "" : fmt::format("Elsewhere: {}.\n\n", there->second);
  return fmt::format("### `{}`\n{}\n\n{}{}{}\n{}\n{}", verification.name, verification.title,
                     elsewhere, kind == TableKind::theory ? theory_head : experiment_head, table,
                     sources, figures);
}

}  // namespace kerf
