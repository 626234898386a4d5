// SPDX-License-Identifier: Apache-2.0
// Reads and writes [[load]].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

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

// Returns a time within the run at which an expression is not finite, s. It is sampled, and where
// its magnitude has a peak between samples this is followed up to a pole.
std::optional<double> infinite_time(const Expression& expression, double end) {
  constexpr int samples = 2000, divisions = 200;
  constexpr double of_pole = 1e6;  // of the greatest sample
  const auto magnitude = [&](double t) { return std::abs(expression.evaluate(t)); };
  std::vector<double> values;
  for (int k = 0; k <= samples; ++k) {
    values.push_back(magnitude(k * end / samples));
    if (!std::isfinite(values.back())) return k * end / samples;
  }
  const double most = of_pole * std::max(1.0, *std::max_element(values.begin(), values.end()));
  for (std::size_t k = 1; k + 1 < values.size(); ++k) {
    const bool is_peak = values[k] >= values[k - 1] && values[k] >= values[k + 1] &&
                         (values[k] > values[k - 1] || values[k] > values[k + 1]);
    if (!is_peak) continue;
    double low = static_cast<double>(k - 1) * end / samples;
    double high = static_cast<double>(k + 1) * end / samples;
    for (int n = 0; n < divisions; ++n) {
      const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
      const double at_a = magnitude(a), at_b = magnitude(b);
      if (!(at_a <= most && at_b <= most)) return at_a <= most ? b : a;
      (at_a < at_b ? low : high) = at_a < at_b ? a : b;
    }
  }
  return std::nullopt;
}

void check_history(Draft& draft, const Load& load, const std::string& path) {
  const double end = draft.result.time.end;
  const auto time = infinite_time(Expression(load.history, {"t"}), end);
  if (!time) return;
  draft.reading.problems.add(
      {path + ".history", fmt::format("the factor is not finite at t = {:.6g} s", *time),
       fmt::format("an expression that is finite from t = 0 s to the end of the run, {:.6g} s",
                   end),
       "Correct it, such as \"min(t/1e-3, 1)\""});
}

}  // namespace

// Refuses loads on bodies that do not exist or cannot move, those whose region holds no part of the
// body, and those whose history is not finite.
void check_loads(Draft& draft) {
  const Case& result = draft.result;
  std::vector<std::string> names;
  for (const Body& body : result.bodies)
    if (body.role == Role::elastic && !body.fixed && body.displacement[0].empty())
      names.push_back(body.name);
  for (std::size_t i = 0; i < result.loads.size(); ++i) {
    const Load& load = result.loads[i];
    check_history(draft, load, indexed("load", i));
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
