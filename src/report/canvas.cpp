// SPDX-License-Identifier: Apache-2.0
#include "report/canvas.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace kerf {
namespace {

cairo_status_t add_bytes(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void choose_font(cairo_t* context, const TextStyle& style) {
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, style.size);
}

}  // namespace

Canvas::Canvas(int width, int height, double scale)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                          static_cast<int>(std::ceil(scale * width)),
                                          static_cast<int>(std::ceil(scale * height)))),
      context_(cairo_create(surface_.get())) {
  cairo_scale(context(), scale, scale);
  set_colour(palette::paper);
  cairo_paint(context());
}

void Canvas::set_colour(Colour colour) const {
  cairo_set_source_rgb(context(), colour.red, colour.green, colour.blue);
}

void Canvas::line(double x0, double y0, double x1, double y1) const {
  cairo_move_to(context(), x0, y0);
  cairo_line_to(context(), x1, y1);
  cairo_stroke(context());
}

void Canvas::rectangle(const Rectangle& area) const {
  cairo_rectangle(context(), area.x, area.y, area.width, area.height);
  cairo_stroke(context());
}

void Canvas::disc(double x, double y, double radius) const {
  cairo_arc(context(), x, y, radius, 0.0, 2.0 * std::numbers::pi);
  cairo_fill(context());
}

double Canvas::text_width(std::string_view words, const TextStyle& style) const {
  choose_font(context(), style);
  cairo_text_extents_t extents;
  cairo_text_extents(context(), std::string(words).c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(double x, double y, std::string_view words, const TextStyle& style) const {
  const double width = text_width(words, style);
  const double shift = style.anchor == Anchor::left     ? 0.0
                       : style.anchor == Anchor::middle ? 0.5 * width
                                                        : width;
  set_colour(style.colour);
  cairo_move_to(context(), x - shift, y);
  cairo_show_text(context(), std::string(words).c_str());
}

Canvas::Clip::Clip(const Canvas& canvas, const Rectangle& area) : context_(canvas.context()) {
  cairo_save(context_);
  cairo_rectangle(context_, area.x, area.y, area.width, area.height);
  cairo_clip(context_);
}

Canvas::Clip::~Clip() {
  cairo_restore(context_);
}

std::string Canvas::png() const {
  std::string bytes;
  const cairo_status_t status =
      cairo_surface_write_to_png_stream(surface_.get(), add_bytes, &bytes);
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("cannot draw a picture: ") +
                             cairo_status_to_string(status));
  return bytes;
}

}  // namespace kerf
