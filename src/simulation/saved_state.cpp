// SPDX-License-Identifier: Apache-2.0
#include "simulation/saved_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "model/case.hpp"
#include "particles/new_particle.hpp"
#include "simulation/media_order.hpp"

namespace kerf {

namespace {

constexpr const char* of_particles = "particles/";

[[noreturn]] void refuse_state(const std::string& name, const char* what) {
  throw UserError(fmt::format("'{}' {}. Start the run again with --force.", name, what),
                  exit_files);
}

std::size_t length_of(const ArchiveArray& array) {
  return std::visit([](const auto& values) { return values.size(); }, array);
}

const ArchiveArray& array_of(const Archive& archive, const std::string& name) {
  const auto found = archive.arrays.find(name);
  if (found == archive.arrays.end()) refuse_state(name, "is missing");
  return found->second;
}

template <class T>
const std::vector<T>& values_of(const Archive& archive, const std::string& name) {
  const auto* values = std::get_if<std::vector<T>>(&array_of(archive, name));
  if (values == nullptr) refuse_state(name, "is of another type");
  return *values;
}

// Returns the length that the array must have.
std::size_t length_due(const std::string& name, const Archive& saved, const Archive& fresh) {
  const std::size_t length = length_of(array_of(fresh, name));
  if (!name.starts_with(of_particles)) return length;
  const std::size_t before = values_of<std::uint32_t>(fresh, "particles/id").size();
  const std::size_t now = values_of<std::uint32_t>(saved, "particles/id").size();
  // Without a particle the number of components is unknown; the engine tests the length itself.
  return before == 0 ? length_of(array_of(saved, name)) : length / before * now;
}

template <class T>
void check_below(const Archive& saved, const std::string& name, std::size_t count) {
  const auto& values = values_of<T>(saved, name);
  if (std::any_of(values.begin(), values.end(), [=](T value) { return value >= count; }))
    refuse_state(name, "has a number that is too great");
}

void check_finite(const std::string& name, const ArchiveArray& array) {
  const auto check = [&](const auto& values) {
    if (!std::all_of(values.begin(), values.end(), [](auto x) { return std::isfinite(double(x)); }))
      refuse_state(name, "has a value that is not a number");
  };
  std::visit(check, array);
}

// The particles of a jet name the columns of its nozzle; no others can be in one.
void check_columns(const Archive& saved, const Archive& fresh, const Case& description) {
  const auto& source = values_of<std::uint16_t>(saved, "particles/source");
  const auto& column = values_of<std::uint32_t>(saved, "particles/inlet_column");
  const auto& flags = values_of<std::uint8_t>(saved, "particles/flags");
  std::vector<std::size_t> columns(description.bodies.size(), 1);
  for (std::size_t jet = 0; jet < description.jets.size(); ++jet)
    columns.push_back(length_of(array_of(fresh, fmt::format("nozzle/{}", jet))));
  const std::size_t first_jet = description.bodies.size();
  for (std::size_t i = 0; i < source.size(); ++i) {
    const bool is_jet = source[i] >= first_jet && source[i] < columns.size();
    if ((flags[i] & flag::upstream) != 0 && !is_jet)
      refuse_state("particles/flags", "has a number that is not possible");
    if (source[i] < columns.size() && column[i] >= std::max<std::size_t>(1, columns[source[i]]))
      refuse_state("particles/inlet_column", "has a number that is too great");
  }
}

// Refuses a number of the array that is not a whole one below `count`.
void check_whole(const Archive& saved, const std::string& name, std::size_t place, double count) {
  const auto& values = values_of<double>(saved, name);
  if (place >= values.size() || !(values[place] >= 0.0 && values[place] < count))
    refuse_state(name, "has a number that is not possible");
}

// The particle with the shortest wave time, and the substeps of a soft solid.
void check_solid(const Archive& saved, const Archive& fresh) {
  if (fresh.arrays.count("solid/wave") == 0) return;
  constexpr double most_substeps = 1e6;
  const std::size_t particles = length_of(array_of(saved, "solid/elastic_share"));
  check_whole(saved, "solid/wave", 1, static_cast<double>(particles));
  for (const std::size_t place : {0u, 1u}) check_whole(saved, "solid/cycle", place, most_substeps);
}

}  // namespace

void check_saved_state(const Archive& saved, const Archive& fresh, const Case& description) {
  // A frame that travels lays out another solid after each shift: the solid tests its lengths.
  const bool travels = fresh.arrays.count("shifts") != 0;
  for (const auto& [name, array] : fresh.arrays) {
    const ArchiveArray& here = array_of(saved, name);
    if (here.index() != array.index()) refuse_state(name, "is of another type");
    if (travels && name.starts_with("solid/")) continue;
    if (length_of(here) != length_due(name, saved, fresh)) refuse_state(name, "has another length");
  }
  for (const auto& [name, text] : fresh.texts)
    if (saved.texts.count(name) == 0) refuse_state(name, "is missing");
  if (fresh.arrays.count("particles/id") == 0) return;
  for (const char* name : {"particles/position", "particles/build_position", "particles/velocity",
                           "particles/compression", "clock"})
    check_finite(name, array_of(saved, name));
  check_solid(saved, fresh);
  check_below<std::uint16_t>(saved, "particles/source", medium_origins(description).size());
  const auto& counters = values_of<std::uint64_t>(saved, "counters");
  check_below<std::uint32_t>(saved, "particles/id", counters.at(1));
  check_columns(saved, fresh, description);
}

}  // namespace kerf
