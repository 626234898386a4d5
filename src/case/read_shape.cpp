// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <limits>

#include "case/draft.hpp"

namespace kerf {

namespace {

constexpr std::size_t most_vertices = 100000;

void read_corners(Section& section, Shape& shape) {
  shape.box.minimum = section.vector("minimum");
  shape.box.maximum = section.vector("maximum");
  for (int a = 0; a < section.reading().dimension; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    if (shape.box.minimum[axis] < shape.box.maximum[axis]) continue;
    section.refuse("maximum",
                   fmt::format("entry {} is not greater than that of the minimum", a + 1),
                   "Swap the corners or correct one", "beyond the minimum along each axis");
    return;
  }
}

void read_axis(Section& section, Shape& shape) {
  if (section.reading().dimension == 2) return;
  const Point axis = section.vector("axis", Point{0.0, 0.0, 1.0});
  if (std::hypot(axis[0], axis[1], axis[2]) == 0.0)
    section.refuse("axis", "the axis has no direction", "Write for example [0, 0, 1]",
                   "any vector but zero");
  else
    shape.axis = unit_vector(axis);
  shape.length = section.number("length");
}

void read_round(Section& section, Shape& shape) {
  shape.centre = section.vector("centre");
  shape.radius = section.number("radius");
  if (shape.kind == Shape::Kind::sphere) {
    if (section.reading().dimension == 2)
      section.refuse("type", "a sphere needs a 3D case", "Use a disc", "\"disc\" in 2D");
    return;
  }
  read_axis(section, shape);
  if (shape.kind != Shape::Kind::ring) return;
  shape.inner_radius = section.number("inner_radius");
  if (shape.inner_radius >= shape.radius && shape.radius > 0.0)
    section.refuse("inner_radius", "the ring has no thickness", "Make it smaller than the radius",
                   "less than the radius");
}

// Whether the outline is a simple polygon of some area, by Boost.Geometry.
void check_outline(Section& section, const Shape& shape) {
  namespace geometry = boost::geometry;
  using Corner = geometry::model::d2::point_xy<double>;
  geometry::model::polygon<Corner> polygon;
  for (const auto& vertex : shape.vertices) polygon.outer().emplace_back(vertex[0], vertex[1]);
  geometry::correct(polygon);
  std::string reason;
  if (geometry::is_valid(polygon, reason)) return;
  section.refuse("vertices", fmt::format("the outline is not a simple polygon: {}", reason),
                 "Put the corners in order around the outline",
                 "corners whose edges do not cross or touch");
}

void read_polygon(Section& section, Shape& shape) {
  shape.vertices = section.vertices("vertices");
  if (section.has("vertices")) {
    if (shape.vertices.size() < 3 || shape.vertices.size() > most_vertices)
      section.refuse("vertices", fmt::format("there are {} corners", shape.vertices.size()),
                     "Give the corners in order", fmt::format("3 to {} corners", most_vertices));
    else
      check_outline(section, shape);
  }
  if (section.reading().dimension == 2) return;
  shape.depth_minimum = section.number("depth_minimum");
  shape.depth_maximum = section.number("depth_maximum");
  if (shape.depth_maximum <= shape.depth_minimum && section.has("depth_maximum"))
    section.refuse("depth_maximum", "the extrusion has no depth", "Swap the two or correct one",
                   "greater than depth_minimum");
}

void read_parts(Section& section, Shape& shape) {
  const auto parts = section.tables("parts");
  if (section.has("parts") && parts.size() < 2)
    section.refuse("parts", fmt::format("there are {} shapes", parts.size()),
                   "Give the shape itself where there is one only", "at least two shapes");
  for (std::size_t i = 0; i < parts.size(); ++i)
    shape.parts.push_back(
        read_shape(section.reading(), *parts[i], indexed(section.path("parts"), i)));
}

struct KindName {
  const char* word;
  Shape::Kind kind;
};
constexpr KindName kind_names[] = {{"box", Shape::Kind::box},
                                   {"disc", Shape::Kind::disc},
                                   {"ring", Shape::Kind::ring},
                                   {"polygon", Shape::Kind::polygon},
                                   {"sphere", Shape::Kind::sphere},
                                   {"union", Shape::Kind::join},
                                   {"difference", Shape::Kind::difference},
                                   {"mesh", Shape::Kind::mesh}};

}  // namespace

Shape read_shape(Reading& reading, const toml::table& table, const std::string& path) {
  Section section(reading, table, "shape", path);
  Shape shape;
  const std::string type = section.text("type");
  const auto* known = std::find_if(std::begin(kind_names), std::end(kind_names),
                                   [&](const KindName& entry) { return type == entry.word; });
  if (known == std::end(kind_names)) return shape;
  shape.kind = known->kind;
  section.assume(type);
  switch (shape.kind) {
    case Shape::Kind::box:
      read_corners(section, shape);
      break;
    case Shape::Kind::disc:
    case Shape::Kind::ring:
    case Shape::Kind::sphere:
      read_round(section, shape);
      break;
    case Shape::Kind::polygon:
      read_polygon(section, shape);
      break;
    case Shape::Kind::join:
    case Shape::Kind::difference:
      read_parts(section, shape);
      break;
    case Shape::Kind::mesh:
      read_mesh(section, shape);
      break;
  }
  section.refuse_unknown();
  return shape;
}

Point unit_vector(const Point& vector) {
  const double length = std::hypot(vector[0], vector[1], vector[2]);
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  if (std::abs(length - 1.0) <= rounding) return vector;
  return {vector[0] / length, vector[1] / length, vector[2] / length};
}

std::string indexed(std::string_view list, std::size_t index) {
  return fmt::format("{}[{}]", list, index + 1);
}

}  // namespace kerf
