// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "geometry/point_vectors.hpp"
#include "report/picture_panels.hpp"

namespace kerf {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double turn = 28.0 * degree;  // rotation of the view about the vertical
constexpr double rise = 24.0 * degree;  // elevation of the view above the horizontal
// Discs are drawn larger than the spacing by this factor, which closes gaps of an oblique lattice.
constexpr double overlap = 1.12;

Colour mixed(Colour a, Colour b, double share) {
  return {a.red + share * (b.red - a.red), a.green + share * (b.green - a.green),
          a.blue + share * (b.blue - a.blue)};
}

// Returns a ball lit from the upper left, which is copied for every particle of its kind.
CairoSurface ball(Colour colour, int size) {
  CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, size, size));
  const CairoContext context(cairo_create(surface.get()));
  const double radius = 0.5 * (size - 2.0), centre = 0.5 * size;
  const CairoPattern shade(cairo_pattern_create_radial(
      centre - 0.35 * radius, centre - 0.4 * radius, 0.1 * radius, centre, centre, radius));
  const Colour light = mixed(colour, {1.0, 1.0, 1.0}, 0.35), dark = mixed(colour, {}, 0.35);
  cairo_pattern_add_color_stop_rgb(shade.get(), 0.0, light.red, light.green, light.blue);
  cairo_pattern_add_color_stop_rgb(shade.get(), 0.55, colour.red, colour.green, colour.blue);
  cairo_pattern_add_color_stop_rgb(shade.get(), 1.0, dark.red, dark.green, dark.blue);
  cairo_set_source(context.get(), shade.get());
  cairo_arc(context.get(), centre, centre, radius, 0.0, 2.0 * std::numbers::pi);
  cairo_fill(context.get());
  return surface;
}

class Stamps {
 public:
  void stamp(const Canvas& canvas, double x, double y,
             const std::tuple<Category, bool, int>& kind) {
    const auto [category, upstream, size] = kind;
    CairoSurface& surface = surfaces_[kind];
    if (!surface) surface = ball(colour_of(category, upstream), size);
    cairo_set_source_surface(canvas.context(), surface.get(), std::round(x - 0.5 * size),
                             std::round(y - 0.5 * size));
    cairo_paint(canvas.context());
  }

 private:
  std::map<std::tuple<Category, bool, int>, CairoSurface> surfaces_;
};

}  // namespace

Sight oblique_sight() {
  const double s = std::sin(turn), c = std::cos(turn), v = std::sin(rise), h = std::cos(rise);
  return {{c, 0.0, -s}, {-s * v, h, -c * v}, {s * h, v, c * h}};
}

Box extent_of(const Box& window, const Sight& sight) {
  constexpr double far = 1e300;
  Box extent{{far, far, far}, {-far, -far, -far}};
  for (int corner = 0; corner < 8; ++corner) {
    Point point;
    for (int k = 0; k < 3; ++k) point[k] = (corner >> k & 1 ? window.maximum : window.minimum)[k];
    const Point seen{dot(point, sight.right), dot(point, sight.up), dot(point, sight.towards)};
    for (int k = 0; k < 3; ++k) {
      extent.minimum[k] = std::min(extent.minimum[k], seen[k]);
      extent.maximum[k] = std::max(extent.maximum[k], seen[k]);
    }
  }
  return extent;
}

void draw_oblique(const Canvas& canvas, const Map& map, const Frame& frame, double cut) {
  const Canvas::Clip clip(canvas, map.area);
  const Sight sight = oblique_sight();
  std::vector<std::pair<double, std::size_t>> order;  // ordered by the distance towards the viewer
  for (std::size_t i = 0; i < frame.position.size(); ++i)
    if (frame.position[i][2] <= cut) order.emplace_back(dot(frame.position[i], sight.towards), i);
  std::sort(order.begin(), order.end());
  Stamps stamps;
  for (const auto& [depth, i] : order) {
    const int size =
        std::max(3, static_cast<int>(std::lround(frame.spacing[i] * map.scale * overlap)) + 2);
    stamps.stamp(canvas, map.x(dot(frame.position[i], sight.right)),
                 map.y(dot(frame.position[i], sight.up)),
                 {frame.category[i], frame.upstream[i] != 0, size});
  }
}

}  // namespace kerf
