// SPDX-License-Identifier: Apache-2.0
#include "app/case_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "app/checked_case.hpp"
#include "geometry/shapes.hpp"
#include "input/units.hpp"
#include "kernels/wendland_c2.hpp"
#include "machine/simulated_piece.hpp"
#include "model/face_names.hpp"

namespace kerf {

namespace {

constexpr double window_widths = 10.0;  // jet widths on each side of the axis
constexpr int grading_levels = 2;

std::string metres(double value) {
  return fmt::format("{:.6g} mm", 1e3 * value);
}

toml::array point(const Point& position, int dimension) {
  toml::array entries;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    entries.push_back(metres(position[a]));
  return entries;
}

std::string written_as(const toml::node& node) {
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return text.str();
}

// Adds one key of a named entry of a list to a change.
void change_entry(CaseChange& change, const std::string& list, const std::string& name,
                  const std::string& key, const toml::node& value) {
  toml::array* entries = change.changes[list].as_array();
  if (!entries) {
    change.changes.insert(list, toml::array());
    entries = change.changes[list].as_array();
  }
  toml::table* entry = nullptr;
  for (toml::node& node : *entries)
    if ((*node.as_table())["name"].value_or(std::string()) == name) entry = node.as_table();
  if (!entry) {
    entries->push_back(toml::table{{"name", name}});
    entry = entries->back().as_table();
  }
  value.visit([&](const auto& typed) { entry->insert_or_assign(key, typed); });
  change.lines.push_back(fmt::format("[[{}]] \"{}\": {} = {}", list, name, key, written_as(value)));
}

// Returns the named entry of a list of the case as written; null without one.
const toml::table* entry_of(const toml::table& written, const std::string& list,
                            const std::string& name) {
  const toml::array* entries = written[list].as_array();
  if (!entries) return nullptr;
  for (const toml::node& node : *entries) {
    const toml::table* entry = node.as_table();
    if (entry && (*entry)["name"].value_or(std::string()) == name) return entry;
  }
  return nullptr;
}

bool is_box(const Body& body) {
  return body.shape.kind == Shape::Kind::box;
}

// Returns the box around the way of a jet through the plane of its aim, `reach` wider.
Box around_jet(const Case& description, const Jet& jet, double reach) {
  Box box{jet.position, jet.position};
  const double moves = std::max(0.0, description.time.end - jet.start - jet.dwell);
  for (const std::size_t a : {std::size_t(0), std::size_t(2)}) {
    const double way = jet.traverse[a] * moves;
    box.minimum[a] += std::min(0.0, way) - reach;
    box.maximum[a] += std::max(0.0, way) + reach;
  }
  return box;
}

toml::array words(const Faces& faces) {
  toml::array list;
  for (const std::string& name : names_of(faces)) list.push_back(name);
  return list;
}

toml::table inline_table(toml::table table) {
  table.is_inline(true);
  return table;
}

// Returns whether a plane across an axis at a place has the same body on both its sides.
bool is_symmetric(const Body& body, std::size_t axis, double at, int dimension) {
  if (body.shape.kind == Shape::Kind::mesh || body.shape.kind == Shape::Kind::join ||
      body.shape.kind == Shape::Kind::difference || body.shape.kind == Shape::Kind::polygon)
    return false;
  const Box box = bounding_box(body.shape, dimension);
  const double middle = 0.5 * (box.minimum[axis] + box.maximum[axis]);
  return body.grading.levels == 0 && std::abs(middle - at) < 1e-6 * body.spacing;
}

// Sets the spacing of the workpiece, m.
void change_piece_spacing(CaseChange& change, double spacing) {
  change.changes.insert("workpiece", toml::table{{"spacing", metres(spacing)}});
  change.lines.push_back(fmt::format("[workpiece] spacing = \"{}\"", metres(spacing)));
}

}  // namespace

std::optional<CaseChange> draft_quality(const Case& description, const toml::table& written) {
  if (!description.machine || written["quality"].value_or(std::string("normal")) == "draft")
    return {};
  CaseChange change;
  change.changes.insert("quality", "draft");
  change.lines.emplace_back("quality = \"draft\"");
  return change;
}

std::optional<CaseChange> usual_end(const Case& description, const toml::table& written,
                                    const std::string& file) {
  if (!description.machine || !written["time"]["end"]) return {};
  toml::table without = written;
  without["time"].as_table()->erase("end");
  std::ostringstream text;
  text << without;
  const auto usual = valid_case(text.str(), file);
  if (!usual || !(usual->time.end < description.time.end)) return {};
  const double end = usual->time.end;
  CaseChange change;
  const std::string value = fmt::format("{:.6g} s", end);
  change.changes.insert("time", toml::table{{"end", value}});
  change.lines.push_back(fmt::format("[time] end = \"{}\"", value));
  return change;
}

std::optional<CaseChange> spacing_of_jet(const Case& description, const toml::table& written) {
  if (!description.workpiece || !written["workpiece"]["spacing"]) return {};
  const double spacing = description.jets.back().spacing;
  if (!(description.workpiece->spacing < spacing * (1.0 - 1e-9))) return {};
  CaseChange change;
  change_piece_spacing(change, spacing);
  return change;
}

std::optional<CaseChange> double_spacing(const Case& description, const toml::table& written) {
  CaseChange change;
  for (const Jet& jet : description.jets) {
    const bool is_of_machine = description.machine && &jet == &description.jets.back();
    const std::string spacing = metres(2.0 * jet.spacing);
    if (is_of_machine) {
      change.changes.insert("machine", toml::table{{"spacing", spacing}});
      change.lines.push_back(fmt::format("[machine] spacing = \"{}\"", spacing));
    } else if (const toml::table* entry = entry_of(written, "jet", jet.name);
               entry && entry->contains("spacing")) {
      change_entry(change, "jet", jet.name, "spacing", toml::value<std::string>(spacing));
    }
  }
  if (description.workpiece && written["workpiece"]["spacing"])
    change_piece_spacing(change, 2.0 * description.workpiece->spacing);
  for (const Body& body : description.bodies) {
    const toml::table* entry = entry_of(written, "body", body.name);
    if (!entry || !entry->contains("spacing")) continue;
    change_entry(change, "body", body.name, "spacing",
                 toml::value<std::string>(metres(2.0 * body.spacing)));
  }
  if (change.lines.empty()) return {};
  return change;
}

std::optional<CaseChange> smaller_piece(const Case& description) {
  if (description.jets.empty()) return {};
  const Jet& jet = description.jets.back();
  const Box window = around_jet(description, jet, window_widths * jet.width);
  CaseChange change;
  for (const Body& body : description.bodies) {
    if (body.role != Role::elastic || !is_box(body)) continue;
    Box box = body.shape.box;
    Faces absorbing = body.absorbing;
    bool is_smaller = false;
    for (std::size_t a = 0; a < static_cast<std::size_t>(description.dimension); a += 2) {
      if (window.minimum[a] > box.minimum[a]) {
        box.minimum[a] = window.minimum[a];
        absorbing.minimum[a] = is_smaller = true;
      }
      if (window.maximum[a] < box.maximum[a]) {
        box.maximum[a] = window.maximum[a];
        absorbing.maximum[a] = is_smaller = true;
      }
    }
    if (!is_smaller || box.minimum[0] >= box.maximum[0]) continue;
    change_entry(change, "body", body.name, "shape",
                 inline_table(toml::table{{"type", "box"},
                                          {"minimum", point(box.minimum, description.dimension)},
                                          {"maximum", point(box.maximum, description.dimension)}}));
    if (!body.fixed && body.displacement[0].empty())
      change_entry(change, "body", body.name, "absorbing", words(absorbing));
  }
  if (change.lines.empty()) return {};
  return change;
}

std::optional<CaseChange> smaller_depth(const Case& description) {
  if (!description.workpiece || description.machine->motion != NozzleMotion::standing) return {};
  const WorkpieceSetting& workpiece = *description.workpiece;
  const double depth = depth_of_draft(description.jets.back(), workpiece.size[1]);
  if (!(depth < workpiece.depth)) return {};
  CaseChange change;
  change.changes.insert("workpiece", toml::table{{"depth", metres(depth)}});
  change.lines.push_back(fmt::format("[workpiece] depth = \"{}\"", metres(depth)));
  return change;
}

std::optional<CaseChange> graded_spacing(const Case& description) {
  if (description.jets.empty() || description.formulation != Formulation::standard) return {};
  if (description.symmetry.any()) return {};
  CaseChange change;
  for (const Body& body : description.bodies) {
    if (body.role == Role::water || body.grading.levels >= grading_levels) continue;
    // At least two smoothing lengths of the coarsest level.
    const double width =
        std::max(2.0 * description.jets.back().width,
                 WendlandC2<2>::support * description.smoothing_ratio * 4.0 * body.spacing * 1.01);
    change_entry(change, "body", body.name, "grading",
                 inline_table(toml::table{{"levels", grading_levels}, {"width", metres(width)}}));
  }
  if (change.lines.empty()) return {};
  return change;
}

std::optional<CaseChange> symmetry_planes(const Case& description) {
  if (description.jets.size() != 1) return {};
  const Jet& jet = description.jets.front();
  Faces symmetry = description.symmetry;
  Box domain = description.domain;
  for (std::size_t a = 0; a < static_cast<std::size_t>(description.dimension); a += 2) {
    const bool has_plane = symmetry.minimum[a] || symmetry.maximum[a];
    const bool is_along =
        jet.traverse[a] == 0.0 && jet.angle == 0.0 && description.gravity[a] == 0.0;
    const bool fits =
        std::all_of(description.bodies.begin(), description.bodies.end(), [&](const Body& body) {
          return is_symmetric(body, a, jet.position[a], description.dimension);
        });
    if (has_plane || !is_along || !fits) continue;
    symmetry.minimum[a] = true;
    domain.minimum[a] = jet.position[a];
  }
  if (symmetry == description.symmetry) return {};
  CaseChange change;
  toml::table section{{"minimum", point(domain.minimum, description.dimension)},
                      {"maximum", point(domain.maximum, description.dimension)},
                      {"symmetry", words(symmetry)}};
  std::vector<std::string> keys;
  for (const char* key : {"minimum", "maximum", "symmetry"})
    keys.push_back(fmt::format("{} = {}", key, written_as(*section.get(key))));
  change.lines.push_back(fmt::format("[domain] {}", fmt::join(keys, "; ")));
  change.changes.insert("domain", std::move(section));
  return change;
}

std::optional<CaseChange> plane_case(const Case& description) {
  if (description.dimension == 2) return {};
  CaseChange change;
  change.to_plane = true;
  change.lines.emplace_back(
      "dimension = 2, without the third entry of points and the keys of depth");
  return change;
}

}  // namespace kerf
