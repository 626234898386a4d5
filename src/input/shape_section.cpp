// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "input/draft.hpp"
#include "input/sections.hpp"
#include "input/toml_writer.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {
constexpr double farthest = 1e6;  // m, of a vertex
}

std::vector<Key> shape_keys() {
  using namespace key_range;
  using enum ValueKind;
  // clang-format off
  return {
      {"type", word, "", "", any, shape_words, "", "Kind of shape; in 3D a disc is a cylinder, a ring a tube, a polygon an extrusion", stored_in<&Shape::kind>},
      {"minimum", vector, "m", "", within(1e6), {}, "box", "Lowest corner", stored_in<&Shape::box, &Box::minimum>},
      {"maximum", vector, "m", "", within(1e6), {}, "box", "Highest corner", stored_in<&Shape::box, &Box::maximum>},
      {"centre", vector, "m", "", within(1e6), {}, "disc ring sphere", "Centre; that of the first end for a cylinder or tube", stored_in<&Shape::centre>},
      {"radius", quantity, "m", "", up_to(1e6), {}, "disc ring sphere", "Radius; the outer one for a ring", stored_in<&Shape::radius>},
      {"inner_radius", quantity, "m", "", up_to(1e6), {}, "ring", "Inner radius", stored_in<&Shape::inner_radius>},
      {"axis", vector, "", "(0, 0, 1)", any, {}, "disc+3D ring+3D", "Direction of the axis, of any length", stored_in<&Shape::axis>},
      {"length", quantity, "m", "", up_to(1e6), {}, "disc+3D ring+3D", "Length along the axis", stored_in<&Shape::length>},
      {"vertices", vertices, "m", "", within(farthest), {}, "polygon", "Corners (x, y) in order, in either direction; the last is joined to the first", stored_in<&Shape::vertices>},
      {"depth_minimum", quantity, "m", "", within(1e6), {}, "polygon+3D", "Lowest z of the extrusion", stored_in<&Shape::depth_minimum>},
      {"depth_maximum", quantity, "m", "", within(1e6), {}, "polygon+3D", "Highest z of the extrusion", stored_in<&Shape::depth_maximum>},
      {"parts", tables, "", "", any, {}, "union difference", "Shapes; a union has the points of any of them, a difference those of the first and of no other"},
      {"file", text, "", "", any, {}, "mesh", "File of a closed surface of triangles, STL or OBJ; its path is relative to the folder of the case file", stored_in<&Shape::mesh, &MeshShape::file>},
      {"scale", quantity, "m", "1 mm", up_to(1e6), {}, "mesh", "Length of one unit of the file: STL has no units", stored_in<&Shape::mesh, &MeshShape::scale>},
      {"position", vector, "m", "0 m", within(1e6), {}, "mesh", "Position of the origin of the file", stored_in<&Shape::mesh, &MeshShape::position>},
      {"rotation", vector, "rad", "0 rad", within(1e3), {}, "mesh", "Rotation angles of the part about x, then y, then z, before its translation; [\"-90 deg\", \"0 deg\", \"0 deg\"] makes the z axis of a drawing vertical", stored_in<&Shape::mesh, &MeshShape::rotation>},
      {"checksum", text, "", "(no check)", any, {}, "mesh", "Checksum of the bytes of the file, as in case.used.toml: a changed file is refused", stored_in<&Shape::mesh, &MeshShape::checksum>},
  };
  // clang-format on
}

namespace {

constexpr std::size_t most_vertices = 100000;

void check_round(Section& section, Shape& shape) {
  const Point& axis = shape.axis;
  if (shape.kind == Shape::Kind::sphere && section.reading().dimension == 2)
    section.refuse("type", "a sphere needs a 3D case", "Use a disc", "\"disc\" in 2D");
  if (std::hypot(axis[0], axis[1], axis[2]) == 0.0)
    section.refuse("axis", "the axis has no direction", "Write for example [0, 0, 1]",
                   "any vector but zero");
  else
    shape.axis = unit_vector(axis);
  if (shape.kind != Shape::Kind::ring) return;
  if (shape.inner_radius >= shape.radius && shape.radius > 0.0)
    section.refuse("inner_radius", "the ring has no thickness", "Make it smaller than the radius",
                   "less than the radius");
}

using Vertex = std::array<double, 2>;
using Edge = std::array<Vertex, 2>;

// Returns twice the area of the triangle of an edge and a point, with its sign.
double area_with(const Edge& edge, const Vertex& point) {
  const auto& [a, b] = edge;
  return (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]);
}

// Returns the point in which two edges cross, other than at their ends.
std::optional<Vertex> crossing(const Edge& first, const Edge& second) {
  const double a = area_with(first, second[0]), b = area_with(first, second[1]);
  if (!(a * b < 0.0) || !(area_with(second, first[0]) * area_with(second, first[1]) < 0.0))
    return {};
  const double share = a / (a - b);
  return Vertex{second[0][0] + share * (second[1][0] - second[0][0]),
                second[0][1] + share * (second[1][1] - second[0][1])};
}

// Says where the outline crosses itself; empty if it does not, or has very many corners.
std::string crossing_text(const Shape& shape) {
  constexpr std::size_t most_compared = 10000;
  const std::size_t n = shape.vertices.size();
  const auto edge = [&](std::size_t i) {
    return Edge{shape.vertices[i], shape.vertices[(i + 1) % n]};
  };
  if (n > most_compared) return {};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j)
      if (const auto place = crossing(edge(i), edge(j)))
        return fmt::format(
            "the outline crosses itself at ({:.6g} m, {:.6g} m), where the edge from corner {} to "
            "{} "
            "meets that from corner {} to {}",
            (*place)[0], (*place)[1], i + 1, i + 2, j + 1, (j + 1) % n + 1);
  return {};
}

// Checks that the outline is a simple polygon with an area, by Boost.Geometry.
void check_outline(Section& section, const Shape& shape) {
  namespace geometry = boost::geometry;
  using Corner = geometry::model::d2::point_xy<double>;
  geometry::model::polygon<Corner> polygon;
  for (const auto& vertex : shape.vertices) polygon.outer().emplace_back(vertex[0], vertex[1]);
  geometry::correct(polygon);
  std::string reason;
  if (geometry::is_valid(polygon, reason)) return;
  const std::string crosses = crossing_text(shape);
  section.refuse(
      "vertices",
      crosses.empty() ? fmt::format("the outline is not a simple polygon: {}", reason) : crosses,
      "Put the corners in order around the outline", "corners whose edges do not cross or touch");
}

// Farther corners are refused by the range of the key, and would overflow the tests of the outline.
bool is_within_range(const Shape& shape) {
  return std::all_of(shape.vertices.begin(), shape.vertices.end(), [](const auto& vertex) {
    return std::abs(vertex[0]) <= farthest && std::abs(vertex[1]) <= farthest;
  });
}

void check_polygon(Section& section, const Shape& shape) {
  if (section.has("vertices")) {
    if (shape.vertices.size() < 3 || shape.vertices.size() > most_vertices)
      section.refuse("vertices", fmt::format("there are {} corners", shape.vertices.size()),
                     "Give the corners in order", fmt::format("3 to {} corners", most_vertices));
    else if (is_within_range(shape))
      check_outline(section, shape);
  }
  if (section.reading().dimension == 2) return;
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

void resolve(Section& section, Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::box:
      refuse_empty_box(section, shape.box);
      break;
    case Shape::Kind::disc:
    case Shape::Kind::ring:
    case Shape::Kind::sphere:
      check_round(section, shape);
      break;
    case Shape::Kind::polygon:
      check_polygon(section, shape);
      break;
    case Shape::Kind::join:
    case Shape::Kind::difference:
      read_parts(section, shape);
      break;
    case Shape::Kind::mesh:
      read_mesh(section, shape);
      break;
  }
}

}  // namespace

Shape read_shape(Reading& reading, const toml::table& table, const std::string& path) {
  Section section(reading, table, "shape", path);
  Shape shape;
  if (!section.read_one("type", shape)) return shape;
  section.read(shape);
  resolve(section, shape);
  section.refuse_unknown();
  return shape;
}

std::string shape_text(const TomlWriter& writer, const Shape& shape) {
  WrittenKeys others;
  if (!shape.parts.empty()) {
    std::vector<std::string> parts;
    for (const Shape& part : shape.parts) parts.push_back(shape_text(writer, part));
    others["parts"] = fmt::format("[{}]", fmt::join(parts, ", "));
  }
  // The file is written with the name of its copy in the result folder.
  if (shape.kind == Shape::Kind::mesh) others["file"] = toml_string(kept_mesh_name(shape.mesh));
  return writer.inline_table("shape", shape, others);
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
