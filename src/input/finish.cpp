// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "geometry/jet_direction.hpp"
#include "geometry/shapes.hpp"
#include "input/draft.hpp"
#include "machine/characteristic_speed.hpp"
#include "model/case.hpp"
#include "model/material_laws.hpp"

namespace kerf {

namespace {

void check_names(Draft& draft) {
  const auto check = [&](const std::vector<std::array<std::string, 2>>& names_and_paths) {
    std::set<std::string> seen;
    for (const auto& [name, path] : names_and_paths)
      if (!seen.insert(name).second)
        draft.reading.problems.add(
            {path + ".name", "the name is used already", "a unique name", "Choose another name"});
  };
  // Results and messages name bodies and jets alike.
  std::vector<std::array<std::string, 2>> sources, probes;
  for (const BodyDraft& entry : draft.bodies) sources.push_back({entry.body.name, entry.path});
  for (const JetDraft& entry : draft.jets) sources.push_back({entry.jet.name, entry.path});
  for (const Probe& probe : draft.result.probes)
    probes.push_back({probe.name, indexed("probe", probes.size())});
  check(sources);
  check(probes);
}

// Sorts the materials by name and sets the indices of bodies and jets.
void resolve_materials(Draft& draft) {
  std::map<std::string, int> index;
  for (const auto& [name, entry] : draft.materials) {
    index[name] = static_cast<int>(draft.result.materials.size());
    draft.result.materials.push_back(entry.material);
  }
  for (BodyDraft& entry : draft.bodies) {
    if (entry.body.role != Role::rigid) entry.body.material = index.at(entry.material);
    draft.result.bodies.push_back(entry.body);
  }
  for (JetDraft& entry : draft.jets) {
    entry.jet.material = index.at(entry.material);
    draft.result.jets.push_back(entry.jet);
    if (entry.path == "machine") draft.result.machine->material = entry.jet.material;
  }
}

// Sets the axes of the jets in the bodies that are graded around them.
void find_axes(Draft& draft) {
  for (std::size_t i = 0; i < draft.bodies.size(); ++i) {
    Grading& grading = draft.result.bodies[i].grading;
    if (grading.levels == 0 || grading.around) continue;
    const auto& workpiece = draft.result.workpiece;
    const bool travels = workpiece && workpiece->frame == WorkpieceFrame::travelling;
    const double end = travels ? std::numeric_limits<double>::infinity() : draft.result.time.end;
    for (const Jet& jet : draft.result.jets) {
      const auto lines =
          lines_along(jet, traverse_speed(jet) * std::max(0.0, end - jet.start - jet.dwell));
      grading.lines.insert(grading.lines.end(), lines.begin(), lines.end());
    }
    if (grading.lines.empty())
      draft.reading.problems.add({draft.bodies[i].path + ".grading.around",
                                  "there is no jet around which the body could be finer", "a shape",
                                  "Add it: the region in which the spacing is finest"});
  }
}

// Returns the box around all bodies and nozzles, extended by half its longest edge.
void find_domain(Draft& draft) {
  if (draft.has_domain) return;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto dimension = static_cast<std::size_t>(draft.reading.dimension);
  Box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  const auto include = [&](const Point& low, const Point& high) {
    for (std::size_t a = 0; a < dimension; ++a) {
      box.minimum[a] = std::min(box.minimum[a], low[a]);
      box.maximum[a] = std::max(box.maximum[a], high[a]);
    }
  };
  for (const Body& body : draft.result.bodies) {
    const Box around = bounding_box(body.shape, draft.reading.dimension);
    include(around.minimum, around.maximum);
  }
  for (const Jet& jet : draft.result.jets) {
    const double reach = jet.standoff + jet.width;
    Point low = jet.position, high = jet.position;
    for (std::size_t a = 0; a < 3; ++a) low[a] -= reach, high[a] += reach;
    include(low, high);
  }
  double longest = 0.0;
  for (std::size_t a = 0; a < dimension; ++a)
    longest = std::max(longest, box.maximum[a] - box.minimum[a]);
  Box& domain = draft.result.domain;
  for (std::size_t a = 0; a < dimension; ++a) {
    domain.minimum[a] = box.minimum[a] - 0.5 * longest;
    domain.maximum[a] = box.maximum[a] + 0.5 * longest;
  }
}

// Above 150 m/s the default is the equation of state with real shocks, instead of Tait's with a
// sound speed of 10 V.
void find_equations_of_state(Draft& draft, double speed) {
  for (Material& material : draft.result.materials) {
    if (speed <= fast_water || !draft.materials.at(material.name).equation_is_open) continue;
    material.equation_of_state = EquationOfState::shock_hugoniot;
    material.laws->shock_hugoniot.slope = real_water_hugoniot_slope;
  }
}

void find_sound_speeds(Draft& draft, double speed) {
  for (Material& material : draft.result.materials) {
    if (material.kind != MaterialKind::water || material.sound_speed > 0.0) continue;
    if (material.equation_of_state == EquationOfState::shock_hugoniot) {
      material.sound_speed = real_water_sound_speed;
      continue;
    }
    material.sound_speed = draft.materials.at(material.name).sound_speed_factor * speed;
    if (material.sound_speed > 0.0) continue;
    draft.reading.problems.add(
        {fmt::format("materials.{}.sound_speed", material.name),
         "no jet or body moves and no water falls, so the sound speed does not follow from the "
         "fastest speed",
         "a speed of about ten times the largest expected speed",
         fmt::format("Write [materials.{0}] with base = \"{0}\" and a sound_speed",
                     material.name)});
  }
}

// Sets the default of D of eq. (43), which is of the order of a speed squared. Rigid bodies repel
// in the formulation of the paper alone.
void find_repulsions(Draft& draft, double speed) {
  if (draft.result.formulation != Formulation::shinohara2004) return;
  for (std::size_t i = 0; i < draft.bodies.size(); ++i) {
    if (draft.bodies[i].body.role != Role::rigid || draft.bodies[i].has_repulsion) continue;
    draft.result.bodies[i].repulsion = speed * speed;
    if (speed > 0.0) continue;
    draft.reading.problems.add(
        {draft.bodies[i].path + ".repulsion",
         "no jet or body moves and no water falls, so the repulsion does not follow from the "
         "fastest speed",
         "about the square of the largest expected speed", "Add it, such as \"25 m2/s2\""});
  }
}

// Refuses expressions without a finite largest speed.
void check_speed(Draft& draft, double speed) {
  constexpr double fastest_allowed = 1e5;
  if (speed <= fastest_allowed) return;
  draft.reading.problems.add({"body", fmt::format("a body moves at {} m/s", speed),
                              "velocities and displacements that are finite, up to 1e5 m/s",
                              "Correct its velocity or displacement"});
}

}  // namespace

void finish(Draft& draft) {
  resolve_materials(draft);
  check_names(draft);
  find_axes(draft);
  find_domain(draft);
  check_counts(draft);
  draft.reading.problems.throw_if_any();
  const double speed = characteristic_speed(draft.result);
  check_speed(draft, speed);
  find_equations_of_state(draft, speed);
  find_sound_speeds(draft, speed);
  find_repulsions(draft, speed);
}

}  // namespace kerf
