// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "input/draft.hpp"
#include "input/material_library.hpp"
#include "input/sections.hpp"
#include "input/toml_writer.hpp"
#include "input/units.hpp"
#include "model/case.hpp"
#include "model/expression.hpp"

namespace kerf {

namespace {

constexpr auto plane_faces = std::span(face_words).first<4>();
constexpr std::array<std::string_view, 3> space_variables{"x", "y", "z"};

}  // namespace

std::vector<Key> body_keys() {
  using namespace key_range;
  using enum ValueKind;
  // clang-format off
  return {
      {"name", name, "", "", any, {}, "", "Unique name of the body", stored_in<&Body::name>},
      {"role", word, "", "(the kind of its material)", any, role_words, "", "Role of the body; a rigid body needs no material", stored_in<&Body::role>},
      {"material", name, "", "", any, {}, "elastic water", "Name of a material of this case or of the library", stored_in<&BodyDraft::material>},
      {"shape", table, "", "", any, {}, "", "The region that the body fills"},
      {"spacing", quantity, "m", "(that of the finest jet; without a jet it must be given)", positive, {}, "", "Distance of neighbouring particles, d", stored_in<&Body::spacing>},
      {"lattice", word, "", "square", any, lattice_words, "", "Initial lattice of the particles; square is cubic in 3D, hexagonal is close-packed in 3D", stored_in<&Body::lattice>},
      {"lattice_angle", quantity, "rad", "(that of most faces of the body; 0 deg in the paper's formulation)", within(0.7853981633974484), {}, "", "Angle of the lattice to the axes, about z and counterclockwise; bodies that are joined, or included in one another, have one angle, bodies at a symmetry plane 0 deg", stored_in<&Body::lattice_angle>},
      {"offset", vector, "m", "0 m", any, {}, "", "Shift of the lattice along its axes, at most one spacing along each", stored_in<&Body::offset>},
      {"grading", table, "", "(off: one spacing)", any, {}, "elastic+standard rigid+standard", "Resolution that decreases with the distance from a region; `spacing` is the finest. For a square lattice without offset"},
      {"body_fitted", flag, "", "true", any, {}, "elastic+standard water+standard 3D+rigid+standard", "The outermost particles lie along slanted and round faces, half a spacing below them; without, they keep to the lattice, and such faces are staircases. Graded bodies, and those that share a lattice with an inclusion, keep to it", stored_in<&Body::body_fitted>},
      {"jitter", number, "", "0", from_zero_to(0.3), {}, "elastic+standard water+standard", "Random displacement of particles from the lattice, in spacings, before the layout is relaxed; it removes preferred directions of cracks and flows", stored_in<&Body::jitter>},
      {"seed", integer, "", "1", {0, 2147483647}, {}, "elastic+standard water+standard", "Seed of the random numbers of this body", stored_in<&Body::seed>},
      {"velocity", vector, "m/s", "0 m/s", within(1e5), {}, "elastic water", "Initial velocity"},
      {"velocity_expression", expressions, "", "(velocity)", any, space_variables, "elastic water", "Initial velocity in m/s as expressions in x, y, z in m", stored_in<&Body::velocity>},
      {"pressure", quantity, "Pa", "0 Pa", not_negative, {}, "water+standard", "Initial pressure: the initial density of the water is that at this pressure", stored_in<&Body::pressure>},
      {"fixed", flag, "", "false", any, {}, "elastic rigid", "The particles do not move, as those of a rigid body without a displacement_expression", stored_in<&Body::fixed>},
      {"displacement_expression", expressions, "", "(free)", any, time_variable, "elastic rigid", "Prescribed displacement in m as expressions in t in s, 0 at t = 0", stored_in<&Body::displacement>},
      {"absorbing", faces, "", "(none)", any, plane_faces, "2D+elastic+standard", "Faces of the body, a box, that absorb waves, as if the body were infinite beyond them", stored_in<&Body::absorbing>},
      {"absorbing", faces, "", "(none)", any, face_words, "3D+elastic+standard", "Faces of the body, a box, that absorb waves, as if the body were infinite beyond them", stored_in<&Body::absorbing>},
      {"joined_to", name, "", "(nothing)", any, {}, "elastic", "Name of an elastic body that this one is bonded to, as one piece", stored_in<&Body::joined_to>},
      {"inclusion_of", name, "", "(nothing)", any, {}, "elastic water", "Name of an elastic body that contains this one: the shape of this body is cut out of that body, whose lattice it continues if both are square and of one spacing; an elastic inclusion is also bonded to it", stored_in<&BodyDraft::inclusion_of>},
      {"repelling_layer", word, "", "top", any, repelling_layer_words, "rigid", "The outermost layer of particles that repels, eq. (43)", stored_in<&Body::repelling_layer>},
      {"friction", number, "", "none", from_zero_to(10.0), {}, "rigid+standard", "Coefficient of dry friction; none = that of the other body", stored_in<&Body::friction>},
      {"repulsion", quantity, "m2/s2", "(the square of the fastest speed)", not_negative, {}, "rigid", "Strength D of the repulsion, eq. (43)", stored_in<&Body::repulsion>},
  };
  // clang-format on
}

std::vector<Key> grading_keys() {
  using namespace key_range;
  using enum ValueKind;
  // clang-format off
  return {
      {"levels", integer, "", "", {1, 4}, {}, "", "How often the spacing doubles at most", stored_in<&Grading::levels>},
      {"width", quantity, "m", "", positive, {}, "", "The spacing doubles beyond this distance, again beyond twice it, and so on", stored_in<&Grading::width>},
      {"around", table, "", "(the water of the jets, along their whole axes)", any, {}, "", "A shape; distances are from the box around it, of a union from those around its parts"},
  };
  // clang-format on
}

namespace {

// Reads the role of a body and its material. A body with an unknown material, which is recorded as
// a problem, is treated as elastic.
void read_role(Draft& draft, Section& section, BodyDraft& entry) {
  Role& role = entry.body.role;
  const bool given = section.has("role");
  if (given) section.read_one("role", entry.body);
  if (role == Role::rigid) return;
  // The key `material` depends on the role, and the default role depends on the material.
  const std::string assumed(word_of(role, role_words));
  section.assume(assumed);
  section.read_one("material", entry);
  const MaterialDraft* material = section.has("material") && is_name(entry.material)
                                      ? use_material(draft, section, entry.material)
                                      : nullptr;
  section.withdraw(assumed);
  if (material) {
    const std::string kind = kind_name(material->material.kind);
    if (given && kind != assumed)
      section.refuse("role", fmt::format("the material \"{}\" is {}", entry.material, kind),
                     "Remove the role or choose another material",
                     fmt::format("\"{}\" or \"rigid\"", kind));
    role = law_of<Role>(kind, role_words);
  }
  section.assume(word_of(role, role_words));
}

void check_offset(Section& section, const Body& body) {
  for (const double shift : body.offset) {
    if (std::abs(shift) <= body.spacing || body.spacing <= 0.0) continue;
    section.refuse(
        "offset", "the shift is larger than a spacing",
        "Subtract multiples of the spacing: they have no effect",
        fmt::format("entries of at most {}", show_quantity(body.spacing, "m", Bound::most)));
    return;
  }
}

// An inclusion is bonded to the body that contains it.
void check_bonds(Section& section, const BodyDraft& entry) {
  if (!entry.body.joined_to.empty() && !entry.inclusion_of.empty())
    section.refuse("joined_to", "an inclusion is bonded to the body that it lies in",
                   "Remove the key", "nothing where the body has inclusion_of");
}

void read_velocity(Section& section, Body& body) {
  if (section.has("velocity") && section.has("velocity_expression"))
    section.refuse("velocity_expression", "the velocity is given as numbers as well",
                   "Remove one of the two", "one of velocity and velocity_expression");
  if (section.has("velocity_expression")) return;
  const Point velocity = section.vector("velocity");
  for (std::size_t a = 0; a < 3; ++a) body.velocity[a] = shortest(velocity[a]);
}

// Refuses a displacement that is not 0 at the start, since it would be a jump.
void check_displacement(Section& section, const Body& body) {
  if (!section.has("displacement_expression")) return;
  if (section.reading().problems.any()) return;
  for (const std::string& formula : body.displacement) {
    const double start = Expression(formula, {"t"}).evaluate(0.0);
    if (std::abs(start) <= 1e-9 * body.spacing) continue;
    section.refuse("displacement_expression", fmt::format("\"{}\" is {} at t = 0", formula, start),
                   "Move the shape to the initial position of the body",
                   "formulas that are 0 at t = 0");
    return;
  }
}

// Refuses a motion of particles that do not move.
void check_fixed(Section& section, const Body& body) {
  const bool has_velocity = body.velocity != Body().velocity;
  const char* motion = section.has("displacement_expression") ? "a displacement_expression"
                       : has_velocity                         ? "a velocity"
                                                              : nullptr;
  if (body.fixed && motion)
    section.refuse("fixed", fmt::format("the body also has {}", motion), "Remove one of the two",
                   "false, where the body moves");
}

void check_jitter(Section& section, const Body& body) {
  if (body.jitter > 0.0 && body.grading.levels > 0)
    section.refuse("jitter", "the body is graded", "Remove the key, or the grading",
                   "0 where the body has a grading");
}

void check_absorbing(Section& section, const Body& body) {
  if (!section.has("absorbing")) return;
  const Shape& shape = body.shape;
  const bool cut_box = shape.kind == Shape::Kind::difference && !shape.parts.empty() &&
                       shape.parts.front().kind == Shape::Kind::box;
  if (shape.kind == Shape::Kind::box || cut_box) return;
  section.refuse("absorbing", "the shape of the body has no such faces",
                 "Use a box, and absorb on its sides",
                 "boxes, or differences whose first part is one");
}

void check_layer(Section& section, const Body& body) {
  if (section.reading().dimension == 3) return;
  if (body.repelling_layer == RepellingLayer::front || body.repelling_layer == RepellingLayer::back)
    section.refuse("repelling_layer", "a 2D body has no such side", "Choose a side in the plane",
                   "\"top\", \"bottom\", \"left\", \"right\" or \"all\" in 2D");
}

// Returns the key of the file that sets the width of the grading of a [workpiece].
std::string key_of_workpiece_grading(const Draft& draft) {
  for (const char* key :
       {"workpiece.grading_width", "workpiece.levels", "workpiece.spacing", "machine.spacing"})
    if (draft.reading.problems.is_written(key)) return key;
  return "workpiece.grading_width";
}

void read_grading(Draft& draft, Section& section, Body& body) {
  const toml::table* written = section.table("grading");
  if (written == nullptr) return;
  Section keys(draft.reading, *written, "grading", section.path("grading"));
  Grading& grading = body.grading;
  keys.read(grading);
  if (const toml::table* around = keys.table("around"))
    grading.around = read_shape(draft.reading, *around, keys.path("around"));
  keys.refuse_unknown();
  if (draft.reading.problems.any()) return;
  const double coarsest = body.spacing * std::pow(2.0, grading.levels);
  const bool is_workpiece = section.path("grading") == "workpiece.grading";
  // A smaller width could put a cell next to one that is four times as wide.
  if (grading.width < coarsest)
    draft.reading.problems.add(
        {is_workpiece ? key_of_workpiece_grading(draft) : keys.path("width"),
         section.has("spacing") ? "the width of the grading is less than the coarsest spacing"
                                : fmt::format("the width of the grading is less than the coarsest "
                                              "spacing; the finest one, {}, "
                                              "is that of the jet, which grows with the standoff",
                                              show_quantity(body.spacing, "m")),
         fmt::format("widths of at least {}", show_quantity(coarsest, "m", Bound::least)),
         section.has("spacing") ? "Choose a larger width, a smaller spacing or fewer levels"
                                : "Check the standoff, or choose a larger width or a spacing"});
  if (body.lattice != Lattice::square || body.offset != Point{})
    section.refuse("grading", "the lattice of the body is hexagonal or shifted",
                   "Remove the key lattice or offset, or the grading",
                   "a square lattice without offset");
}

// The default spacing of a body is that of the finest jet.
void find_spacing(const Draft& draft, Section& section, Body& body) {
  if (section.has("spacing")) return;
  body.spacing = finest_jet_spacing(draft);
  const Problems& problems = draft.reading.problems;
  const bool has_jet = problems.is_written("machine") || problems.is_written("jet");
  if (body.spacing == 0.0 && !(has_jet && problems.any()))  // one that failed has no spacing
    section.refuse("spacing", "the key is missing", "Add it: there is no jet to take it from");
}

void read_body(Draft& draft, const toml::table& table, const std::string& path) {
  BodyDraft entry;
  entry.path = path;
  Body& body = entry.body;
  Section section(draft.reading, table, "body", path);
  read_role(draft, section, entry);
  section.read(entry);
  section.read(body);
  if (const toml::table* shape = section.table("shape"))
    body.shape = read_shape(draft.reading, *shape, section.path("shape"));
  find_spacing(draft, section, body);
  check_offset(section, body);
  if (body.role != Role::water) read_grading(draft, section, body);
  if (body.role != Role::rigid) {
    read_velocity(section, body);
    check_jitter(section, body);
  }
  if (body.role != Role::water) check_displacement(section, body);
  check_bonds(section, entry);
  check_fixed(section, body);
  if (body.role == Role::elastic) check_absorbing(section, body);
  if (body.role == Role::rigid) check_layer(section, body);
  section.refuse_unknown();
  entry.has_repulsion = section.has("repulsion");
  entry.has_offset = section.has("offset");
  entry.has_lattice_angle = section.has("lattice_angle");
  draft.bodies.push_back(std::move(entry));
}

const Body* body_of_name(const Draft& draft, const std::string& name) {
  for (const BodyDraft& entry : draft.bodies)
    if (entry.body.name == name) return &entry.body;
  return nullptr;
}

// Checks that a key which names the body that another one is bonded to, or lies in, names an
// elastic body.
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
  if (draft.result.workpiece) read_body(draft, draft.workpiece.body, "workpiece");
  const auto tables = top.tables("body");
  for (std::size_t i = 0; i < tables.size(); ++i) read_body(draft, *tables[i], indexed("body", i));
  for (const BodyDraft& entry : draft.bodies) {
    check_partner(draft, entry, "joined_to", entry.body.joined_to);
    check_partner(draft, entry, "inclusion_of", entry.inclusion_of);
  }
  if (!draft.reading.problems.any()) place_inclusions(draft);
}

void write_body(TomlWriter& writer, const Case& description, const Body& body) {
  WrittenKeys others{{"shape", shape_text(writer, body.shape)}};
  if (body.role != Role::rigid) others["material"] = material_text(description, body.material);
  if (body.lattice_follows_faces) others["lattice_angle"] = "";
  const Grading& grading = body.grading;
  if (grading.levels > 0) {
    WrittenKeys around;
    if (grading.around) around["around"] = shape_text(writer, *grading.around);
    others["grading"] = writer.inline_table("grading", grading, around);
  }
  writer.table("[[body]]", "body", body, others);
}

}  // namespace kerf
