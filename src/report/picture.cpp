// SPDX-License-Identifier: Apache-2.0
#include "report/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/jet_direction.hpp"
#include "geometry/shapes.hpp"
#include "machine/travelling_frame.hpp"
#include "model/case.hpp"
#include "output/files.hpp"
#include "report/picture_panels.hpp"

namespace kerf {

namespace {

constexpr double margin_share = 0.08;  // margin around bodies and jets over the larger extent
constexpr double panel_width = 1200.0, panel_height = 900.0;  // px, largest size of a panel
constexpr double left_space = 84.0, right_space = 28.0, top_space = 64.0, bottom_space = 92.0;
constexpr double least_width = 620.0;  // px, for heading and legend
constexpr double gap = 84.0;           // px, between two panels

void include(Box& window, const Point& point, double radius) {
  for (std::size_t k = 0; k < 3; ++k) {
    window.minimum[k] = std::min(window.minimum[k], point[k] - radius);
    window.maximum[k] = std::max(window.maximum[k], point[k] + radius);
  }
}

Point nozzle_of(const Jet& jet) {
  const Point direction = jet_direction(jet);
  Point nozzle = jet.position;
  for (std::size_t k = 0; k < 3; ++k) nozzle[k] -= jet.standoff * direction[k];
  return nozzle;
}

Map map_of(double left, double right, double bottom, double top) {
  const double scale = std::min(panel_width / (right - left), panel_height / (top - bottom));
  return {
      {left_space, top_space, scale * (right - left), scale * (top - bottom)}, scale, left, bottom};
}

struct LegendEntry {
  const char* name;
  Colour colour;
};

// Returns the legend, which is the same for every frame of a case.
std::vector<LegendEntry> legend_of(const Case& description) {
  const auto any_body = [&](Role role) {
    return std::any_of(description.bodies.begin(), description.bodies.end(),
                       [role](const Body& body) { return body.role == role; });
  };
  const bool breaks =
      std::any_of(description.bodies.begin(), description.bodies.end(), [&](const Body& body) {
        return body.role == Role::elastic &&
               description.materials.at(static_cast<std::size_t>(body.material)).can_break();
      });
  std::vector<LegendEntry> entries;
  if (!description.jets.empty() || any_body(Role::water))
    entries.push_back({"water", palette::water});
  if (any_body(Role::elastic)) entries.push_back({"solid", palette::solid});
  if (breaks) entries.push_back({"fractured", palette::fractured});
  if (any_body(Role::rigid)) entries.push_back({"rigid", palette::plate});
  return entries;
}

void draw_legend(const Canvas& canvas, const Case& description, double x, double y) {
  constexpr double size = 19.0;
  for (const LegendEntry& entry : legend_of(description)) {
    canvas.set_colour(entry.colour);
    canvas.disc(x + 8.0, y - 0.36 * size, 8.0);
    canvas.text(x + 23.0, y, entry.name, {size});
    x += 23.0 + canvas.text_width(entry.name, {size}) + 28.0;
  }
}

// Draws a bar of known length below the panel, which ends at `right`.
void draw_scale_bar(const Canvas& canvas, const Map& map, double right, double y) {
  const double length = round_interval(map.area.width / map.scale, 7.0);
  const double left = right - length * map.scale;
  canvas.set_colour(palette::ink);
  cairo_set_line_width(canvas.context(), 3.0);
  canvas.line(left, y, right, y);
  canvas.text(left - 10.0, y + 6.0, fmt::format("{:g} mm", length * 1e3),
              {19.0, palette::ink, Anchor::right});
}

void draw_heading(const Canvas& canvas, const Frame& frame, const Case& description, double right) {
  TextStyle title{23.0, palette::ink, Anchor::left, true};
  const std::string time = fmt::format("t = {:.4g} ms", frame.time * 1e3);
  const double room = right - left_space - canvas.text_width(time, title) - 30.0;
  const auto fit = [&](double width) {
    while (title.size > 14.0 && canvas.text_width(description.title, title) > width)
      title.size -= 1.0;
    return canvas.text_width(description.title, title) <= width;
  };
  // Above a narrow picture the title has a line of its own, which may begin at the margin.
  const bool on_one_line = fit(room);
  if (!on_one_line) title.size = 19.0;
  const bool is_long = !on_one_line && !fit(right - left_space);
  canvas.text(is_long ? 10.0 : left_space, on_one_line ? 40.0 : 20.0, description.title, title);
  canvas.text(right, on_one_line ? 40.0 : 46.0, time, {23.0, palette::ink, Anchor::right, true});
}

int pixels(double length) {
  return static_cast<int>(std::ceil(length));
}

std::string draw_flat(const Frame& frame, const Case& description, const Box& window,
                      double scale) {
  Map map = map_of(window.minimum[0], window.maximum[0], window.minimum[1], window.maximum[1]);
  const double width = std::max(map.area.width, least_width);
  map.area.x += 0.5 * (width - map.area.width);
  const double right = left_space + width, bottom = top_space + map.area.height;
  const Canvas canvas(pixels(right + right_space), pixels(bottom + bottom_space), scale);
  std::vector<std::size_t> shown(frame.position.size());
  std::iota(shown.begin(), shown.end(), std::size_t{0});
  draw_discs(canvas, map, frame, shown);
  draw_axes(canvas, map);
  draw_heading(canvas, frame, description, right);
  draw_legend(canvas, description, left_space, bottom + 72.0);
  draw_scale_bar(canvas, map, right, bottom + 66.0);
  return canvas.png();
}

// Returns the particles within one spacing of the plane, so that the slice has no gaps between
// layers.
std::vector<std::size_t> slice_of(const Frame& frame, double z) {
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < frame.position.size(); ++i)
    if (std::abs(frame.position[i][2] - z) <= frame.spacing[i]) shown.push_back(i);
  return shown;
}

// Returns the mirror image, which is shown where a plane of symmetry bounds the domain in front.
Frame mirrored(Frame frame, double plane) {
  for (auto& position : frame.position) position[2] = 2.0 * plane - position[2];
  return frame;
}

std::string draw_solid(const Frame& frame, const Case& description, const Box& window,
                       double scale) {
  const double z = description.jets.empty() ? 0.5 * (window.minimum[2] + window.maximum[2])
                                            : description.jets.front().position[2];
  Box half = window;
  half.maximum[2] = z;
  const bool is_half = description.symmetry.minimum[2] && z <= description.domain.minimum[2];
  if (is_half) half.minimum[2] = 2.0 * z - window.maximum[2];
  const Box seen = extent_of(half, oblique_sight());
  Map oblique = map_of(seen.minimum[0], seen.maximum[0], seen.minimum[1], seen.maximum[1]);
  Map slice = map_of(window.minimum[0], window.maximum[0], window.minimum[1], window.maximum[1]);
  const double bottom = top_space + std::max(oblique.area.height, slice.area.height);
  oblique.area.x = 0.5 * left_space;
  slice.area.x = oblique.area.x + oblique.area.width + gap;
  oblique.area.y = bottom - oblique.area.height;
  slice.area.y = bottom - slice.area.height;
  const double right = slice.area.x + slice.area.width;

  const Canvas canvas(pixels(right + right_space), pixels(bottom + bottom_space), scale);
  draw_oblique(canvas, oblique, is_half ? mirrored(frame, z) : frame, z);
  draw_discs(canvas, slice, frame, slice_of(frame, z));
  draw_axes(canvas, slice);
  draw_heading(canvas, frame, description, right);
  draw_legend(canvas, description, left_space, bottom + 72.0);
  draw_scale_bar(canvas, slice, right, bottom + 66.0);
  return canvas.png();
}

}  // namespace

Box picture_window(const Case& description) {
  constexpr double far = 1e300;
  Box window{{far, far, far}, {-far, -far, -far}};
  for (const Body& body : description.bodies) {
    const Box box = bounding_box(body.shape, description.dimension);
    include(window, box.minimum, 0.0);
    include(window, box.maximum, 0.0);
  }
  for (const Jet& jet : description.jets) {
    include(window, jet.position, 0.0);
    include(window, nozzle_of(jet), 0.5 * jet.width);
  }
  double extent = 0.0;
  for (std::size_t k = 0; k < 2; ++k)
    extent = std::max(extent, window.maximum[k] - window.minimum[k]);
  for (std::size_t k = 0; k < 3; ++k) {
    window.minimum[k] =
        std::max(window.minimum[k] - margin_share * extent, description.domain.minimum[k]);
    window.maximum[k] =
        std::min(window.maximum[k] + margin_share * extent, description.domain.maximum[k]);
  }
  return window;
}

std::string draw_picture(const Frame& frame, const Case& whole, double scale) {
  const Case description = at_time(whole, frame.time);
  const Box window = picture_window(description);
  return description.dimension == 2 ? draw_flat(frame, description, window, scale)
                                    : draw_solid(frame, description, window, scale);
}

std::string PictureWriter::file(std::size_t index) const {
  return fmt::format("pictures/{}_{:02}.png", name_, index);
}

void PictureWriter::write(const Frame& frame) {
  make_inner_folder(folder_ / "pictures");
  write_file(folder_ / file(times_.size()), draw_picture(frame, description_));
  times_.push_back(frame.time);
}

}  // namespace kerf
