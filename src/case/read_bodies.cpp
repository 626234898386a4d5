// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "case/draft.hpp"
#include "case/expression.hpp"
#include "case/material_library.hpp"
#include "case/units.hpp"

namespace kerf {

namespace {

Role role_of(const std::string& word) {
  if (word == "rigid") return Role::rigid;
  return word == "water" ? Role::water : Role::elastic;
}

// The role a body has and the material behind it. A material that nobody knows is noted and the
// body taken for an elastic one.
void read_role(Draft& draft, Section& section, BodyDraft& entry) {
  std::string role;
  if (section.has("role")) role = section.text("role");
  if (role == "rigid") {
    entry.body.role = Role::rigid;
    section.assume(role);
    return;
  }
  // The key material applies once the role is known, and the role follows from it.
  section.assume(role.empty() ? "elastic" : role);
  entry.material = section.text("material");
  const MaterialDraft* material = section.has("material") && is_name(entry.material)
                                      ? use_material(draft, section, entry.material)
                                      : nullptr;
  if (!material) return;
  const std::string kind = kind_name(material->material.kind);
  if (!role.empty() && role_of(role) != role_of(kind))
    section.refuse("role", fmt::format("the material \"{}\" is {}", entry.material, kind),
                   "Remove the role or choose another material",
                   fmt::format("\"{}\" or \"rigid\"", kind));
  entry.body.role = role_of(kind);
}

// A fresh section, as the conditions of the role must be those of the resolved one.
void assume_role(Section& section, Role role) {
  section.assume(role == Role::rigid ? "rigid" : role == Role::water ? "water" : "elastic");
}

void read_offset(Section& section, Body& body) {
  body.offset = section.vector("offset");
  for (const double shift : body.offset) {
    if (std::abs(shift) <= body.spacing || body.spacing <= 0.0) continue;
    section.refuse("offset", "the shift is larger than a spacing",
                   "Take away whole spacings: they change nothing",
                   fmt::format("entries of at most {}", write_quantity(body.spacing, "m")));
    return;
  }
}

// What lies in another body is bonded to that one.
void read_bonds(Section& section, BodyDraft& entry) {
  if (entry.body.role == Role::elastic) entry.body.joined_to = section.text("joined_to", "");
  if (entry.body.role != Role::rigid) entry.inclusion_of = section.text("inclusion_of", "");
  if (!entry.body.joined_to.empty() && !entry.inclusion_of.empty())
    section.refuse("joined_to", "an inclusion is bonded to the body that it lies in",
                   "Remove the key", "nothing where the body has inclusion_of");
}

void read_velocity(Section& section, Body& body) {
  if (section.has("velocity") && section.has("velocity_expression"))
    section.refuse("velocity_expression", "the velocity is given as numbers as well",
                   "Remove one of the two", "one of velocity and velocity_expression");
  if (section.has("velocity_expression")) {
    body.velocity = section.expressions("velocity_expression", {"x", "y", "z"});
    return;
  }
  const Point velocity = section.vector("velocity");
  for (std::size_t a = 0; a < 3; ++a) body.velocity[a] = shortest(velocity[a]);
}

// A displacement that is not 0 at the start would be a jump.
void read_displacement(Section& section, Body& body) {
  if (!section.has("displacement_expression")) return;
  body.displacement = section.expressions("displacement_expression", {"t"});
  if (section.reading().problems.any()) return;
  for (const std::string& formula : body.displacement) {
    const double start = Expression(formula, {"t"}).evaluate(0.0);
    if (std::abs(start) <= 1e-9 * body.spacing) continue;
    section.refuse("displacement_expression", fmt::format("\"{}\" is {} at t = 0", formula, start),
                   "Place the shape where the body is at the start",
                   "formulas that are 0 at t = 0");
    return;
  }
  if (body.fixed)
    section.refuse("fixed", "the body also has a displacement_expression", "Remove one of the two",
                   "false, where the body moves");
}

void read_chance(Section& section, Body& body) {
  body.jitter = section.number("jitter");
  body.seed = static_cast<std::uint64_t>(section.integer("seed"));
  if (body.jitter > 0.0 && body.grading.levels > 0)
    section.refuse("jitter", "the body is graded", "Remove the key, or the grading",
                   "0 where the body has a grading");
}

void read_absorbing(Section& section, Body& body) {
  body.absorbing = section.faces("absorbing");
  const Shape& shape = body.shape;
  const bool cut_box = shape.kind == Shape::Kind::difference && !shape.parts.empty() &&
                       shape.parts.front().kind == Shape::Kind::box;
  if (shape.kind == Shape::Kind::box || cut_box) return;
  section.refuse("absorbing", "the shape of the body has no such faces",
                 "Use a box, and absorb on its sides", "boxes, or what a difference leaves of one");
}

void read_rigid(Section& section, BodyDraft& entry) {
  static constexpr const char* words[] = {"top", "bottom", "left", "right", "front", "back", "all"};
  const std::string layer = section.text("repelling_layer");
  for (std::size_t i = 0; i < std::size(words); ++i)
    if (layer == words[i]) entry.body.repelling_layer = static_cast<RepellingLayer>(i);
  if (section.reading().dimension == 2 && (layer == "front" || layer == "back"))
    section.refuse("repelling_layer", "a 2D body has no such side", "Choose a side in the plane",
                   "\"top\", \"bottom\", \"left\", \"right\" or \"all\" in 2D");
  entry.has_repulsion = section.has("repulsion");
  entry.body.repulsion = section.number("repulsion", 0.0);
  entry.body.friction = section.number("friction");
}

void read_grading(Draft& draft, Section& section, Body& body) {
  const toml::table* written = section.table("grading");
  if (written == nullptr) return;
  Section keys(draft.reading, *written, "grading", section.path("grading"));
  Grading& grading = body.grading;
  grading.levels = keys.integer("levels");
  grading.width = keys.number("width");
  if (const toml::table* around = keys.table("around"))
    grading.around = read_shape(draft.reading, *around, keys.path("around"));
  keys.refuse_unknown();
  if (draft.reading.problems.any()) return;
  const double coarsest = body.spacing * std::pow(2.0, grading.levels);
  // Else two cells could meet of which one is four times as wide as the other.
  if (grading.width < coarsest)
    keys.refuse("width", "the width is less than the coarsest spacing",
                "Choose a larger width or fewer levels",
                fmt::format("at least {}", write_quantity(coarsest, "m")));
  if (body.lattice != Lattice::square || body.offset != Point{})
    section.refuse("grading", "the lattice of the body is hexagonal or shifted",
                   "Remove the key lattice or offset, or the grading",
                   "a square lattice without offset");
}

void read_spacing(const Draft& draft, Section& section, Body& body) {
  const double of_jets = finest_jet_spacing(draft);
  if (of_jets == 0.0 && !section.has("spacing"))
    section.refuse("spacing", "the key is missing", "Add it: there is no jet to take it from");
  else
    body.spacing = section.number("spacing", of_jets);
}

void read_body(Draft& draft, const toml::table& table, const std::string& path) {
  BodyDraft entry;
  entry.path = path;
  Body& body = entry.body;
  {
    Section roles(draft.reading, table, "body", path);
    read_role(draft, roles, entry);
  }
  Section section(draft.reading, table, "body", path);
  assume_role(section, body.role);
  section.assume(formulation_name(draft.result.formulation));
  body.name = section.text("name");
  if (const toml::table* shape = section.table("shape"))
    body.shape = read_shape(draft.reading, *shape, section.path("shape"));
  read_spacing(draft, section, body);
  body.lattice = section.text("lattice") == "hexagonal" ? Lattice::hexagonal : Lattice::square;
  read_offset(section, body);
  entry.has_offset = section.has("offset");
  if (body.role != Role::water) read_grading(draft, section, body);
  if (body.role != Role::rigid) {
    read_velocity(section, body);
    if (draft.result.formulation == Formulation::standard) read_chance(section, body);
  }
  if (body.role == Role::water && draft.result.formulation == Formulation::standard)
    body.pressure = section.number("pressure");
  if (body.role != Role::water) {
    body.fixed = section.flag("fixed");
    read_displacement(section, body);
  }
  read_bonds(section, entry);
  if (body.role == Role::elastic && section.has("absorbing")) read_absorbing(section, body);
  if (body.role == Role::rigid) read_rigid(section, entry);
  section.refuse_unknown();
  draft.bodies.push_back(std::move(entry));
}

const Body* body_of_name(const Draft& draft, const std::string& name) {
  for (const BodyDraft& entry : draft.bodies)
    if (entry.body.name == name) return &entry.body;
  return nullptr;
}

// Whether a key that names the body another one is bonded to, or lies in, names such a body.
void check_partner(Draft& draft, const BodyDraft& entry, const char* key, const std::string& name) {
  if (name.empty()) return;
  std::vector<std::string> others;
  for (const BodyDraft& other : draft.bodies)
    if (other.body.role == Role::elastic && other.body.name != entry.body.name)
      others.push_back(other.body.name);
  const Body* target = body_of_name(draft, name);
  if (target && target->role == Role::elastic && target->name != entry.body.name) return;
  const std::string guess = closest(name, others);
  draft.reading.problems.add(
      {fmt::format("{}.{}", entry.path, key), "this is not another elastic body",
       others.empty() ? std::string("nothing: there is no other elastic body")
                      : fmt::format("{}", fmt::join(others, ", ")),
       guess.empty() ? std::string("Remove the key or name such a body")
                     : fmt::format("Did you mean \"{}\"?", guess)});
}

}  // namespace

void read_bodies(Draft& draft, Section& top) {
  const auto tables = top.tables("body");
  for (std::size_t i = 0; i < tables.size(); ++i) read_body(draft, *tables[i], indexed("body", i));
  for (const BodyDraft& entry : draft.bodies) {
    check_partner(draft, entry, "joined_to", entry.body.joined_to);
    check_partner(draft, entry, "inclusion_of", entry.inclusion_of);
  }
  if (!draft.reading.problems.any()) place_inclusions(draft);
}

}  // namespace kerf
