// SPDX-License-Identifier: Apache-2.0
// Reads [workpiece]: a slab of which a part is simulated, as the first body of the case.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "input/draft.hpp"
#include "input/sections.hpp"
#include "input/toml_writer.hpp"
#include "input/units.hpp"
#include "machine/machine_jet.hpp"
#include "machine/simulated_piece.hpp"
#include "machine/travelling_frame.hpp"
#include "model/case.hpp"
#include "model/face_names.hpp"

namespace kerf {

std::vector<Key> workpiece_keys() {
  using namespace key_range;
  using enum ValueKind;
  // clang-format off
  return {
      {"material", name, "", "", any, {}, "", "Name of a material of this case or of the library", stored_in<&WorkpieceDraft::material>},
      {"size", vector, "m", "", up_to(1e4), {}, "", "Length along x, thickness and, in 3D, length along z", stored_in<&WorkpieceSetting::size>},
      {"depth", quantity, "m", "(the thickness; in a 3D draft with a nozzle at rest at most 48 jet widths, of which 32)", positive, {}, "", "Depth of the workpiece that is simulated, from its upper face on; a jet that comes near its end is carried on to the thickness by the [law of its depth](theory/exposure.md)", stored_in<&WorkpieceSetting::depth>},
      {"minimum", vector, "m", "(8 jet widths, in 2D 24, from the water of the jet and its path, or a symmetry plane)", within(1e4), {}, "", "Lowest corner of the part that is simulated, at its `depth`; of a window at the start", stored_in<&WorkpieceSetting::part, &Box::minimum>},
      {"maximum", vector, "m", "(likewise)", within(1e4), {}, "", "Highest corner of that part", stored_in<&WorkpieceSetting::part, &Box::maximum>},
      {"frame", word, "", "fixed", any, workpiece_frame_words, "", "Whether one part is simulated, or a window that [travels with the nozzle](theory/travelling_frame.md): solid is fed in ahead of it and left behind", stored_in<&WorkpieceSetting::frame>},
      {"shift", quantity, "m", "(an eighth of the window)", positive, {}, "travelling", "Distance by which the window moves at a time, in whole coarsest cells", stored_in<&WorkpieceSetting::shift>},
      {"spacing", quantity, "m", "(that of the jet)", positive, {}, "", "Distance of neighbouring particles at the jet", stored_in<&WorkpieceSetting::spacing>},
      {"levels", integer, "", "(2, or 0 where that has fewer particles, and in a travelling 2D window)", {0, 4}, {}, "", "How often the spacing doubles away from the jet; 0 = one spacing", stored_in<&WorkpieceSetting::levels>},
      {"grading_width", quantity, "m", "(two widths of the jet, at least two smoothing lengths of the coarsest spacing)", positive, {}, "", "The spacing doubles beyond this distance from the water of the jet, again beyond twice it, and so on", stored_in<&WorkpieceSetting::grading_width>},
  };
  // clang-format on
}

namespace {

constexpr double widths_after_cut = 20.0;  // of flight of the jet

// Refuses a material that is not solid.
void check_material(Draft& draft, Section& section) {
  const MaterialDraft* entry = use_material(draft, section, draft.workpiece.material);
  if (entry == nullptr || entry->material.kind == MaterialKind::elastic) return;
  section.refuse("material", "this is water, which no jet cuts",
                 "Name a solid: `kerf materials` lists those of the library, a [materials.NAME] "
                 "describes another",
                 "a material of the kind \"elastic\"");
}

// Refuses a part that is not inside the workpiece. Where no corner is written, a part that is empty
// lies around a nozzle beside the workpiece.
void check_part(Draft& draft, Section& section) {
  const WorkpieceSetting& workpiece = draft.workpiece.setting;
  for (std::size_t a = 0; a < static_cast<std::size_t>(section.reading().dimension); ++a) {
    const bool is_depth = a == 1;
    const double high = is_depth ? 0.0 : 0.5 * workpiece.size[a];
    const double low = high - workpiece.size[a], slack = 1e-9 * workpiece.size[a];
    if (workpiece.part.minimum[a] >= low - slack && workpiece.part.maximum[a] <= high + slack &&
        workpiece.part.minimum[a] < workpiece.part.maximum[a])
      continue;
    const std::string allowed = fmt::format("from {} to {}", show_quantity(low, "m", Bound::least),
                                            show_quantity(high, "m", Bound::most));
    if (!is_depth && !section.has("minimum") && !section.has("maximum")) {
      draft.reading.problems.add(
          {"machine.position",
           fmt::format("with entry {} the jet passes beside the workpiece", a + 1),
           fmt::format("entry {} {}, or a path of the nozzle that comes there in the run", a + 1,
                       allowed),
           "Correct the position, or enlarge workpiece.size; the middle of the workpiece is at 0"});
      return;
    }
    section.refuse(section.has("minimum") ? "minimum" : "maximum",
                   fmt::format("entry {} of the corners is not within the workpiece", a + 1),
                   "Correct the corners; the upper face is at y = 0, the middle at the origin",
                   "entries " + allowed);
    return;
  }
}

// Refuses a point beside the upper face, from which the standoff is measured.
void check_height(Draft& draft) {
  const double height = draft.result.machine->position[1];
  if (height == 0.0) return;
  draft.reading.problems.add(
      {"machine.position",
       fmt::format("entry 2 is {}, but the upper face of the [workpiece] is at y = 0",
                   show_quantity(height, "m")),
       "entry 2 of 0 m, a point on the upper face",
       "Write 0 there; the distance of the nozzle is the standoff"});
}

// Refuses a sheet of water of which most would fall beside the workpiece.
void check_sheet(Draft& draft) {
  constexpr double most = 2.0;  // lengths of the workpiece
  const Machine& machine = *draft.result.machine;
  const Jet& jet = draft.jets.back().jet;
  for (const std::size_t a : {std::size_t{0}, std::size_t{2}}) {
    const double length = jet.length * std::abs(jet.slot[a]),
                 size = draft.workpiece.setting.size[a];
    if (length <= most * size) continue;
    const bool is_fan = machine.orifice_type == OrificeType::fan;
    draft.reading.problems.add(
        {is_fan ? "machine.fan_angle" : "machine.orifice_length",
         fmt::format("the sheet of water is {} long at the workpiece, along {}, where that has {}",
                     show_quantity(length, "m"), a == 0 ? "x" : "z", show_quantity(size, "m")),
         fmt::format("a sheet of at most {} there, twice the workpiece",
                     show_quantity(most * size, "m", Bound::most)),
         is_fan
             ? "Choose a smaller fan_angle, standoff or orifice_length, or enlarge workpiece.size"
             : "Shorten the slit to what meets the workpiece, or enlarge workpiece.size"});
    return;
  }
}

toml::array corner(const Point& point, int dimension) {
  toml::array array;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    array.push_back(write_quantity(point[a], "m"));
  return array;
}

toml::table as_body(const Draft& draft, const Faces& absorbing) {
  const WorkpieceSetting& workpiece = draft.workpiece.setting;
  const int dimension = draft.reading.dimension;
  toml::table body{{"name", workpiece_name},
                   {"material", draft.workpiece.material},
                   {"spacing", write_quantity(workpiece.spacing, "m")},
                   {"shape", toml::table{{"type", "box"},
                                         {"minimum", corner(workpiece.part.minimum, dimension)},
                                         {"maximum", corner(workpiece.part.maximum, dimension)}}}};
  if (workpiece.levels > 0)
    body.insert("grading", toml::table{{"levels", workpiece.levels},
                                       {"width", write_quantity(workpiece.grading_width, "m")}});
  toml::array sides;
  for (const std::string& name : names_of(absorbing)) sides.push_back(name);
  if (!sides.empty()) body.insert("absorbing", std::move(sides));
  return body;
}

// Decides whether the nozzle moves in the run.
void resolve_motion(Draft& draft) {
  Machine& machine = *draft.result.machine;
  Jet& jet = draft.jets.back().jet;
  if (machine.motion != NozzleMotion::automatic) return;
  if (draft.workpiece.setting.frame == WorkpieceFrame::travelling) {
    machine.motion = NozzleMotion::travelling;
    return;
  }
  const bool stands =
      machine.traverse_speed > 0.0 &&
      may_stand(machine, jet, draft.workpiece.setting.size[1], draft.reading.dimension);
  machine.motion = stands ? NozzleMotion::standing : NozzleMotion::travelling;
  if (stands) jet.traverse = {};
}

Box united(Box box, const Box& other) {
  for (std::size_t a = 0; a < 3; ++a) {
    box.minimum[a] = std::min(box.minimum[a], other.minimum[a]);
    box.maximum[a] = std::max(box.maximum[a], other.maximum[a]);
  }
  return box;
}

// Refuses a part that the front passes before its law shows: the run ends where the front is
// `bottom_margin` above the end of a part.
void check_depth(const Draft& draft, Section& section) {
  constexpr double least_way = 1.0;  // of the front, jet widths
  const WorkpieceSetting& workpiece = draft.workpiece.setting;
  const Jet& jet = draft.jets.back().jet;
  const double least = (bottom_margin + least_way) * jet.width * std::cos(jet.angle);
  const double thickness = workpiece.size[1];
  if (workpiece.depth >= std::min(least, thickness) * (1.0 - 1e-9)) return;
  const std::string whole = "the thickness, " + show_quantity(thickness, "m");
  section.refuse(section.has("depth") ? "depth" : "minimum",
                 fmt::format("the simulated depth of {} is too small for the jet, which is {} wide",
                             show_quantity(workpiece.depth, "m"), show_quantity(jet.width, "m")),
                 "Simulate more of the workpiece",
                 least < thickness ? fmt::format("at least {}, three widths of the jet, or {}",
                                                 show_quantity(least, "m", Bound::least), whole)
                                   : whole);
}

// Sets the depth that is simulated; a corner of the part states it too.
void choose_depth(Draft& draft, Section& section) {
  WorkpieceSetting& workpiece = draft.workpiece.setting;
  const double thickness = workpiece.size[1];
  if (section.has("minimum")) {
    const double depth = -workpiece.part.minimum[1];
    if (section.has("depth") && std::abs(depth - workpiece.depth) > 1e-9 * thickness)
      section.refuse("depth", "it is not that of the corner `minimum`", "Leave one of them out",
                     write_quantity(depth, "m"));
    workpiece.depth = depth;
    check_depth(draft, section);
    return;
  }
  if (!section.has("depth")) {
    const bool is_short = draft.quality == Quality::draft && draft.reading.dimension == 3 &&
                          draft.result.machine->motion == NozzleMotion::standing;
    workpiece.depth = is_short ? depth_of_draft(draft.jets.back().jet, thickness) : thickness;
    return;
  }
  if (workpiece.depth > thickness * (1.0 + 1e-9))
    section.refuse("depth", "it is more than the thickness of the workpiece", "Lower it",
                   fmt::format("at most {}", show_quantity(thickness, "m", Bound::most)));
  check_depth(draft, section);
}

// Sets what the user leaves open.
void choose_part(Draft& draft, Section& top, const Section& section) {
  WorkpieceSetting& workpiece = draft.workpiece.setting;
  const Jet& jet = draft.jets.back().jet;
  if (!section.has("spacing")) workpiece.spacing = jet.spacing;
  // Symmetry planes could cut other bodies.
  const bool may_mirror =
      !draft.has_domain && !top.has("body") && !section.has("minimum") && !section.has("maximum");
  PieceRequest request{jet,
                       workpiece.size,
                       workpiece.depth,
                       draft.reading.dimension,
                       workpiece.spacing,
                       may_mirror,
                       workpiece.frame,
                       draft.result.smoothing_ratio,
                       {}};
  if (section.has("levels")) request.levels = workpiece.levels;
  const SimulatedPiece chosen = simulated_piece(request);
  if (!section.has("minimum")) workpiece.part.minimum = chosen.workpiece.part.minimum;
  if (!section.has("maximum")) workpiece.part.maximum = chosen.workpiece.part.maximum;
  if (!section.has("levels")) workpiece.levels = chosen.workpiece.levels;
  if (!section.has("grading_width")) workpiece.grading_width = chosen.workpiece.grading_width;
  if (workpiece.frame == WorkpieceFrame::travelling && !section.has("shift"))
    workpiece.shift = usual_shift(workpiece, travelling_frame(workpiece, jet).axis);
  if (draft.has_domain) return;
  draft.result.domain =
      united(chosen.domain, domain_around(request, workpiece.part, chosen.symmetry));
  draft.result.symmetry = chosen.symmetry;
  draft.has_domain = true;
}

}  // namespace

void read_workpiece(Draft& draft, Section& top) {
  const toml::table* written = top.table("workpiece");
  if (!written) return;
  Section section(draft.reading, *written, "workpiece", "workpiece");
  section.read(draft.workpiece);
  section.read(draft.workpiece.setting);
  section.refuse_unknown();
  if (!top.has("machine"))
    top.refuse("workpiece", "there is no [machine] to cut it", "Add one, or write a [[body]]",
               "a case with a [machine]");
  if (draft.reading.problems.any()) return;
  check_material(draft, section);
  if (draft.reading.problems.any()) return;
  resolve_motion(draft);
  check_height(draft);
  check_sheet(draft);
  const bool travels = draft.workpiece.setting.frame == WorkpieceFrame::travelling;
  if (travels) check_travel(draft, top, section);
  if (draft.reading.problems.any()) return;
  choose_depth(draft, section);
  if (draft.reading.problems.any()) return;
  choose_part(draft, top, section);
  check_part(draft, section);
  if (draft.reading.problems.any()) return;
  if (travels) check_window(draft, section);
  draft.result.workpiece = draft.workpiece.setting;
  const Faces absorbing =
      continued_faces(draft.workpiece.setting, draft.result.symmetry, draft.reading.dimension);
  draft.workpiece.body = as_body(draft, absorbing);
  const Machine& machine = *draft.result.machine;
  const Jet& jet = draft.jets.back().jet;
  if (machine.motion == NozzleMotion::standing || machine.traverse_speed == 0.0)
    draft.after_cut = widths_after_cut * jet.width / jet.speed;
}

void write_workpiece(TomlWriter& writer, const Case& description) {
  writer.table("[workpiece]", "workpiece", *description.workpiece,
               {{"material", material_text(description, description.bodies.front().material)}});
}

}  // namespace kerf
