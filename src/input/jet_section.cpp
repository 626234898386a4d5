// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "input/draft.hpp"
#include "input/sections.hpp"
#include "input/toml_writer.hpp"
#include "model/case.hpp"
#include "model/expression.hpp"

namespace kerf {

namespace {

constexpr std::array<std::string_view, 3> profile_words{"uniform", "parabolic", "power"};
constexpr std::array profile_formulas{"1", "1 - r^2", "(1 - r)^(1/7)"};
constexpr std::array<std::string_view, 1> radius_variable{"r"};

}  // namespace

std::vector<Key> jet_keys() {
  using namespace key_range;
  using enum ValueKind;
  // clang-format off
  return {
      {"name", name, "", "", any, {}, "", "Unique name of the jet", stored_in<&Jet::name>},
      {"material", name, "", "water", any, {}, "", "Name of a water of this case or of the library", stored_in<&JetDraft::material>},
      {"speed", quantity, "m/s", "", up_to(1e4), {}, "", "Mean speed over the section", stored_in<&Jet::speed>},
      {"width", quantity, "m", "", up_to(1e6), {}, "2D slot", "Width of the slot of a two-dimensional jet, or of one in 3D that has a length; a jet in 3D without one is round and has a diameter", stored_in<&Jet::width>},
      {"diameter", quantity, "m", "", up_to(1e6), {}, "3D+round", "Diameter of the round jet; a jet in 2D is a slot and has a width", stored_in<&Jet::width>},
      {"length", quantity, "m", "", up_to(1e6), {}, "3D+slot", "Length of a slot, at right angles to the plane of the jet and the vertical; for a jet straight down along z", stored_in<&Jet::length>},
      {"position", vector, "m", "", within(1e6), {}, "", "Point on the workpiece that the axis of the jet aims at", stored_in<&Jet::position>},
      {"standoff", quantity, "m", "", from_zero_to(1e6), {}, "", "Distance from the nozzle to that point", stored_in<&Jet::standoff>},
      {"angle", quantity, "rad", "0 deg", within(3.141592653589793), {}, "", "Inclination from the vertical, towards +x", stored_in<&Jet::angle>},
      {"azimuth", quantity, "rad", "0 deg", within(6.283185307179586), {}, "3D", "Rotation of the inclination about the vertical, from +x towards +z", stored_in<&Jet::azimuth>},
      {"spacing", quantity, "m", "(the width or diameter over the particles that `quality` puts across it)", positive, {}, "", "Distance of neighbouring particles, d", stored_in<&Jet::spacing>},
      {"start", quantity, "s", "0 s", not_negative, {}, "", "Time at which the water starts", stored_in<&Jet::start>},
      {"stop", quantity, "s", "none", positive, {}, "", "Time at which the water stops", stored_in<&Jet::stop>},
      {"traverse", vector, "m/s", "0 m/s", within(1e4), {}, "", "Velocity of the nozzle", stored_in<&Jet::traverse>},
      {"dwell", quantity, "s", "0 s", not_negative, {}, "", "Time after the start during which the nozzle does not move", stored_in<&Jet::dwell>},
      {"pulse_frequency", quantity, "Hz", "0 Hz", not_negative, {}, "", "Frequency of a pulsed jet, which needs a duty below 1; 0 = steady", stored_in<&Jet::pulse_frequency>},
      {"duty", number, "", "1", up_to(1.0), {}, "", "Share of each pulse period during which water flows, from its start", stored_in<&Jet::duty>},
      {"feed", word, "", "pressure", any, feed_words, "standard", "What the pump holds: its pressure, so that pressure at the exit slows the water by Bernoulli's equation, or the flow, whatever pressure that takes", stored_in<&Jet::feed>},
      {"profile", word, "", "uniform", any, profile_words, "", "Speed over the section: uniform, parabolic 1 - r^2, or power (1 - r)^(1/7)"},
      {"profile_expression", expression, "", "(profile)", any, radius_variable, "", "Speed over the section as an expression in r, 0 on the axis and 1 at the edge; its mean is scaled to the speed", stored_in<&Jet::profile>},
  };
  // clang-format on
}

namespace {

// Checks that the profile is not negative anywhere over the section and is not 0 everywhere.
void check_profile(Section& section, const std::string& formula) {
  const Expression profile(formula, {"r"});
  constexpr int samples = 200;
  double sum = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double r = (i + 0.5) / samples;
    const double speed = profile.evaluate(r);
    sum += speed;
    if (speed >= 0.0 && std::isfinite(speed)) continue;
    section.refuse("profile_expression", fmt::format("the profile is {} at r = {}", speed, r),
                   "Correct the formula",
                   "a formula that is finite and not negative for r in 0..1");
    return;
  }
  if (!(sum > 0.0))
    section.refuse("profile_expression", "the profile is 0 everywhere", "Correct the formula",
                   "a formula that is greater than 0 somewhere for r in 0..1");
}

void read_profile(Section& section, Jet& jet) {
  if (!section.has("profile_expression")) {
    jet.profile = profile_formulas[section.word<std::size_t>("profile")];
    return;
  }
  if (section.has("profile"))
    section.refuse("profile_expression", "the profile is named as well", "Remove one of the two",
                   "one of profile and profile_expression");
  if (section.read_one("profile_expression", jet)) check_profile(section, jet.profile);
}

void check_jet(Section& section, const Jet& jet, const char* width) {
  if (section.has(width) && jet.width > 0.0 && jet.width < jet.spacing)
    section.refuse("spacing", "not one particle fits across the jet", "Choose a smaller spacing",
                   fmt::format("at most the {} of the jet", width));
  check_pulses(section, jet.pulse_frequency, jet.duty);
  if (jet.stop <= jet.start && section.has("stop"))
    section.refuse("stop", "the jet stops before it starts", "Correct start or stop",
                   "a time after start, or \"none\"");
}

void read_jet(Draft& draft, const toml::table& table, const std::string& path) {
  Section section(draft.reading, table, "jet", path);
  JetDraft entry;
  entry.path = path;
  Jet& jet = entry.jet;
  const int dimension = draft.reading.dimension;
  const bool is_slot = dimension == 2 || section.has("length");
  section.assume(is_slot ? "slot" : "round");
  const char* width = is_slot ? "width" : "diameter";
  if (!section.has(width) && section.has(is_slot ? "diameter" : "width")) {
    section.excuse(width);
    jet.width = 1.0;
  }
  section.read(entry);
  use_water(draft, section, entry.material);
  read_profile(section, jet);
  section.read(jet);
  if (!section.has("spacing")) jet.spacing = jet.width / particles_across(draft.quality, dimension);
  check_jet(section, jet, width);
  section.refuse_unknown();
  draft.jets.push_back(std::move(entry));
}

}  // namespace

const MaterialDraft* use_water(Draft& draft, Section& section, const std::string& name) {
  const MaterialDraft* material = is_name(name) ? use_material(draft, section, name) : nullptr;
  if (material && material->material.kind != MaterialKind::water)
    section.refuse("material", "a jet is of water, and this is an elastic material",
                   "Choose a material of the kind \"water\"", "a material of the kind \"water\"");
  return material;
}

void check_pulses(Section& section, double frequency, double duty) {
  if (duty < 1.0 && frequency == 0.0)
    section.refuse("duty", "the jet does not pulse", "Add a pulse_frequency or remove the duty",
                   "1 without a pulse_frequency");
  if (frequency > 0.0 && !section.has("duty"))
    section.refuse("pulse_frequency", "without a duty below 1 the water never pauses",
                   "Add the share of each pulse in which water flows, such as duty = 0.5",
                   "0 Hz, or a duty beside it");
}

void read_jets(Draft& draft, Section& top) {
  const auto tables = top.tables("jet");
  for (std::size_t i = 0; i < tables.size(); ++i) read_jet(draft, *tables[i], indexed("jet", i));
}

void write_jet(TomlWriter& writer, const Case& description, const Jet& jet) {
  const bool is_slot = description.dimension == 2 || jet.length > 0.0;
  writer.table("[[jet]]", "jet", jet, {{"material", material_text(description, jet.material)}},
               {is_slot ? "slot" : "round"});
}

}  // namespace kerf
