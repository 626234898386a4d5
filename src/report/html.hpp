// SPDX-License-Identifier: Apache-2.0
// This header declares the elements of HTML that reports and studies are composed of.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/palette.hpp"

namespace kerf::html {

// Returns the text with the characters replaced that have a meaning in HTML.
std::string escape(std::string_view text);

// Returns "22.4 ms": the number with that many significant digits and a suitable prefix; "—" for
// not a number. Units that begin with a power, as m²/s, get no prefix.
std::string quantity(double value, const std::string& unit, int digits = 4);
// Returns a flow rate of water, given in m³/s (2D: m²/s), in the unit of flow_rate_unit().
std::string flow_rate(double value, int dimension);
// The unit of flow rates; 60 000 of it are one SI unit.
constexpr const char* flow_rate_unit(int dimension) {
  return dimension == 2 ? "L/min/m" : "L/min";
}
// Returns a plain number, for ratios.
std::string number(double value, int digits = 4);
std::string degrees(double angle);  // "15°", given in rad
std::string percent(double share);  // "4.2 %", given as a share of 1
std::string count(double value);    // "1 234 567"

// Returns bytes as text, RFC 4648.
std::string base64(std::string_view bytes);
// Returns the image itself as the address of an <img>.
std::string png_address(std::string_view png);

// Returns a section of the page. The script replaces its content, which is shown without the script
// and in print.
std::string section(const std::string& id, const std::string& fallback);

// Returns JSON as a script element of that id. "<" is escaped, so that no text in it can end the
// element or begin a comment or a script, which the parser of HTML looks for.
std::string data_script(const std::string& id, std::string json);

// Returns a short line in the colour of a curve, for a legend.
std::string swatch(Colour colour, bool dashed);

struct Row {
  std::string name;
  std::string value;
  std::string remark;
  std::string key = {};  // path in result.json if the value is one of its numbers
};
// Returns the attribute that names the key.
std::string key_mark(const std::string& key);
// Returns a table. The cells are HTML; the column of remarks exists if a row has one.
std::string table(const std::string& caption, const std::vector<Row>& rows);

// Returns a complete page, which loads no other files. `sheet` names the style sheet of its script
// in viewer_files.hpp.
std::string page(const std::string& title, const std::string& body,
                 std::string_view sheet = "style");

}  // namespace kerf::html
