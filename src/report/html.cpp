// SPDX-License-Identifier: Apache-2.0
#include "report/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cmath>
#include <numbers>

#include "output/readable.hpp"
#include "report/plot.hpp"
#include "report/style.hpp"
#include "report/viewer_files.hpp"

namespace kerf::html {

std::string escape(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

namespace {

// Rounds to significant digits: 999.96 becomes 1000 with four of them, which has another prefix.
double rounded(double value, int digits) {
  return std::stod(fmt::format("{:.{}e}", value, digits - 1));
}

// Returns whether the first symbol of a unit has a power, which would apply to a prefix too:
// 1 mm² is 1e-6 m².
bool begins_with_power(const std::string& unit) {
  const auto end = std::find_if(unit.begin(), unit.end(), [](char c) {
    return !(c >= 'a' && c <= 'z') && !(c >= 'A' && c <= 'Z');
  });
  const std::string_view rest(unit.data() + (end - unit.begin()),
                              static_cast<std::size_t>(unit.end() - end));
  return rest.starts_with("²") || rest.starts_with("³") || rest.starts_with('^') ||
         (!rest.empty() && rest[0] >= '0' && rest[0] <= '9');
}

}  // namespace

std::string number(double value, int digits) {
  if (!std::isfinite(value)) return "—";
  if (value == 0.0) return "0";
  const double size = std::abs(rounded(value, digits));
  if (size >= 1e-3 && size < 1e5) {
    const std::string text = fmt::format("{:.{}g}", value, digits);
    return text.find('e') == std::string::npos ? text : fmt::format("{:.0f}", value);
  }
  const int power = static_cast<int>(std::floor(std::log10(size)));
  return fmt::format("{:.3g} · 10<sup>{}</sup>", value / std::pow(10.0, power), power);
}

std::string quantity(double value, const std::string& unit, int digits) {
  if (!std::isfinite(value)) return "—";
  const std::string space = "\u202f";  // narrow space without a line break
  if (unit == "s" && value >= 60.0 && value < 1e9) {
    std::string text = duration_text(value);
    for (const char* name : {"h", "min", "s", "days", "years"})
      boost::replace_all(text, std::string(" ") + name, space + name);
    return text;
  }
  // Kilograms have a prefix already; rounding errors are shown as a power of ten.
  const bool plain = unit.starts_with("kg") || begins_with_power(unit) || std::abs(value) < 1e-9 ||
                     std::abs(value) >= 1e15;
  if (plain) return number(value, digits) + space + unit;
  const Prefix prefix = prefix_for(std::abs(rounded(value, digits)));
  return number(value * prefix.factor, digits) + space + prefix.symbol + unit;
}

std::string flow_rate(double value, int dimension) {
  return quantity(6e4 * value, flow_rate_unit(dimension));
}

std::string degrees(double angle) {
  return number(angle * 180.0 / std::numbers::pi, 3) + "°";
}

std::string percent(double share) {
  return number(100.0 * share, 3) + "\u202f%";
}

std::string count(double value) {
  constexpr double most_digits = 1e12;
  if (!(std::abs(value) < most_digits)) return number(value, 3);
  std::string digits = fmt::format("{:.0f}", value);
  for (std::ptrdiff_t at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), "\u202f");
  return digits;
}

std::string base64(std::string_view bytes) {
  using namespace boost::archive::iterators;
  using Encode = base64_from_binary<transform_width<const char*, 6, 8>>;
  std::string text(Encode(bytes.data()), Encode(bytes.data() + bytes.size()));
  text.append((3 - bytes.size() % 3) % 3, '=');
  return text;
}

std::string png_address(std::string_view png) {
  return "data:image/png;base64," + base64(png);
}

std::string section(const std::string& id, const std::string& fallback) {
  return fmt::format("<section id=\"{}\">\n{}</section>\n", id, fallback);
}

std::string data_script(const std::string& id, std::string json) {
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; ++at)
    json.replace(at, 1, "\\u003c");
  return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id, json);
}

std::string swatch(Colour colour, bool dashed) {
  return fmt::format("<i class=\"swatch\" style=\"border-top:3px {} {}\"></i>",
                     dashed ? "dotted" : "solid", hex(colour));
}

std::string key_mark(const std::string& key) {
  return key.empty() ? "" : fmt::format(" data-key=\"{}\"", key);
}

std::string table(const std::string& caption, const std::vector<Row>& rows) {
  const bool remarks =
      std::any_of(rows.begin(), rows.end(), [](const Row& row) { return !row.remark.empty(); });
  std::string text = fmt::format("<table><caption>{}</caption><tbody>\n", caption);
  for (const Row& row : rows) {
    text += fmt::format("<tr><th scope=\"row\">{}</th><td{}>{}</td>", row.name, key_mark(row.key),
                        row.value);
    if (remarks) text += fmt::format("<td class=\"remark\">{}</td>", row.remark);
    text += "</tr>\n";
  }
  return text + "</tbody></table>\n";
}

std::string page(const std::string& title, const std::string& body, std::string_view sheet) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}{}</style>\n</head>\n<body>\n<main>\n{}</main>\n</body>\n</"
      "html>\n",
      escape(title), style, viewer_text(sheet), body);
}

}  // namespace kerf::html
