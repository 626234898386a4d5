// SPDX-License-Identifier: Apache-2.0
#include "report/picture_panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr double label_size = 19.0;  // px
constexpr double tick_length = 7.0;  // px

// Drawn in this order, so that thin water stays visible on what it wets.
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

double first_tick(double from, double interval) {
  return std::ceil(from / interval - 1e-9) * interval;
}

std::string millimetres(double metres) {
  const double value = std::round(metres * 1e9) / 1e6;
  return fmt::format("{:g}", value == 0.0 ? 0.0 : value);  // no "-0"
}

}  // namespace

double round_interval(double length, double parts) {
  const double rough = length / parts;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (rough <= factor * power) return factor * power;
  return 10.0 * power;
}

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
  for (double x = first_tick(map.left, interval); x <= map.left + width * (1.0 + 1e-9);
       x += interval) {
    canvas.set_colour(palette::faint);
    canvas.line(map.x(x), area.y + area.height, map.x(x), area.y + area.height + tick_length);
    canvas.text(map.x(x), area.y + area.height + tick_length + label_size, millimetres(x),
                {label_size, palette::ink, Anchor::middle});
  }
  canvas.text(area.x - tick_length - 5.0, area.y - 8.0, "mm",
              {label_size, palette::faint, Anchor::right});
  for (double y = first_tick(map.bottom, interval); y <= map.bottom + height * (1.0 + 1e-9);
       y += interval) {
    canvas.set_colour(palette::faint);
    canvas.line(area.x - tick_length, map.y(y), area.x, map.y(y));
    canvas.text(area.x - tick_length - 5.0, map.y(y) + 0.36 * label_size, millimetres(y),
                {label_size, palette::ink, Anchor::right});
  }
}

}  // namespace kerf
