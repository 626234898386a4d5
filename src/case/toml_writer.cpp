// SPDX-License-Identifier: Apache-2.0
#include "case/toml_writer.hpp"

#include <fmt/format.h>

#include <cmath>

#include "case/schema.hpp"
#include "case/units.hpp"

namespace kerf {

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += fmt::format("\\{}", c);
    else if (static_cast<unsigned char>(c) < ' ' || c == 127)
      result += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    else
      result += c;
  }
  return result + "\"";
}

void TomlWriter::open(const std::string& heading, std::string section) {
  text_ += heading.empty() ? "" : "\n" + heading + "\n";
  section_ = std::move(section);
}

void TomlWriter::raw(std::string_view name, const std::string& value) {
  text_ += fmt::format("{} = {}\n", name, value);
}

void TomlWriter::numbers(std::string_view name, const std::vector<double>& values) {
  std::vector<std::string> entries;
  for (const double value : values) entries.push_back(number_text(name, value));
  raw(name, fmt::format("[{}]", fmt::join(entries, ", ")));
}

void TomlWriter::vector(std::string_view name, const Point& point) {
  numbers(name, std::vector<double>(point.begin(), point.begin() + static_cast<long>(dimension_)));
}

void TomlWriter::expressions(std::string_view name, const std::array<std::string, 3>& formulas) {
  std::vector<std::string> entries;
  for (std::size_t a = 0; a < dimension_; ++a) entries.push_back(quoted(formulas[a]));
  raw(name, fmt::format("[{}]", fmt::join(entries, ", ")));
}

void TomlWriter::faces(std::string_view name, const Faces& faces) {
  static constexpr const char* axes[] = {"x", "y", "z"};
  std::vector<std::string> entries;
  for (std::size_t a = 0; a < 3; ++a) {
    if (faces.minimum[a]) entries.push_back(fmt::format("\"{}-\"", axes[a]));
    if (faces.maximum[a]) entries.push_back(fmt::format("\"{}+\"", axes[a]));
  }
  raw(name, fmt::format("[{}]", fmt::join(entries, ", ")));
}

std::string TomlWriter::number_text(std::string_view name, double value) const {
  const std::string unit(find_key(section_, name, {})->unit);
  if (std::isinf(value)) return quoted("none");
  return unit.empty() ? shortest(value) : quoted(write_quantity(value, unit));
}

namespace {

class ShapeText {
 public:
  explicit ShapeText(int dimension) : dimension_(static_cast<std::size_t>(dimension)) {}

  std::string of(const Shape& shape) const {
    const std::string type = names[static_cast<std::size_t>(shape.kind)];
    return fmt::format("{{ type = \"{}\", {} }}", type, members(shape));
  }

 private:
  static constexpr const char* names[] = {"box",    "disc",  "ring",       "polygon",
                                          "sphere", "union", "difference", "mesh"};

  static std::string length(double value) { return quoted(write_quantity(value, "m")); }

  std::string vector(const Point& point, bool lengths) const {
    std::vector<std::string> entries;
    for (std::size_t a = 0; a < dimension_; ++a)
      entries.push_back(lengths ? length(point[a]) : shortest(point[a]));
    return fmt::format("[{}]", fmt::join(entries, ", "));
  }

  std::string members(const Shape& shape) const {
    switch (shape.kind) {
      case Shape::Kind::box:
        return fmt::format("minimum = {}, maximum = {}", vector(shape.box.minimum, true),
                           vector(shape.box.maximum, true));
      case Shape::Kind::disc:
      case Shape::Kind::ring:
      case Shape::Kind::sphere:
        return round(shape);
      case Shape::Kind::polygon:
        return polygon(shape);
      case Shape::Kind::mesh:
        return mesh(shape.mesh);
      case Shape::Kind::join:
      case Shape::Kind::difference:
        break;
    }
    std::vector<std::string> parts;
    for (const Shape& part : shape.parts) parts.push_back(of(part));
    return fmt::format("parts = [{}]", fmt::join(parts, ", "));
  }

  std::string round(const Shape& shape) const {
    std::string text =
        fmt::format("centre = {}, radius = {}", vector(shape.centre, true), length(shape.radius));
    if (shape.kind == Shape::Kind::ring)
      text += fmt::format(", inner_radius = {}", length(shape.inner_radius));
    if (dimension_ == 3 && shape.kind != Shape::Kind::sphere)
      text +=
          fmt::format(", axis = {}, length = {}", vector(shape.axis, false), length(shape.length));
    return text;
  }

  std::string polygon(const Shape& shape) const {
    std::vector<std::string> corners;
    for (const auto& vertex : shape.vertices)
      corners.push_back(fmt::format("[{}, {}]", length(vertex[0]), length(vertex[1])));
    std::string text = fmt::format("vertices = [{}]", fmt::join(corners, ", "));
    if (dimension_ == 3)
      text += fmt::format(", depth_minimum = {}, depth_maximum = {}", length(shape.depth_minimum),
                          length(shape.depth_maximum));
    return text;
  }

  // Under the name of the copy that lies in the result folder.
  std::string mesh(const MeshShape& mesh) const {
    std::vector<std::string> angles;
    for (const double angle : mesh.rotation) angles.push_back(quoted(write_quantity(angle, "rad")));
    return fmt::format("file = {}, checksum = {}, scale = {}, position = {}, rotation = [{}]",
                       quoted(kept_mesh_name(mesh)), quoted(mesh.checksum), length(mesh.scale),
                       vector(mesh.position, true), fmt::join(angles, ", "));
  }

  std::size_t dimension_;
};

}  // namespace

std::string shape_text(const Shape& shape, int dimension) {
  return ShapeText(dimension).of(shape);
}

}  // namespace kerf
