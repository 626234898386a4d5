// SPDX-License-Identifier: Apache-2.0
// The top level of a case file and its tables of plain keys.
#include <fmt/format.h>

#include "input/draft.hpp"
#include "input/sections.hpp"
#include "input/toml_writer.hpp"
#include "input/units.hpp"
#include "model/case.hpp"

namespace kerf {

std::vector<Key> top_keys() {
  using namespace key_range;
  using enum ValueKind;
  // clang-format off
  return {
      {"title", text, "", "", any, {}, "", "Description of the case in one line", stored_in<&Case::title>},
      {"dimension", integer, "", "", {2, 3}, {}, "", "2 = plane strain, everything per metre of depth; 3 = space. Vertical is y in both", stored_in<&Case::dimension>},
      {"formulation", word, "", "standard", any, formulation_words, "", "The equations: Riemann SPH for water with total Lagrangian SPH for solids, or those of Shinohara, Okabe & Nakayama (2004)", stored_in<&Case::formulation>},
      {"precision", word, "", "mixed", any, precision_words, "", "mixed = positions in double, fields in single precision; double = all in double", stored_in<&Case::precision>},
      {"smoothing_ratio", number, "", "1.5", {1.0, 3.0}, {}, "shinohara2004", "Smoothing length over particle spacing, h / d", stored_in<&Case::smoothing_ratio>},
      {"smoothing_ratio", number, "", "1.3", {1.0, 3.0}, {}, "standard", "Smoothing length over particle spacing, h / d", stored_in<&Case::smoothing_ratio>},
      {"gravity", vector, "m/s2", "0 m/s2", within(1e4), {}, "", "Acceleration on every particle that is not rigid", stored_in<&Case::gravity>},
      {"quality", word, "", "normal", any, quality_words, "", "Resolution of jets and bodies without a spacing: 8, 12 or 20 particles of water across a jet in 2D, 6, 8 or 12 in 3D", stored_in<&Draft::quality>},
      {"time", table, "", "(with a [machine], the default of its `end`)", any, {}, "", "Length and time steps of the run"},
      {"domain", table, "", "(around all bodies and jets)", any, {}, "", "Region of the simulation"},
      {"materials", table, "", "(the library's)", any, {}, "", "Materials of this case, by name"},
      {"body", tables, "", "(none)", any, {}, "", "Bodies that consist of particles at the start"},
      {"load", tables, "", "(none)", any, {}, "standard", "Forces on elastic bodies: tractions, pressures, body forces"},
      {"workpiece", table, "", "(none)", any, {}, "standard", "A workpiece under a [machine], of which Kerf chooses the simulated part"},
      {"machine", table, "", "(none)", any, {}, "", "The setting of a water-jet machine, from which a jet follows"},
      {"jet", tables, "", "(none)", any, {}, "", "Nozzles that emit water"},
      {"back_flow_removal", table, "", "(off)", any, {}, "", "Removes jet water that flows back to its nozzle"},
      {"probe", tables, "", "(none)", any, {}, "", "Positions of measurements"},
      {"artificial_stress", table, "", "(off)", any, {}, "shinohara2004", "Correction of the tensile instability"},
      {"numerics", table, "", "(all defaults)", any, {}, "standard", "Scheme of the water, and substeps of solids"},
      {"output", table, "", "(all defaults)", any, {}, "", "Files that the run writes, and their times"},
  };
  // clang-format on
}

std::vector<Key> time_keys() {
  using namespace key_range;
  using enum ValueKind;
  // clang-format off
  return {
      {"end", quantity, "s", "(must be given without a [machine]; else the jet's flight and 4 times the workpiece's height, at the jet's speed, twice that under a nozzle at rest over a [workpiece], or 4 jet widths of traverse; where the frame of the [workpiece] travels, until its window is at the edge)", up_to(1e6), {}, "", "End time of the run", stored_in<&TimeControl::end>},
      {"courant", number, "", "0.25", up_to(1.0), {}, "shinohara2004", "Factor of the acoustic limit of the time step", stored_in<&TimeControl::courant>},
      {"courant", number, "", "0.45", up_to(1.0), {}, "standard", "Factor of the acoustic limit of the time step", stored_in<&TimeControl::courant>},
      {"maximum_step", quantity, "s", "none", positive, {}, "", "Largest time step", stored_in<&TimeControl::maximum_step>},
      {"after_cut", quantity, "s", "none", not_negative, {}, "", "The run ends this time after the workpiece is cut through, if that is before `end`; with a [workpiece] under a nozzle at rest the default is a flight of 20 jet widths, without a traverse speed only where `end` is not stated", stored_in<&TimeControl::after_cut>},
      {"stop", word, "", "end", any, run_stop_words, "standard", "What ends the run: its end, or a [cut that is stationary](theory/travelling_frame.md) before it, where the frame of the [workpiece] travels", stored_in<&TimeControl::stop>},
      {"stop_tolerance", number, "", "0.03", {0.0, 1.0, true}, {}, "stationary", "Largest change of a stationary cut from one stretch of the path to the next, relative", stored_in<&TimeControl::stop_tolerance>},
      {"relax", quantity, "s", "0 s", not_negative, {}, "standard", "Until this time, at most the end, solids are settled under their loads by dynamic relaxation: whenever their kinetic energy has passed a peak, they are stopped", stored_in<&TimeControl::relax>},
  };
  // clang-format on
}

std::vector<Key> domain_keys() {
  using namespace key_range;
  using enum ValueKind;
  static constexpr auto plane_faces = std::span(face_words).first<4>();
  // clang-format off
  return {
      {"minimum", vector, "m", "", within(1e8), {}, "", "Lowest corner", stored_in<&Case::domain, &Box::minimum>},
      {"maximum", vector, "m", "", within(1e8), {}, "", "Highest corner", stored_in<&Case::domain, &Box::maximum>},
      {"symmetry", faces, "", "(none)", any, plane_faces, "2D+standard", "Faces of the domain that are symmetry planes, beyond which the domain continues as its mirror image", stored_in<&Case::symmetry>},
      {"symmetry", faces, "", "(none)", any, face_words, "3D+standard", "Faces of the domain that are symmetry planes, beyond which the domain continues as its mirror image", stored_in<&Case::symmetry>},
  };
  // clang-format on
}

std::vector<Key> back_flow_removal_keys() {
  using namespace key_range;
  using enum ValueKind;
  // clang-format off
  return {
      {"speed_fraction", number, "", "0", from_zero_to(1.0), {}, "", "Water is removed if its velocity along the jet is less than this fraction of the jet speed: 0 = it moves back in the frame of the domain; the front's speed over the jet's = it moves back from the bottom of the cut", stored_in<&BackFlowRemoval::speed_fraction>},
  };
  // clang-format on
}

std::vector<Key> artificial_stress_keys() {
  using namespace key_range;
  using enum ValueKind;
  // clang-format off
  return {
      {"epsilon", number, "", "0.3", from_zero_to(1.0), {}, "", "Strength; 0 = off", stored_in<&ArtificialStress::epsilon>},
      {"exponent", number, "", "4", {0.0, 20.0, true}, {}, "", "Exponent of the kernel ratio", stored_in<&ArtificialStress::exponent>},
  };
  // clang-format on
}

std::vector<Key> numerics_keys() {
  using namespace key_range;
  using enum ValueKind;
  // clang-format off
  return {
      {"water", word, "", "riemann", any, water_scheme_words, "", "Scheme for pairs of water particles: Riemann solutions, or delta-SPH with mean pressures, density diffusion and an artificial viscosity", stored_in<&Numerics::water>},
      {"shifting", flag, "", "true", any, {}, "", "Particle shifting of moving water against the concentration gradient, except in three rows at its surfaces", stored_in<&Numerics::shifting>},
      {"smooth_walls", flag, "", "true", any, {}, "", "Rigid walls consist of layers along their surface (2D), and rigid walls and undamaged solids act on water along the normals of their faces; without, they act along the lines between particles, as a staircase where they are not in line with their lattice", stored_in<&Numerics::smooth_walls>},
      {"subcycles", integer, "", "8", {1, 64}, {}, "", "Maximum number of steps of water and contact (substeps) for one step of the bond forces of solids, whose own step limit decides; 1 = no subcycling", stored_in<&Numerics::subcycles>},
      {"sleep", flag, "", "true", any, {}, "", "Solid at rest beside which nothing moves faster than 2^-24 of the jet's speed is left out of the steps until something does", stored_in<&Numerics::sleep>},
  };
  // clang-format on
}

namespace {

// Reads an optional table of plain keys; without the table `structure` is not changed.
template <class Structure>
void read_plain(Draft& draft, Section& top, const std::string& name, Structure& structure) {
  const toml::table* written = top.table(name);
  if (!written) return;
  Section section(draft.reading, *written, name, name);
  section.read(structure);
  section.refuse_unknown();
}

}  // namespace

void read_time(Draft& draft, Section& top) {
  const toml::table empty;
  const toml::table* written = top.table("time");
  Section section(draft.reading, written ? *written : empty, "time", "time");
  TimeControl& time = draft.result.time;
  time.end = standard_end(draft);
  // A machine whose description has problems has no end of its own.
  const bool may_follow = top.has("machine") && draft.reading.problems.any();
  if (time.end == 0.0 && !section.has("end") && !may_follow)
    section.refuse("end", "the key is missing", "Add it: the end time of the run");
  section.read(time);
  // Who states the end of a run without a feed wants it to that end.
  const bool feeds = draft.result.machine && draft.result.machine->traverse_speed > 0.0;
  if (!section.has("after_cut") && (feeds || !section.has("end"))) time.after_cut = draft.after_cut;
  section.refuse_unknown();
  check_travelling_time(draft, section);
  if (time.relax > time.end && time.end > 0.0)
    section.refuse("relax", "the run ends before it", "Shorten it, or choose a later time.end",
                   "at most the end of the run, " + show_quantity(time.end, "s", Bound::most));
}

void read_domain(Draft& draft, Section& top) {
  const toml::table* written = top.table("domain");
  draft.has_domain = written != nullptr;
  if (!written) return;
  Section section(draft.reading, *written, "domain", "domain");
  section.read(draft.result);
  refuse_empty_box(section, draft.result.domain);
  section.refuse_unknown();
}

void refuse_empty_box(Section& section, const Box& box) {
  for (int a = 0; a < section.reading().dimension; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    if (box.minimum[axis] < box.maximum[axis]) continue;
    section.refuse("maximum",
                   fmt::format("entry {} is not greater than that of the minimum", a + 1),
                   "Swap the corners or correct one", "beyond the minimum along each axis");
    return;
  }
}

void read_extras(Draft& draft, Section& top) {
  if (BackFlowRemoval removal; top.has("back_flow_removal")) {
    read_plain(draft, top, "back_flow_removal", removal);
    draft.result.back_flow_removal = removal;
  }
  read_plain(draft, top, "artificial_stress", draft.result.artificial_stress);
  read_plain(draft, top, "numerics", draft.result.numerics);
}

void write_top(TomlWriter& writer, const Case& description) {
  writer.table("", "", description);
  writer.table("[time]", "time", description.time);
  writer.table("[domain]", "domain", description);
}

void write_extras(TomlWriter& writer, const Case& description) {
  if (description.back_flow_removal)
    writer.table("[back_flow_removal]", "back_flow_removal", *description.back_flow_removal);
  if (description.formulation == Formulation::shinohara2004)
    writer.table("[artificial_stress]", "artificial_stress", description.artificial_stress);
  if (description.formulation == Formulation::standard)
    writer.table("[numerics]", "numerics", description.numerics);
}

}  // namespace kerf
