// SPDX-License-Identifier: Apache-2.0
// This header wraps a bitmap of cairo, on which pictures of particles are drawn. Lengths are
// pixels, y grows downwards.
#pragma once

#include <cairo.h>

#include <memory>
#include <string>
#include <string_view>

#include "report/drawing.hpp"

namespace kerf {

template <auto destroy>
struct CairoDelete {
  template <class T>
  void operator()(T* object) const {
    destroy(object);
  }
};
using CairoSurface = std::unique_ptr<cairo_surface_t, CairoDelete<cairo_surface_destroy>>;
using CairoContext = std::unique_ptr<cairo_t, CairoDelete<cairo_destroy>>;
using CairoPattern = std::unique_ptr<cairo_pattern_t, CairoDelete<cairo_pattern_destroy>>;

struct Rectangle {
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};

struct TextStyle {
  double size = 18.0;
  Colour colour = palette::ink;
  Anchor anchor = Anchor::left;
  bool bold = false;
};

class Canvas {
 public:
  // `scale` is the number of bitmap pixels per pixel of the drawing.
  Canvas(int width, int height, double scale = 1.0);

  cairo_t* context() const { return context_.get(); }
  void set_colour(Colour colour) const;
  void line(double x0, double y0, double x1, double y1) const;
  void rectangle(const Rectangle& area) const;  // outline
  void disc(double x, double y, double radius) const;
  // Draws a text; `y` is its base line.
  void text(double x, double y, std::string_view words, const TextStyle& style) const;
  double text_width(std::string_view words, const TextStyle& style) const;
  // While a clip exists, nothing is drawn outside its area.
  class Clip {
   public:
    Clip(const Canvas& canvas, const Rectangle& area);
    ~Clip();
    Clip(const Clip&) = delete;
    Clip& operator=(const Clip&) = delete;

   private:
    cairo_t* context_;
  };

  // Returns the bytes of a PNG file. Throws std::runtime_error when cairo is out of memory.
  std::string png() const;

 private:
  CairoSurface surface_;
  CairoContext context_;
};

}  // namespace kerf
