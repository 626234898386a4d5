// SPDX-License-Identifier: Apache-2.0
#include "report/picture_panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr double label_size = 19.0;  // px
constexpr double tick_length = 7.0;  // px

// Returns the order of drawing, with which a film of water stays visible on a solid.
int layer_of(Category category) {
  switch (category) {
    case Category::rigid:
      return 0;
    case Category::solid:
      return 1;
    case Category::fractured:
      return 2;
    case Category::water:
      return 3;
  }
  return 4;
}

std::string millimetres(double metres) {
  const double value = std::round(metres * 1e9) / 1e6;
  return fmt::format("{:g}", value == 0.0 ? 0.0 : value);  // no "-0"
}

}  // namespace

void draw_discs(const Canvas& canvas, const Map& map, const Frame& frame,
                const std::vector<std::size_t>& shown) {
  const Canvas::Clip clip(canvas, map.area);
  std::vector<std::size_t> order = shown;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return layer_of(frame.category[a]) < layer_of(frame.category[b]);
  });
  for (const std::size_t i : order) {
    canvas.set_colour(colour_of(frame.category[i], frame.upstream[i] != 0));
    canvas.disc(map.x(frame.position[i][0]), map.y(frame.position[i][1]),
                0.5 * frame.spacing[i] * map.scale);
  }
}

void draw_axes(const Canvas& canvas, const Map& map) {
  const Rectangle& area = map.area;
  cairo_set_line_width(canvas.context(), 1.5);
  canvas.set_colour(palette::faint);
  canvas.rectangle(area);
  const double width = area.width / map.scale, height = area.height / map.scale;
  const double interval = round_interval(std::max(width, height), 8.0);
  for (const double x : round_ticks(map.left, map.left + width, interval)) {
    canvas.set_colour(palette::faint);
    canvas.line(map.x(x), area.y + area.height, map.x(x), area.y + area.height + tick_length);
    canvas.text(map.x(x), area.y + area.height + tick_length + label_size, millimetres(x),
                {label_size, palette::ink, Anchor::middle});
  }
  canvas.text(area.x - tick_length - 5.0, area.y - 8.0, "mm",
              {label_size, palette::faint, Anchor::right});
  for (const double y : round_ticks(map.bottom, map.bottom + height, interval)) {
    canvas.set_colour(palette::faint);
    canvas.line(area.x - tick_length, map.y(y), area.x, map.y(y));
    canvas.text(area.x - tick_length - 5.0, map.y(y) + 0.36 * label_size, millimetres(y),
                {label_size, palette::ink, Anchor::right});
  }
}

}  // namespace kerf
