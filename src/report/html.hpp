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
// number.
std::string quantity(double value, const std::string& unit, int digits = 4);
// As plain number, for counts and ratios.
std::string number(double value, int digits = 4);
std::string count(double value);  // 1 234 567

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
};
// Cells are taken as they are (already safe); a remark column appears when any row has one.
std::string table(const std::string& caption, const std::vector<Row>& rows);

// A whole page: nothing is loaded from anywhere. `sheet` names the style of what moves in it, of
// viewer_files.hpp.
std::string page(const std::string& title, const std::string& body,
                 std::string_view sheet = "style");

}  // namespace kerf::html
