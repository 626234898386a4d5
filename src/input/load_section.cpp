// SPDX-License-Identifier: Apache-2.0
// Reads and writes [[load]].
#include <fmt/format.h>

#include <algorithm>

#include "geometry/shapes.hpp"
#include "geometry/surface_elements.hpp"
#include "input/draft.hpp"
#include "input/sections.hpp"
#include "input/toml_writer.hpp"
#include "model/case.hpp"
#include "model/expression.hpp"

namespace kerf {

std::vector<Key> load_keys() {
  using namespace key_range;
  using enum ValueKind;
  // clang-format off
  return {
      {"kind", word, "", "", any, load_words, "", "traction = force per area of a face; pressure = on a face, along its normal as it turns; body_force = force per mass, as gravity", stored_in<&Load::kind>},
      {"body", name, "", "", any, {}, "", "Name of the elastic body that is loaded", stored_in<&Load::body>},
      {"shape", table, "", "", any, {}, "traction pressure", "A region: the part of the surface of the body that lies in it is loaded"},
      {"shape", table, "", "(the whole body)", any, {}, "body_force", "A region: the particles that lie in it at the start are loaded"},
      {"traction", vector, "Pa", "", any, {}, "traction", "Force per area of the face as it was at the start; its direction stays", stored_in<&Load::traction>},
      {"pressure", quantity, "Pa", "", any, {}, "pressure", "Pressure on the face; negative pulls", stored_in<&Load::pressure>},
      {"acceleration", vector, "m/s2", "", within(1e9), {}, "body_force", "Force per mass", stored_in<&Load::acceleration>},
      {"history", expression, "", "1", any, time_variable, "", "Factor of the load as an expression in t in s, such as \"min(t/1e-3, 1)\"", stored_in<&Load::history>},
  };
  // clang-format on
}

void read_loads(Draft& draft, Section& top) {
  const auto tables = top.tables("load");
  for (std::size_t i = 0; i < tables.size(); ++i) {
    Section section(draft.reading, *tables[i], "load", indexed("load", i));
    Load load;
    section.read(load);
    if (const toml::table* shape = section.table("shape"))
      load.region = read_shape(draft.reading, *shape, section.path("shape"));
    section.refuse_unknown();
    draft.result.loads.push_back(std::move(load));
  }
}

namespace {

// Returns a size of the elements of a surface, m: a quarter of the spacing, or one at which the
// surface of the bounding box has about `most` elements.
double element_size(const Body& body, int dimension, double most) {
  const Box box = bounding_box(body.shape, dimension);
  std::array<double, 3> edge{};
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    edge[a] = box.maximum[a] - box.minimum[a];
  const double size =
      dimension == 2
          ? 2.0 * (edge[0] + edge[1]) / most
          : std::sqrt(2.0 * (edge[0] * edge[1] + edge[1] * edge[2] + edge[2] * edge[0]) / most);
  return std::max(0.25 * body.spacing, size);
}

}  // namespace

// Refuses loads on bodies that do not exist or cannot move, and those whose region holds no part of
// the body.
void check_loads(Draft& draft) {
  const Case& result = draft.result;
  std::vector<std::string> names;
  for (const Body& body : result.bodies)
    if (body.role == Role::elastic && !body.fixed && body.displacement[0].empty())
      names.push_back(body.name);
  for (std::size_t i = 0; i < result.loads.size(); ++i) {
    const Load& load = result.loads[i];
    const auto body = std::find_if(result.bodies.begin(), result.bodies.end(),
                                   [&](const Body& other) { return other.name == load.body; });
    if (std::find(names.begin(), names.end(), load.body) == names.end()) {
      draft.reading.problems.add({indexed("load", i) + ".body",
                                  "this is not an elastic body that is free to move",
                                  names.empty() ? std::string("nothing: there is no such body")
                                                : fmt::format("{}", fmt::join(names, ", ")),
                                  "Name such a body, or remove the load"});
      continue;
    }
    if (load.kind == LoadKind::body_force || !load.region) continue;
    if (!surface_elements_within(*load.region, body->shape, result.dimension,
                                 element_size(*body, result.dimension, draft.effort.most_tested))
             .empty())
      continue;
    draft.reading.problems.add(
        {indexed("load", i) + ".shape",
         fmt::format("no part of the surface of the body \"{}\" lies in it", load.body),
         "a region that holds the face to be loaded",
         "Move or enlarge the shape, so that the face lies in it"});
  }
}

void write_load(TomlWriter& writer, const Load& load) {
  WrittenKeys others;
  if (load.region) others["shape"] = shape_text(writer, *load.region);
  writer.table("[[load]]", "load", load, others);
}

}  // namespace kerf
