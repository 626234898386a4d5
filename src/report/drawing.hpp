// SPDX-License-Identifier: Apache-2.0
// This header collects the elements of a vector drawing, an <svg> element of a page. Curves, maps
// and the cross-section of the kerf are drawn with it. Lengths are pixels, y grows downwards.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "report/palette.hpp"

namespace kerf {

// Where a text stands relative to its point.
enum class Anchor { left, middle, right };

class Drawing {
 public:
  // `label` describes the drawing for screen readers.
  Drawing(double width, double height, std::string_view label);

  // Adds an element as it is written.
  void add(std::string_view element);
  // Adds a straight line or a path without a fill; `style` holds further attributes.
  void line(double x0, double y0, double x1, double y1, std::string_view style);
  void path(std::string_view commands, std::string_view style);
  // Adds a text, whose characters are already safe in a page; `y` is the base line.
  void text(double x, double y, std::string_view words, Anchor anchor, std::string_view style = {});

  std::string svg() const { return text_ + "</svg>\n"; }

 private:
  std::string text_;
};

// Returns the attributes of a line: stroke="#22272e" stroke-width="2". `dashes` as in SVG.
std::string stroke(Colour colour, double width, std::string_view dashes = {});

// Returns a distance of 1, 2 or 5 times a power of ten that divides `length` into about `parts`.
double round_interval(double length, double parts);
// Returns the multiples of `interval` from `low` to `high`.
std::vector<double> round_ticks(double low, double high, double interval);

}  // namespace kerf
