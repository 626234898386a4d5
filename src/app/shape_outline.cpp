// SPDX-License-Identifier: Apache-2.0
#include "app/shape_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/shapes.hpp"

namespace kerf {

Point SectionPlane::at(double horizontal, double vertical) const {
  Point point = through;
  point[across] = corner[across] + horizontal / scale;
  point[1] = corner[1] - vertical / scale;
  if (dimension == 2) point[2] = 0.0;
  return point;
}

namespace {

class ShapeSection {
 public:
  ShapeSection(const Shape& shape, const SectionPlane& plane) : shape_(shape), plane_(plane) {}

  // Returns nothing where there is no closed form.
  std::optional<std::string> exact() const {
    const bool is_plan = plane_.dimension == 2 || plane_.across == 0;
    const bool is_along_z = plane_.dimension == 2 ||
                            (std::abs(shape_.axis[0]) < 1e-9 && std::abs(shape_.axis[1]) < 1e-9);
    switch (shape_.kind) {
      case Shape::Kind::box:
        return meets(bounding_box(shape_, plane_.dimension)) ? rectangle() : "";
      case Shape::Kind::disc:
      case Shape::Kind::ring:
        if (!is_plan || !is_along_z) return {};
        return meets(bounding_box(shape_, plane_.dimension))
                   ? circle(shape_.radius) + circle(shape_.inner_radius)
                   : "";
      case Shape::Kind::polygon:
        if (!is_plan) return {};
        return meets(bounding_box(shape_, plane_.dimension)) ? polygon() : "";
      case Shape::Kind::sphere:
        return circle(std::sqrt(std::max(0.0, shape_.radius * shape_.radius - off() * off())));
      default:
        return {};
    }
  }

  std::string sampled() const {
    constexpr double step = 1.0;  // pixels
    const Box box = bounding_box(shape_, plane_.dimension);
    const double left = std::max(0.0, plane_.x(box.minimum)),
                 right = std::min(plane_.x(box.maximum), most),
                 top = std::max(0.0, plane_.y(box.maximum)),
                 bottom = std::min(plane_.y(box.minimum), most);
    std::string path;
    for (double y = top; y < bottom; y += step) {
      constexpr double none = -1.0;
      double begin = none;  // of the points inside
      for (double x = left; x < right + step; x += step) {
        const bool is_inside =
            x < right &&
            contains(shape_, plane_.at(x + 0.5 * step, y + 0.5 * step), plane_.dimension);
        if (is_inside && begin == none) begin = x;
        if (is_inside || begin == none) continue;
        path += fmt::format("M{:.1f} {:.1f}H{:.1f}v{}H{:.1f}z", begin, y, x, step, begin);
        begin = none;
      }
    }
    return path;
  }

 private:
  static constexpr double most = 2000.0;  // pixels, beyond every drawing

  double off() const {
    return plane_.dimension == 2 ? 0.0
                                 : plane_.through[plane_.normal()] - shape_.centre[plane_.normal()];
  }
  bool meets(const Box& box) const {
    const std::size_t n = plane_.normal();
    return plane_.dimension == 2 ||
           (box.minimum[n] <= plane_.through[n] && plane_.through[n] <= box.maximum[n]);
  }
  std::string rectangle() const {
    const Box& box = shape_.box;
    return fmt::format("M{:.2f} {:.2f}H{:.2f}V{:.2f}H{:.2f}z", plane_.x(box.minimum),
                       plane_.y(box.maximum), plane_.x(box.maximum), plane_.y(box.minimum),
                       plane_.x(box.minimum));
  }
  std::string circle(double radius) const {
    if (!(radius > 0.0)) return "";
    const double r = plane_.scale * radius;
    return fmt::format(
        "M{0:.2f} {1:.2f}a{2:.2f} {2:.2f} 0 1 0 {3:.2f} 0a{2:.2f} {2:.2f} 0 1 0 "
        "{4:.2f} 0z",
        plane_.x(shape_.centre) - r, plane_.y(shape_.centre), r, 2.0 * r, -2.0 * r);
  }
  std::string polygon() const {
    std::string path;
    for (const auto& [x, y] : shape_.vertices) {
      const Point corner{x, y, 0.0};
      path += fmt::format("{}{:.2f} {:.2f}", path.empty() ? "M" : "L", plane_.x(corner),
                          plane_.y(corner));
    }
    return path + "z";
  }

  const Shape& shape_;
  const SectionPlane& plane_;
};

}  // namespace

std::vector<SectionPart> section_of(const Shape& shape, const SectionPlane& plane) {
  std::vector<SectionPart> parts;
  if (shape.kind == Shape::Kind::join) {
    for (const Shape& part : shape.parts)
      for (SectionPart& each : section_of(part, plane)) parts.push_back(std::move(each));
    return parts;
  }
  const ShapeSection section(shape, plane);
  const std::optional<std::string> exact = section.exact();
  SectionPart part{exact ? *exact : section.sampled(), !exact.has_value()};
  if (!part.path.empty()) parts.push_back(std::move(part));
  return parts;
}

}  // namespace kerf
