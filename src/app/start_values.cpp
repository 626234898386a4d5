// SPDX-License-Identifier: Apache-2.0
#include "app/start_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

#include "app/checked_case.hpp"
#include "app/table_conditions.hpp"
#include "geometry/shapes.hpp"
#include "input/material_library.hpp"
#include "input/toml_writer.hpp"
#include "input/units.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

constexpr const char* usual_material = "tofu";
constexpr double usual_length = 10e-3;  // m, of a body, where the case tells no size
constexpr double usual_width = 1e-3;    // m, of a jet

std::string length_text(double value) {
  // A sum of rounded numbers must not be written as "-0 mm" or "2e-16 mm".
  const double in_micrometres = std::round(1e9 * value) / 1e3;
  return fmt::format("\"{:.9g} mm\"", in_micrometres == 0.0 ? 0.0 : in_micrometres / 1e3);
}

const toml::table* last_table(const toml::table& root, std::string_view list) {
  const toml::array* entries = root[list].as_array();
  return entries && !entries->empty() ? entries->back().as_table() : nullptr;
}

std::string literal_in(const toml::table& table, std::string_view name) {
  const toml::node* node = table.get(name);
  if (!node) return {};
  std::ostringstream text;
  node->visit([&](const auto& value) { text << value; });
  return text.str();
}

bool is_free(const Body& body) {
  return body.role == Role::elastic && !body.fixed && body.displacement[0].empty();
}

class Suggestion {
 public:
  Suggestion(const toml::table& root, const std::string& text, const std::string& file)
      : root_(root), case_(valid_case(text, file)) {
    dimension_ = root["dimension"].value_or(2) == 3 ? 3 : 2;
    find_bounds();
  }

  StartValues of(std::string_view section) const {
    if (section == "body") return body();
    if (section == "jet") return jet();
    if (section == "load") return load();
    if (section == "probe") return {{"position", point(aim())}};
    if (section == "materials") return {{"base", toml_string(library_material())}};
    return {};
  }

 private:
  void find_bounds();
  bool has_bodies() const { return case_ && !case_->bodies.empty(); }
  const Body* last_free() const;
  std::string point(const Point& at) const;
  std::string box(const Box& of) const;
  std::string elastic_material() const;
  std::string library_material() const;
  Point aim() const;
  Box free_box() const;
  bool has_fixed_domain() const;
  bool is_in_domain(const Box& of) const;
  double place_beside(const Jet& jet) const;
  double most_standoff(double width) const;
  StartValues body() const;
  StartValues jet() const;
  StartValues load() const;

  const toml::table& root_;
  std::optional<Case> case_;  // where it is valid
  std::size_t dimension_;
  Box bounds_;  // around all bodies
};

void Suggestion::find_bounds() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  bounds_ = {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (std::size_t n = 0; has_bodies() && n < case_->bodies.size(); ++n) {
    const Box one = bounding_box(case_->bodies[n].shape, case_->dimension);
    for (std::size_t a = 0; a < dimension_; ++a) {
      bounds_.minimum[a] = std::min(bounds_.minimum[a], one.minimum[a]);
      bounds_.maximum[a] = std::max(bounds_.maximum[a], one.maximum[a]);
    }
  }
}

const Body* Suggestion::last_free() const {
  const Body* last = nullptr;
  for (std::size_t n = 0; case_ && n < case_->bodies.size(); ++n)
    if (is_free(case_->bodies[n])) last = &case_->bodies[n];
  return last;
}

std::string Suggestion::point(const Point& at) const {
  std::vector<std::string> entries;
  for (std::size_t a = 0; a < dimension_; ++a) entries.push_back(length_text(at[a]));
  return fmt::format("[{}]", fmt::join(entries, ", "));
}

std::string Suggestion::box(const Box& of) const {
  return fmt::format("{{ type = \"box\", minimum = {}, maximum = {} }}", point(of.minimum),
                     point(of.maximum));
}

std::string Suggestion::elastic_material() const {
  if (const Body* body = last_free())
    return case_->materials[static_cast<std::size_t>(body->material)].name;
  return usual_material;
}

// Returns the material of the library that the material of the last body is or comes from.
std::string Suggestion::library_material() const {
  const std::string name = elastic_material();
  if (find_library_material(name)) return name;
  const toml::table* own = root_["materials"][name].as_table();
  const std::string base = own ? word_in(*own, "base") : "";
  return find_library_material(base) ? base : usual_material;
}

// Returns where a jet of the case meets the workpiece, or the middle of the upper face of the
// bodies.
Point Suggestion::aim() const {
  if (case_ && !case_->jets.empty()) return case_->jets.back().position;
  Point middle{};
  if (has_bodies())
    for (std::size_t a = 0; a < dimension_; ++a)
      middle[a] = a == 1 ? bounds_.maximum[a] : 0.5 * (bounds_.minimum[a] + bounds_.maximum[a]);
  return middle;
}

// Returns whether the domain stays as it is where a body is added.
bool Suggestion::has_fixed_domain() const {
  return case_ && (root_.contains("domain") || root_.contains("workpiece"));
}

bool Suggestion::is_in_domain(const Box& of) const {
  if (!has_fixed_domain()) return true;
  for (std::size_t a = 0; a < dimension_; ++a)
    if (of.minimum[a] < case_->domain.minimum[a] || of.maximum[a] > case_->domain.maximum[a])
      return false;
  return true;
}

// Returns a box beside all bodies and as large as the last one, or smaller where the domain leaves
// less room: below them, to the right, to the left or above.
Box Suggestion::free_box() const {
  if (!has_bodies()) {
    const double half = 0.5 * usual_length;
    return {{-half, -usual_length, -half}, {half, 0.0, half}};
  }
  constexpr std::array<std::pair<std::size_t, int>, 3> sides{{{1, -1}, {0, 1}, {0, -1}}};
  const Box last = bounding_box(case_->bodies.back().shape, case_->dimension);
  const auto beside = [&](std::size_t axis, int way, double share) {
    Box free = last;
    const double size = share * (last.maximum[axis] - last.minimum[axis]);
    free.minimum[axis] = way > 0 ? bounds_.maximum[axis] : bounds_.minimum[axis] - size;
    free.maximum[axis] = free.minimum[axis] + size;
    return free;
  };
  constexpr std::array shares{1.0, 0.5, 0.25, 0.12, 0.06};
  for (const double share : shares)
    for (const auto& [axis, way] : sides)
      if (const Box free = beside(axis, way, share); is_in_domain(free)) return free;
  for (const double share : shares)  // above, where nozzles may be
    if (const Box free = beside(1, 1, share); is_in_domain(free)) return free;
  return beside(1, -1, 1.0);
}

StartValues Suggestion::body() const {
  StartValues values{{"material", toml_string(elastic_material())}, {"shape", box(free_box())}};
  const toml::table* last = last_table(root_, "body");
  std::string spacing = last ? literal_in(*last, "spacing") : "";
  const bool has_jet = root_.contains("jet") || root_.contains("machine");
  if (spacing.empty() && !has_jet) spacing = length_text(usual_length / 20.0);
  if (!spacing.empty()) values["spacing"] = spacing;
  return values;
}

// Returns a place beside the last jet, x of where it is aimed at, that still meets the bodies.
double Suggestion::place_beside(const Jet& jet) const {
  for (const double widths : {4.0, -4.0, 2.0, -2.0}) {
    const double place = jet.position[0] + widths * jet.width;
    const bool is_above_body = place > bounds_.minimum[0] && place < bounds_.maximum[0];
    if (!has_bodies() || is_above_body) return place;
  }
  return jet.position[0] + 2.0 * jet.width;
}

// Returns a standoff of two widths, or less where the domain ends above the bodies.
double Suggestion::most_standoff(double width) const {
  const double wanted = 2.0 * width;
  if (!has_bodies() || !has_fixed_domain()) return wanted;
  const double room = case_->domain.maximum[1] - bounds_.maximum[1];
  return room > 0.0 ? std::min(wanted, 0.5 * room) : wanted;
}

// Returns another jet like the last one beside it, one beside that of the machine where it does not
// go, or one above the middle of the bodies.
StartValues Suggestion::jet() const {
  StartValues values;
  Point position = aim();
  if (const toml::table* last = last_table(root_, "jet")) {
    for (const auto& [key, node] : *last)
      if (!node.is_table()) values[std::string(key.str())] = literal_in(*last, key.str());
    if (case_) position[0] = place_beside(case_->jets.back());
  } else {
    double width = has_bodies() ? 0.1 * (bounds_.maximum[0] - bounds_.minimum[0]) : usual_width;
    if (case_ && !case_->jets.empty()) {  // that of the machine, whose nozzle may travel
      const Jet& machine = case_->jets.back();
      width = machine.width;
      position[0] += machine.traverse[0] > 0.0 ? -2.0 * width : 2.0 * width;
    }
    values["speed"] = "\"10 m/s\"";
    values[dimension_ == 3 ? "diameter" : "width"] = length_text(width);
    values["standoff"] = length_text(most_standoff(width));
  }
  values["position"] = point(position);
  return values;
}

// Returns a pressure on the upper face of the last elastic body.
StartValues Suggestion::load() const {
  const Body* body = last_free();
  if (!body) return {{"kind", "\"body_force\""}};
  Box face = bounding_box(body->shape, case_->dimension);
  const double beside = body->spacing;
  for (std::size_t a = 0; a < dimension_; ++a) {
    face.minimum[a] = a == 1 ? face.maximum[a] - 0.25 * beside : face.minimum[a] - beside;
    face.maximum[a] += a == 1 ? 0.25 * beside : beside;
  }
  return {{"kind", "\"pressure\""},
          {"body", toml_string(body->name)},
          {"pressure", "\"1 kPa\""},
          {"shape", box(face)}};
}

}  // namespace

StartValues start_values(std::string_view section, const toml::table& root, const std::string& text,
                         const std::string& file) {
  return Suggestion(root, text, file).of(section);
}

}  // namespace kerf
