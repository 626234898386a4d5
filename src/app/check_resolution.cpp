// SPDX-License-Identifier: Apache-2.0
#include "app/check_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/jet_axis.hpp"
#include "geometry/fill.hpp"
#include "geometry/particle_estimate.hpp"
#include "geometry/shapes.hpp"
#include "machine/simulated_piece.hpp"
#include "model/case.hpp"
#include "output/pulse_flag.hpp"

namespace kerf {

namespace {

using Warnings = std::vector<std::string>;

constexpr double least_across_jet = 10.0;  // particles
constexpr double near_jet = 2.0;           // jet widths from the axis within which a cut forms
constexpr double cut_reach = 1.5;  // jet widths; in a slot the water flows back beside the jet
constexpr double rounding = 1.0 + 1e-6;

std::string length(double metres) {
  return fmt::format("{:.4g} m", metres);
}

std::string key_of(const Case& description, const Body& body, const std::string& key) {
  if (description.workpiece && body.name == workpiece_name)
    return key == "grading.width" ? "workpiece.grading_width" : "workpiece." + key;
  const auto index = &body - description.bodies.data();
  return fmt::format("body[{}].{} (\"{}\")", index + 1, key, body.name);
}

void warn_of_narrow_jets(const Case& description, Warnings& warnings) {
  for (std::size_t j = 0; j < description.jets.size(); ++j) {
    const Jet& jet = description.jets[j];
    const double across = jet.width / jet.spacing;
    if (across * rounding >= least_across_jet) continue;
    warnings.push_back(fmt::format(
        "jet[{}].spacing (\"{}\") = {}: the jet is {:.3g} particles wide. Recommended: {:g} "
        "or more, which "
        "resolve its stagnation pressure. Choose {} or less",
        j + 1, jet.name, length(jet.spacing), across, least_across_jet,
        length(jet.width / least_across_jet)));
  }
}

// Calls `look` for points of a tube around the axis of a jet, as long as the bounding box of a
// body.
template <class Look>
void look_along(const Box& box, const JetAxis& axis, double reach, const Look& look) {
  constexpr int along = 100, aside = 4;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    JetAxis::Vector3 x{};
    for (std::size_t a = 0; a < 3; ++a) x[a] = corner >> a & 1 ? box.maximum[a] : box.minimum[a];
    low = std::min(low, axis.depth(x));
    high = std::max(high, axis.depth(x));
  }
  low = std::max(low, -axis.standoff);
  const int most_sideways = axis.sideways == JetAxis::Vector3{} ? 0 : aside;
  for (int n = 0; n < along * (2 * aside + 1) * (2 * most_sideways + 1); ++n) {
    const int i = n / along % (2 * aside + 1) - aside;
    const int j = n / along / (2 * aside + 1) - most_sideways;
    Point x = axis.point_at(low + (n % along + 0.5) / along * (high - low), 0.0);
    for (std::size_t a = 0; a < 3; ++a)
      x[a] += reach / aside * (i * axis.across[a] + j * axis.sideways[a]);
    look(x);
  }
}

// A body, and its particles where they are few enough to be laid out.
struct LaidBody {
  const Body& body;
  std::vector<GradedParticle> particles;
};

// The particles stand on their lattice: it tells the levels, and takes far less time than a layout
// that is fitted to the surface.
LaidBody laid_out(const Body& body, int dimension) {
  const bool are_few = body.jitter == 0.0 && lattice_nodes(body, dimension) <= most_laid_nodes;
  if (!are_few) return {body, {}};
  Body on_lattice = body;
  on_lattice.body_fitted = false;
  return {body, fill_levels(on_lattice, dimension)};
}

// Returns the largest spacing of a body within `reach` of the axis of a jet.
double coarsest_near(const LaidBody& laid, int dimension, const JetAxis& axis, double reach) {
  const Body& body = laid.body;
  int level = -1;
  const auto note = [&](const GradedParticle& particle) {
    if (particle.level > level && axis.distance(particle.position) <= reach &&
        axis.depth(particle.position) > -axis.standoff)
      level = particle.level;
  };
  for (const GradedParticle& particle : laid.particles) note(particle);
  if (laid.particles.empty()) {
    look_along(bounding_box(body.shape, dimension), axis, reach, [&](const Point& point) {
      if (const auto particle = particle_at(body, dimension, point)) note(*particle);
    });
  }
  return level < 0 ? 0.0 : level_spacing(body, level);
}

void warn_of_coarse_solid(const Case& description, const LaidBody& laid, const Jet& jet,
                          Warnings& warnings) {
  const Body& body = laid.body;
  const JetAxis axis(jet, description.dimension);
  const double near = coarsest_near(laid, description.dimension, axis, near_jet * jet.width);
  if (near > jet.spacing * rounding)
    warnings.push_back(fmt::format(
        "{} = {}: within {} of the axis of \"{}\" the solid's spacing is {}, {:.3g} x that of the "
        "water. Recommended: at most {}, else water can pass between its particles. Choose that, "
        "or a "
        "wider "
        "grading",
        key_of(description, body, "spacing"), length(body.spacing), length(near_jet * jet.width),
        jet.name, length(near), near / jet.spacing, length(jet.spacing)));
  const double in_cut = coarsest_near(laid, description.dimension, axis, cut_reach * jet.width);
  if (in_cut > body.spacing * rounding)
    warnings.push_back(
        fmt::format("{} = {}: the spacing doubles within {} of the axis of \"{}\", where the cut "
                    "will be. Recommended: "
                    "the finest spacing that far. Choose a width of {} or more",
                    key_of(description, body, "grading.width"), length(body.grading.width),
                    length(cut_reach * jet.width), jet.name,
                    length(jet.width + std::sqrt(description.dimension) * 2.0 * body.spacing)));
}

void warn_of_thin_levels(const Case& description, const Body& body, Warnings& warnings) {
  if (body.grading.levels == 0) return;
  const double coarsest = level_spacing(body, body.grading.levels);
  const double least = least_level_width * description.smoothing_ratio * coarsest;
  if (body.grading.width * rounding >= least) return;
  warnings.push_back(
      fmt::format("{} = {}: particles of {} would interact across the next finer level. "
                  "Recommended: {} or more, two "
                  "smoothing lengths of the coarsest level. Choose that, or fewer levels than {}",
                  key_of(description, body, "grading.width"), length(body.grading.width),
                  length(coarsest), length(least), body.grading.levels));
}

}  // namespace

std::vector<std::pair<std::string, std::string>> particle_rows(const Case& description) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const Body& body : description.bodies) {
    const ParticleEstimate counts = estimated_particles(description, body);
    std::vector<std::string> levels;
    for (std::size_t level = 0; level < counts.levels.size(); ++level)
      levels.push_back(fmt::format("{:.0f} of {}", counts.levels[level],
                                   length(level_spacing(body, static_cast<int>(level)))));
    const double total = counts.total(), uniform = counts.uniform(description.dimension);
    const bool is_whole_box = body.grading.levels == 0 && body.shape.kind == Shape::Kind::box;
    std::string text = fmt::format("{}{}", counts.is_exact || is_whole_box ? "" : "about ",
                                   fmt::join(levels, ", "));
    if (counts.levels.size() > 1)
      text += fmt::format(": {:.0f} instead of {:.0f} ({:.0f}%)", total, uniform,
                          100.0 * total / uniform);
    rows.emplace_back(fmt::format("particles of \"{}\"", body.name), text);
  }
  return rows;
}

std::vector<std::string> resolution_warnings(const Case& description) {
  Warnings warnings;
  warn_of_narrow_jets(description, warnings);
  for (std::size_t j = 0; j < description.jets.size(); ++j)
    if (const auto text = merged_pulses(description, j)) warnings.push_back(*text);
  for (const Body& body : description.bodies) {
    warn_of_thin_levels(description, body, warnings);
    if (body.role != Role::elastic || description.jets.empty()) continue;
    const LaidBody laid = laid_out(body, description.dimension);
    for (const Jet& jet : description.jets) warn_of_coarse_solid(description, laid, jet, warnings);
  }
  return warnings;
}

}  // namespace kerf
