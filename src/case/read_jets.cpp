// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "case/draft.hpp"
#include "case/expression.hpp"

namespace kerf {

namespace {

std::string profile_of(const std::string& word) {
  if (word == "parabolic") return "1 - r^2";
  if (word == "power") return "(1 - r)^(1/7)";
  return "1";
}

// Water must leave the nozzle everywhere and somewhere: the profile is nowhere negative over the
// section and not 0 throughout.
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
    jet.profile = profile_of(section.text("profile"));
    return;
  }
  if (section.has("profile"))
    section.refuse("profile_expression", "the profile is named as well", "Remove one of the two",
                   "one of profile and profile_expression");
  const std::size_t before = section.reading().problems.count();
  jet.profile = section.expression("profile_expression", {"r"});
  if (section.reading().problems.count() == before) check_profile(section, jet.profile);
}

void read_section(const Draft& draft, Section& section, Jet& jet) {
  const bool is_slot = draft.reading.dimension == 2 || section.has("length");
  section.assume(is_slot ? "slot" : "round");
  const char* name = is_slot ? "width" : "diameter";
  const char* other = is_slot ? "diameter" : "width";
  // The wrong one of the two is refused by refuse_unknown with a remedy; no need to miss the right.
  jet.width = section.number(name, section.has(other) ? std::optional<double>(1.0) : std::nullopt);
  if (draft.reading.dimension == 3 && is_slot) jet.length = section.number("length");
  const int across = particles_across(draft.quality, draft.reading.dimension);
  jet.spacing = section.number("spacing", jet.width / across);
  if (section.has(name) && jet.width > 0.0 && jet.width < jet.spacing)
    section.refuse("spacing", "not one particle fits across the jet", "Choose a smaller spacing",
                   fmt::format("at most the {} of the jet", name));
}

void read_window(Section& section, Jet& jet) {
  jet.traverse = section.vector("traverse");
  jet.dwell = section.number("dwell");
  read_pulses(section, jet.pulse_frequency, jet.duty);
  jet.start = section.number("start");
  jet.stop = section.number("stop");
  if (jet.stop <= jet.start && section.has("stop"))
    section.refuse("stop", "the jet stops before it starts", "Correct start or stop",
                   "a time after start, or \"none\"");
}

void read_jet(Draft& draft, const toml::table& table, const std::string& path) {
  Section section(draft.reading, table, "jet", path);
  JetDraft entry;
  entry.path = path;
  Jet& jet = entry.jet;
  jet.name = section.text("name");
  entry.material = section.text("material");
  use_water(draft, section, entry.material);
  jet.speed = section.number("speed");
  read_section(draft, section, jet);
  jet.position = section.vector("position");
  jet.standoff = section.number("standoff");
  jet.angle = section.number("angle");
  jet.azimuth = draft.reading.dimension == 3 ? section.number("azimuth") : 0.0;
  read_window(section, jet);
  read_profile(section, jet);
  section.refuse_unknown();
  draft.jets.push_back(std::move(entry));
}

void read_probe(Draft& draft, const toml::table& table, const std::string& path) {
  Section section(draft.reading, table, "probe", path);
  Probe probe;
  probe.name = section.text("name");
  const std::string kind = section.text("kind");
  section.assume(kind);
  probe.position = section.vector("position");
  if (kind == "plane") {
    probe.kind = Probe::Kind::plane;
    const Point normal = section.vector("normal", Point{0.0, 1.0, 0.0});
    if (std::hypot(normal[0], normal[1], normal[2]) > 0.0)
      probe.normal = unit_vector(normal);
    else
      section.refuse("normal", "the normal has no direction", "Write for example [0, 1]",
                     "any vector but zero");
  }
  section.refuse_unknown();
  draft.result.probes.push_back(probe);
}

}  // namespace

const MaterialDraft* use_water(Draft& draft, Section& section, const std::string& name) {
  const MaterialDraft* material = is_name(name) ? use_material(draft, section, name) : nullptr;
  if (material && material->material.kind != MaterialKind::water)
    section.refuse("material", "a jet is of water, and this is an elastic material",
                   "Choose a material of the kind \"water\"", "a material of the kind \"water\"");
  return material;
}

void read_pulses(Section& section, double& frequency, double& duty) {
  frequency = section.number("pulse_frequency");
  duty = section.number("duty");
  if (duty < 1.0 && frequency == 0.0)
    section.refuse("duty", "the jet does not pulse", "Add a pulse_frequency or remove the duty",
                   "1 without a pulse_frequency");
}

void read_jets(Draft& draft, Section& top) {
  const auto tables = top.tables("jet");
  for (std::size_t i = 0; i < tables.size(); ++i) read_jet(draft, *tables[i], indexed("jet", i));
}

void read_probes(Draft& draft, Section& top) {
  const auto tables = top.tables("probe");
  for (std::size_t i = 0; i < tables.size(); ++i)
    read_probe(draft, *tables[i], indexed("probe", i));
}

}  // namespace kerf
