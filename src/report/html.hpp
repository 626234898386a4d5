// SPDX-License-Identifier: Apache-2.0
// Small pieces of HTML.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/palette.hpp"

namespace kerf::html {

// Text made safe to stand in a page or in an attribute.
std::string escape(std::string_view text);

// "22.4 ms": the significant digits asked for and a prefix that suits the number; "—" for not a
// number. Units that begin with a power, as m²/s, get no prefix.
std::string quantity(double value, const std::string& unit, int digits = 4);
// Of water, from m³/s (2D: m²/s).
std::string flow_rate(double value, int dimension);
// 60 000 of it are one SI unit.
constexpr const char* flow_rate_unit(int dimension) {
  return dimension == 2 ? "L/min/m" : "L/min";
}
// As plain number, for counts and ratios.
std::string number(double value, int digits = 4);
std::string degrees(double angle);  // "15°", from rad
std::string percent(double share);  // "4.2 %", of 1
std::string count(double value);    // 1 234 567

// The image itself as the address of an <img>.
std::string png_address(std::string_view png);

// A part of the page that the viewer takes over; until then, and on paper, the fallback stands.
std::string section(const std::string& id, const std::string& fallback);

// JSON as a script element of that id: "</" in it, which could end the element, is escaped.
std::string data_script(const std::string& id, std::string json);

// The key to a curve.
std::string swatch(Colour colour, bool dashed);

struct Row {
  std::string name;
  std::string value;
  std::string remark;
  std::string key = {};  // of result.json, where the value is one of its numbers: "kerf.depth"
};
// The attribute that names the key.
std::string key_mark(const std::string& key);
// Cells are taken as they are (already safe); a remark column appears when any row has one.
std::string table(const std::string& caption, const std::vector<Row>& rows);

// A whole page: nothing is loaded from anywhere. `sheet` names the style of what moves in it, of
// viewer_files.hpp.
std::string page(const std::string& title, const std::string& body,
                 std::string_view sheet = "style");

}  // namespace kerf::html
