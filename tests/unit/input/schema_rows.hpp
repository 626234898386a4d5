// SPDX-License-Identifier: Apache-2.0
// The structures that store the values of the keys of a section, a table in which a key applies,
// and values for it: the data for tests of all rows of the schema.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "input/draft.hpp"
#include "input/section.hpp"
#include "input/toml_writer.hpp"

namespace kerf::test {

constexpr const char* table_path = "table";

// A structure that stores values of keys, without its type.
struct Storage {
  const void* id;
  bool is_model;  // and not a draft, whose values are transferred to the model with the rest of the
                  // case
  std::function<void(Section&)> read;
  std::function<ValueReference(const Key&)> value;
  std::function<void(TomlWriter&, const std::string&, const std::set<std::string>&)> write;
};

template <class Structure>
Storage storage(bool is_model, std::shared_ptr<Structure> structure) {
  return {&structure_id<Structure>, is_model,
          [structure](Section& section) { section.read(*structure); },
          [structure](const Key& key) { return value_in(*structure, key); },
          [structure](TomlWriter& writer, const std::string& section,
                      const std::set<std::string>& conditions) {
            writer.table("", section, *structure, {}, conditions);
          }};
}
template <class Structure>
Storage model() {
  return storage(true, std::make_shared<Structure>());
}
template <class Structure>
Storage draft() {
  return storage(false, std::make_shared<Structure>());
}

// Returns the structures of a section, in the order in which they are read.
inline std::vector<Storage> storages_of(std::string_view section) {
  if (section == "time") return {model<TimeControl>()};
  if (section == "materials") return {model<Material>(), draft<MaterialDraft>()};
  if (section == "body") return {model<Body>(), draft<BodyDraft>()};
  if (section == "grading") return {model<Grading>()};
  if (section == "load") return {model<Load>()};
  if (section == "shape") return {model<Shape>()};
  if (section == "machine") return {model<Machine>(), draft<JetDraft>()};
  if (section == "workpiece") return {model<WorkpieceSetting>(), draft<WorkpieceDraft>()};
  if (section == "jet") return {model<Jet>(), draft<JetDraft>()};
  if (section == "back_flow_removal") return {model<BackFlowRemoval>()};
  if (section == "probe") return {model<Probe>()};
  if (section == "artificial_stress") return {model<ArtificialStress>()};
  if (section == "numerics") return {model<Numerics>()};
  if (section == "output") return {model<OutputControl>()};
  return {model<Case>(), storage(false, std::make_shared<Draft>(
                                            Draft{Reading{Problems(""), {}}, {}, {}, {}, {}, {}}))};
}

// A table of a case file in which a key applies.
struct Surroundings {
  Case description;                  // its dimension and formulation
  std::set<std::string> conditions;  // conditions that no key of the table states
  toml::table table;
};

// Returns the key of a section that has `word` as a choice; null if there is none.
inline const Key* key_with_choice(const std::string& section, const std::string& word) {
  for (const Key& key : keys_of(section))
    if (key.kind == ValueKind::word &&
        std::find(key.choices.begin(), key.choices.end(), word) != key.choices.end())
      return &key;
  return nullptr;
}

// Writes the words that the first alternative of the conditions of the key requires into the table.
inline void satisfy(const std::string& section, const Key& key, Surroundings& around) {
  if (key.applies.empty()) return;
  for (const std::string& condition : split_words(split_words(key.applies).front(), '+')) {
    const Key* other = key_with_choice(section, condition);
    if (condition == "2D" || condition == "3D")
      around.description.dimension = condition == "2D" ? 2 : 3;
    else if (condition == "standard" || condition == "shinohara2004")
      around.description.formulation = law_of<Formulation>(condition, formulation_words);
    else if (!other)
      around.conditions.insert(condition);
    if (!other) continue;
    around.table.insert_or_assign(other->name, condition);
    satisfy(section, *other, around);
  }
}

// Returns a number in the range of a key.
inline double number_of(const Key& key) {
  const Range& range = key.range;
  if (key.kind == ValueKind::integer) return range.maximum;
  const double low = std::isfinite(range.minimum) ? range.minimum : -1.0;
  const double high = std::isfinite(range.maximum) ? range.maximum : low + 3.0;
  return low + 0.625 * (high - low);
}

inline std::string entry_text(const Key& key, double number) {
  if (key.kind == ValueKind::integer) return fmt::format("{:.0f}", number);
  if (key.unit.empty()) return fmt::format("{:#}", number);
  return toml_string(fmt::format("{} {}", number, key.unit));
}

inline std::string repeated(const std::string& entry, int times) {
  return fmt::format(
      "[{}]", fmt::join(std::vector<std::string>(static_cast<std::size_t>(times), entry), ", "));
}

// Returns an allowed value of a key, or with another number one that may not be allowed.
inline std::string value_text(const Key& key, double number, int dimension) {
  const std::string entry = entry_text(key, number);
  switch (key.kind) {
    case ValueKind::text:
    case ValueKind::name:
      return "\"sample\"";
    case ValueKind::word:
      return toml_string(key.choices.back());
    case ValueKind::flag:
      return key.standard.text == "true" ? "false" : "true";
    case ValueKind::vector:
      return repeated(entry, dimension);
    case ValueKind::quantities:
      return repeated(entry, 1);
    case ValueKind::vertices:
      return repeated(repeated(entry, 2), 3);
    case ValueKind::expression:
      return "\"0.5\"";
    case ValueKind::expressions:
      return repeated("\"0.5\"", dimension);
    case ValueKind::faces:
      return repeated(toml_string(key.choices.back()), 1);
    default:
      return entry;
  }
}

}  // namespace kerf::test
