// SPDX-License-Identifier: Apache-2.0
#include "case/write_used.hpp"

#include <fmt/format.h>

#include <cmath>

#include "case/material_library.hpp"
#include "case/schema.hpp"
#include "case/units.hpp"

namespace kerf {

namespace {

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

// Writes the keys of one table; units come from the schema.
class Writer {
 public:
  explicit Writer(int dimension) : dimension_(static_cast<std::size_t>(dimension)) {}

  void open(const std::string& heading, std::string section) {
    text_ += heading.empty() ? "" : "\n" + heading + "\n";
    section_ = std::move(section);
  }
  void raw(std::string_view name, const std::string& value) {
    text_ += fmt::format("{} = {}\n", name, value);
  }
  void text(std::string_view name, std::string_view value) { raw(name, quoted(value)); }
  void number(std::string_view name, double value) { raw(name, number_text(name, value)); }
  void numbers(std::string_view name, const std::vector<double>& values) {
    std::vector<std::string> entries;
    for (const double value : values) entries.push_back(number_text(name, value));
    raw(name, fmt::format("[{}]", fmt::join(entries, ", ")));
  }
  void vector(std::string_view name, const Point& point) {
    numbers(name,
            std::vector<double>(point.begin(), point.begin() + static_cast<long>(dimension_)));
  }
  void expressions(std::string_view name, const std::array<std::string, 3>& formulas) {
    std::vector<std::string> entries;
    for (std::size_t a = 0; a < dimension_; ++a) entries.push_back(quoted(formulas[a]));
    raw(name, fmt::format("[{}]", fmt::join(entries, ", ")));
  }
  void faces(std::string_view name, const Faces& faces) {
    static constexpr const char* axes[] = {"x", "y", "z"};
    std::vector<std::string> entries;
    for (std::size_t a = 0; a < 3; ++a) {
      if (faces.minimum[a]) entries.push_back(fmt::format("\"{}-\"", axes[a]));
      if (faces.maximum[a]) entries.push_back(fmt::format("\"{}+\"", axes[a]));
    }
    raw(name, fmt::format("[{}]", fmt::join(entries, ", ")));
  }
  // A number as the key of that name wants it: plain, or a text with its unit.
  std::string number_text(std::string_view name, double value) const {
    const std::string unit(find_key(section_, name, {})->unit);
    if (std::isinf(value)) return quoted("none");
    return unit.empty() ? shortest(value) : quoted(write_quantity(value, unit));
  }
  const std::string& result() const { return text_; }

 private:
  std::size_t dimension_;
  std::string section_;
  std::string text_;
};

// One inline table: TOML keeps those on one line, parts and all.
class ShapeText {
 public:
  explicit ShapeText(int dimension) : dimension_(static_cast<std::size_t>(dimension)) {}

  std::string of(const Shape& shape) const {
    const std::string type = names[static_cast<std::size_t>(shape.kind)];
    return fmt::format("{{ type = \"{}\", {} }}", type, members(shape));
  }

 private:
  static constexpr const char* names[] = {"box",    "disc",  "ring",      "polygon",
                                          "sphere", "union", "difference"};

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

  std::size_t dimension_;
};

void write_top(Writer& writer, const Case& description) {
  writer.open("", "");
  writer.text("title", description.title);
  writer.raw("dimension", std::to_string(description.dimension));
  writer.text("formulation", formulation_name(description.formulation));
  writer.text("precision", description.precision == PrecisionKind::mixed ? "mixed" : "double");
  writer.number("smoothing_ratio", description.smoothing_ratio);
  writer.vector("gravity", description.gravity);
  writer.open("[time]", "time");
  writer.number("end", description.time.end);
  writer.number("courant", description.time.courant);
  writer.number("maximum_step", description.time.maximum_step);
  writer.open("[domain]", "domain");
  writer.vector("minimum", description.domain.minimum);
  writer.vector("maximum", description.domain.maximum);
  if (description.symmetry.any()) writer.faces("symmetry", description.symmetry);
}

void write_material(Writer& writer, Formulation formulation, const Material& material) {
  writer.open(fmt::format("[materials.{}]", material.name), "materials");
  writer.text("kind", kind_name(material.kind));
  if (material.kind == MaterialKind::elastic && formulation == Formulation::standard) {
    writer.text("elasticity", word_of(material.elasticity, elastic_law_words));
    writer.text("plasticity", word_of(material.plasticity, plastic_law_words));
    writer.text("criterion", word_of(material.criterion, bond_criterion_words));
  }
  if (material.kind == MaterialKind::water && formulation == Formulation::standard)
    writer.text("equation_of_state", word_of(material.equation_of_state, equation_of_state_words));
  for (const MaterialField& field : material_fields(material_conditions(material, formulation)))
    writer.number(field.key, material.*field.member);
  if (material.kind == MaterialKind::water) writer.number("sound_speed", material.sound_speed);
  writer.text("source", material.source);
}

std::string grading_text(const Grading& grading, int dimension) {
  const std::string around =
      grading.around ? ", around = " + ShapeText(dimension).of(*grading.around) : "";
  return fmt::format("{{ levels = {}, width = {}{} }}", grading.levels,
                     quoted(write_quantity(grading.width, "m")), around);
}

void write_body(Writer& writer, const Case& description, const Body& body) {
  static constexpr const char* roles[] = {"elastic", "water", "rigid"};
  static constexpr const char* layers[] = {"top",   "bottom", "left", "right",
                                           "front", "back",   "all"};
  writer.open("[[body]]", "body");
  writer.text("name", body.name);
  writer.text("role", roles[static_cast<std::size_t>(body.role)]);
  if (body.role != Role::rigid)
    writer.text("material", description.materials[static_cast<std::size_t>(body.material)].name);
  writer.raw("shape", ShapeText(description.dimension).of(body.shape));
  writer.number("spacing", body.spacing);
  writer.text("lattice", body.lattice == Lattice::square ? "square" : "hexagonal");
  writer.vector("offset", body.offset);
  if (body.grading.levels > 0)
    writer.raw("grading", grading_text(body.grading, description.dimension));
  if (body.role != Role::rigid) writer.expressions("velocity_expression", body.velocity);
  if (body.role == Role::water && description.formulation == Formulation::standard)
    writer.number("pressure", body.pressure);
  if (body.role != Role::water) writer.raw("fixed", body.fixed ? "true" : "false");
  if (!body.displacement[0].empty())
    writer.expressions("displacement_expression", body.displacement);
  if (body.absorbing.any()) writer.faces("absorbing", body.absorbing);
  if (!body.joined_to.empty()) writer.text("joined_to", body.joined_to);
  if (body.role != Role::rigid && description.formulation == Formulation::standard) {
    writer.number("jitter", body.jitter);
    writer.raw("seed", std::to_string(body.seed));
  }
  if (body.role != Role::rigid) return;
  writer.text("repelling_layer", layers[static_cast<std::size_t>(body.repelling_layer)]);
  writer.number("repulsion", body.repulsion);
  if (description.formulation == Formulation::standard) writer.number("friction", body.friction);
}

void write_jet(Writer& writer, const Case& description, const Jet& jet) {
  writer.open("[[jet]]", "jet");
  writer.text("name", jet.name);
  writer.text("material", description.materials[static_cast<std::size_t>(jet.material)].name);
  writer.number("speed", jet.speed);
  writer.number(description.dimension == 2 ? "width" : "diameter", jet.width);
  writer.vector("position", jet.position);
  writer.number("standoff", jet.standoff);
  writer.number("angle", jet.angle);
  if (description.dimension == 3) writer.number("azimuth", jet.azimuth);
  writer.number("spacing", jet.spacing);
  writer.number("start", jet.start);
  writer.number("stop", jet.stop);
  writer.text("profile_expression", jet.profile);
}

void write_probe(Writer& writer, const Probe& probe) {
  writer.open("[[probe]]", "probe");
  writer.text("name", probe.name);
  writer.text("kind", probe.kind == Probe::Kind::point ? "point" : "plane");
  writer.vector("position", probe.position);
  if (probe.kind == Probe::Kind::plane) writer.vector("normal", probe.normal);
}

void write_control(Writer& writer, const Case& description) {
  if (description.eraser) {
    writer.open("[backflow_eraser]", "backflow_eraser");
    writer.number("speed_fraction", description.eraser->speed_fraction);
  }
  if (description.formulation == Formulation::shinohara2004) {
    writer.open("[artificial_stress]", "artificial_stress");
    writer.number("epsilon", description.artificial_stress.epsilon);
    writer.number("exponent", description.artificial_stress.exponent);
  }
  if (description.formulation == Formulation::standard) {
    writer.open("[numerics]", "numerics");
    writer.text("water", word_of(description.numerics.water, water_scheme_words));
    writer.raw("shifting", description.numerics.shifting ? "true" : "false");
  }
  writer.open("[output]", "output");
  writer.numbers("frame_times", description.output.frame_times);
  writer.numbers("picture_times", description.output.picture_times);
  writer.number("series_interval", description.output.series_interval);
  writer.number("checkpoint_interval", description.output.checkpoint_interval);
}

}  // namespace

std::string write_used(const Case& description) {
  Writer writer(description.dimension);
  write_top(writer, description);
  for (const Material& material : description.materials)
    write_material(writer, description.formulation, material);
  for (const Body& body : description.bodies) write_body(writer, description, body);
  for (const Jet& jet : description.jets) write_jet(writer, description, jet);
  for (const Probe& probe : description.probes) write_probe(writer, probe);
  write_control(writer, description);
  return writer.result();
}

}  // namespace kerf
