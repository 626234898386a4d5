// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "input/material_library.hpp"
#include "input/schema.hpp"
#include "input/units.hpp"
#include "model/law_keys.hpp"

namespace kerf {

namespace {

constexpr const char* introduction = R"(# Material library

Made by `kerf materials --page` from the files of `materials/`; not written by hand.

This page lists the materials that every case may name, with the source of each value, and the laws that a material may
obey. A case names one of these materials, or starts from it with `base` ([keys.md](keys.md)). A value that a material
leaves out has its default in a case file. Values of real materials scatter: the note says under which conditions a value
holds, and where it was derived from others. A value without a source is not in the library, and neither is a material
without one. So these are missing: potato (no strength), cheese and EPDM (no fracture energy or
density), and corrugated board, whose sheets are thinner than the spacing of any run.

Nearly incompressible ones (gels, rubber, tissues) have the Poisson's ratio that their source measured or
assumed, or 0.49 where it says that they are incompressible; the nearer to 0.5, the stiffer they are in volume and the
shorter the time step.

## Strength
The strength of soft materials was measured in slow tests, where a note does not say otherwise; jets strain them at about
their speed over their width, 1e4 /s and more. With a `strength_rate_exponent` the strength grows with the rate
([theory](theory/strength_rate.md)); entries have one where a law was found in a source that could be read. For the others
the value that a test cut gives is one at the rate of that jet.

A crack of a soft tough material opens by 2 Gc / (E e_0) before it is free of stress; that is millimetres to centimetres
in muscle, leather, rubber and foams, wider than jets. There the strength decides and not the fracture energy, and these
materials break at a stress or strain (`principal_stress`, `principal_strain`); their fracture energy is known besides. A
material whose cracks open by less than a millimetre has a `crack_band`, and a brittle gel, whose strength follows from
its flaws, a `brittle_band`. The rings of `rubber` and the metals do not break: the former bounced, the latter are cut
with an abrasive, which is not modelled.

## Values to calibrate
Where sources disagree, or none measured the very quantity, an entry has the interval that they leave open. **calibrate**
in a note marks it. A run with such a value has the validity flag `uncalibrated` ([results.md](results.md)), and `kerf
check` warns of it. Find the value from one test cut: `kerf study` with `[calibrate]` ([studies.md](studies.md)), `key =
"materials.NAME.tensile_strength"` and the ends of the interval as `from` and `to`. A case that gives the value itself is
calibrated.

## Adding a material
Put a file `materials/NAME.toml` there; the build finds it.

```
title = "Description in one line"
kind = "elastic"           # or "water"
criterion = "crack_band"   # and plasticity = "..."; if left out, the defaults of a case file

[[values]]                 # for each number that a case file has a key for
key = "youngs_modulus"     # density, youngs_modulus and poisson_ratio must be given
value = "5.4 kPa"
source = "Author, title, journal, year, page or table, DOI"
note = "Range, rate of strain, direction and temperature"
interval.low = "4 kPa"     # if the sources leave it open, for a value that a test cut calibrates
interval.high = "8 kPa"
interval.sources = "..."

[[known]]                  # for what no law uses yet
name = "fracture_energy"
value = "164 J/m2"
source = "..."
```

Write this page anew with `kerf materials --page > docs/materials.md`. The names under `known`:

| name | unit | meaning |
| --- | --- | --- |
)";

std::string note_of(const LibraryValue& value) {
  if (!value.interval) return value.note;
  return fmt::format("**calibrate**: {} to {} by {}{}{}", value.interval->low_written,
                     value.interval->high_written, value.interval->sources,
                     value.note.empty() ? "" : "; ", value.note);
}

std::string rows(const std::vector<LibraryValue>& values) {
  std::string text;
  for (const LibraryValue& value : values)
    text += fmt::format("| `{}` | {} | {} | {} |\n", value.name, value.written, value.source,
                        note_of(value));
  return text;
}

// Returns a table of the laws of every kind: word, description, keys of the law.
std::string laws_of_materials() {
  std::string text =
      "\n## Laws\n\n"
      "A material of a case chooses its laws by these words. A key is described in "
      "[keys.md](keys.md).\n\n"
      "| key | word | law | its own keys |\n| --- | --- | --- | --- |\n";
  for (const LawText& law : law_texts()) {
    std::vector<std::string> keys;
    for (const Key& key : law_keys(law.chosen_by))
      if (key.applies_under({std::string(law.word)})) keys.push_back(fmt::format("`{}`", key.name));
    text += fmt::format("| `{}` | `{}` | {} | {} |\n", law.chosen_by, law.word, law.sentence,
                        fmt::join(keys, ", "));
  }
  return text;
}

}  // namespace

std::string materials_page() {
  std::string page = introduction;
  for (const KnownQuantity& quantity : known_quantities())
    page += fmt::format("| `{}` | {} | {} |\n", quantity.name,
                        quantity.unit.empty() ? "1" : quantity.unit, quantity.meaning);
  page += laws_of_materials();
  for (const LibraryMaterial& material : material_library()) {
    page += fmt::format(
        "\n## {} ({})\n{}.\n\n| key | value | source | note |\n| --- | --- | --- | --- |\n{}",
        material.name, kind_name(material.kind), material.title, rows(material.values));
    if (!material.known.empty())
      page += fmt::format("\n{}\n\n| name | value | source | note |\n| --- | --- | --- | --- |\n{}",
                          known_heading, rows(material.known));
  }
  return page;
}

}  // namespace kerf
