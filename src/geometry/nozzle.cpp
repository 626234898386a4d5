// SPDX-License-Identifier: Apache-2.0
#include "geometry/nozzle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/jet_direction.hpp"
#include "geometry/shapes.hpp"
#include "model/expression.hpp"
#include "model/jet.hpp"

namespace kerf {
namespace {

// Returns lattice points of the given parity about 0, in spacings: -1, 0, 1 or -1/2, 1/2.
std::vector<double> centred_row(int count) {
  std::vector<double> row;
  for (int k = 0; k < count; ++k) row.push_back(0.5 * (2 * k + 1 - count));
  return row;
}

// Returns the offsets of the cells that fill a slot; its length is 0 in 2D.
std::vector<std::array<double, 2>> slot_offsets(double width, double length, double spacing) {
  const int across = std::max(1, static_cast<int>(std::lround(width / spacing)));
  const int aside = std::max(1, static_cast<int>(std::lround(length / spacing)));
  std::vector<std::array<double, 2>> offsets;
  for (double k : centred_row(across))
    for (double n : centred_row(aside)) offsets.push_back({k * width / across, n * length / aside});
  return offsets;
}

// Returns the offsets in a round section: the lattice points inside, scaled so that N cells have
// the area of the section.
std::vector<std::array<double, 2>> disc_offsets(double diameter, double spacing) {
  const int count = std::max(1, static_cast<int>(std::lround(diameter / spacing)));
  const double radius = 0.5 * diameter / spacing;
  std::vector<std::array<double, 2>> offsets;
  for (double a : centred_row(count))
    for (double b : centred_row(count))
      if (std::hypot(a, b) <= radius || count == 1) offsets.push_back({a, b});
  const double area = std::numbers::pi * diameter * diameter / 4.0;
  const double scale = std::sqrt(area / static_cast<double>(offsets.size()));
  for (auto& offset : offsets) {
    offset[0] *= scale;
    offset[1] *= scale;
  }
  return offsets;
}

}  // namespace

Nozzle::Nozzle(const Jet& jet, double water_density, int dimension)
    : density_(water_density),
      spacing_(jet.spacing),
      start_(jet.start),
      stop_(jet.stop),
      dwell_(jet.dwell),
      holds_pressure_(jet.feed == Feed::pressure),
      slugs_(slugs_of(jet)),
      layer_time_(jet.spacing / jet.speed),
      traverse_(jet.traverse) {
  direction_ = jet_direction(jet);
  for (int a = 0; a < 3; ++a) first_exit_[a] = jet.position[a] - jet.standoff * direction_[a];
  lay_out_columns(jet, dimension);
  particle_mass_ =
      water_density * nozzle_area(jet, dimension) / static_cast<double>(columns_.size()) * spacing_;
  start_columns();
}

void Nozzle::start_columns() {
  pumps_.clear();
  for (const Column& column : columns_)
    pumps_.emplace_back(0.5 * density_ * column.speed * column.speed,
                        layers_inside * spacing_ / column.speed);
  emitted_.assign(columns_.size(), 0);
}

void Nozzle::cut_at(const Faces& planes, const Box& domain) {
  std::erase_if(columns_, [&](const Column& column) {
    return is_beyond(planes, domain, position(column, 0.0, 0.0));
  });
  start_columns();
}

void Nozzle::lay_out_columns(const Jet& jet, int dimension) {
  const JetAxes axes = axes_of(jet);
  const bool is_slot = dimension == 2 || jet.length > 0.0;
  const auto offsets = is_slot
                           ? slot_offsets(jet.width, dimension == 2 ? 0.0 : jet.length, jet.spacing)
                           : disc_offsets(jet.width, jet.spacing);
  const Expression profile(jet.profile, {"r"});
  double sum = 0.0;
  for (const auto& [u, w] : offsets) {
    Column column{};
    for (int a = 0; a < 3; ++a) column.offset[a] = u * axes.across[a] + w * axes.sideways[a];
    const double r = is_slot ? std::abs(u) : std::hypot(u, w);
    column.speed = profile.evaluate(std::min(1.0, 2.0 * r / jet.width));
    sum += column.speed;
    columns_.push_back(column);
  }
  const double mean = sum / static_cast<double>(columns_.size());
  for (Column& column : columns_) column.speed *= jet.speed / mean;
}

double nozzle_area(const Jet& jet, int dimension) {
  if (dimension == 2) return jet.width;
  return jet.length > 0.0 ? jet.width * jet.length : std::numbers::pi * jet.width * jet.width / 4.0;
}

double nozzle_columns(const Jet& jet, int dimension) {
  const double across = jet.width / jet.spacing + 1.0;
  if (dimension == 2) return across;
  return across * (jet.length > 0.0 ? jet.length / jet.spacing + 1.0 : across);
}

Jet coarsened(const Jet& jet, int dimension, double most) {
  Jet result = jet;
  const double columns = nozzle_columns(jet, dimension);
  if (columns <= most) return result;
  const double across = std::round(jet.width / jet.spacing);
  const double allowed = across / std::pow(columns / most, dimension == 2 ? 1.0 : 0.5);
  const double parity = std::fmod(across, 2.0);
  result.spacing = jet.width / std::max(1.0, 2.0 * std::floor(0.5 * allowed) + parity);
  return result;
}

double fastest_water(const Jet& jet, int dimension) {
  constexpr double most_columns = 2000.0, any_density = 1.0;
  if (jet.profile == Jet{}.profile) return jet.speed;
  const double fastest =
      Nozzle(coarsened(jet, dimension, most_columns), any_density, dimension).fastest();
  return std::isfinite(fastest) ? std::max(fastest, jet.speed) : jet.speed;
}

double entering_particles(const Jet& jet, int dimension, double end) {
  const double open = std::max(0.0, std::min(jet.stop, end) - jet.start) * jet.duty;
  return jet.speed * nozzle_area(jet, dimension) * open / std::pow(jet.spacing, dimension);
}

Slugs slugs_of(const Jet& jet) {
  if (!(jet.pulse_frequency > 0.0 && jet.duty < 1.0)) return {};
  const double layer = jet.spacing / jet.speed;  // s
  const double shortest =
      std::max(Slugs::least_slug * layer / jet.duty, Slugs::least_gap * layer / (1.0 - jet.duty));
  constexpr double rounding = 1.0 - 1e-9;
  Slugs slugs;
  slugs.merged = std::max(1.0, std::ceil(rounding * shortest * jet.pulse_frequency));
  slugs.period = slugs.merged / jet.pulse_frequency;
  slugs.layers = slugs.period * jet.duty / layer;
  return slugs;
}

double pulse_spacing(const Jet& jet) {
  const double way = jet.speed / jet.pulse_frequency;  // m, of the water in a period
  return way * std::min(jet.duty / Slugs::least_slug, (1.0 - jet.duty) / Slugs::least_gap);
}

double Nozzle::layers_until(double slug) const {
  return std::floor(slug * slugs_.layers + 0.5);
}

double Nozzle::open_time(double time) const {
  const double since_start = std::max(0.0, std::min(time, stop_) - start_);
  if (slugs_.period == 0.0) return since_start;
  const double slug = std::floor(since_start / slugs_.period);
  const double before = layers_until(slug), here = layers_until(slug + 1.0) - before;
  return before * layer_time_ + std::min(since_start - slug * slugs_.period, here * layer_time_);
}

bool Nozzle::is_between_slugs(double time) const {
  if (slugs_.period == 0.0 || time < start_ || time >= stop_) return false;
  const double slug = std::floor((time - start_) / slugs_.period);
  const double here = layers_until(slug + 1.0) - layers_until(slug);
  return time - start_ - slug * slugs_.period >= here * layer_time_;
}

bool Nozzle::is_open(double time) const {
  return time >= start_ && time < stop_ && !is_between_slugs(time);
}

double Nozzle::moving_time(double time) const {
  return std::max(0.0, time - start_ - dwell_);
}

Point Nozzle::exit(double time) const {
  Point p = first_exit_;
  for (std::size_t a = 0; a < 3; ++a) p[a] += moving_time(time) * traverse_[a];
  return p;
}

Point Nozzle::velocity(double time) const {
  return moving_time(time) > 0.0 ? traverse_ : Point{};
}

Point Nozzle::position(const Column& column, double along, double time) const {
  Point p = exit(time);
  for (std::size_t a = 0; a < 3; ++a) p[a] += column.offset[a] + along * direction_[a];
  return p;
}

std::vector<InletParticle> Nozzle::standing_water() const {
  std::vector<InletParticle> water;
  for (int layer = 0; layer < layers_inside; ++layer)
    for (std::size_t k = 0; k < columns_.size(); ++k)
      water.push_back({position(columns_[k], -(layer + 0.5) * spacing_, 0.0), columns_[k].speed,
                       static_cast<std::uint32_t>(k)});
  return water;
}

// A layer that is complete as a slug ends enters with the next slug, which it moves with.
std::vector<InletParticle> Nozzle::emit(double time) {
  std::vector<InletParticle> water;
  if (is_between_slugs(time)) return water;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const double come = travelled(k, time);
    // Particle n enters when the column has travelled (n + 1) d, behind the one before it.
    while (come >= static_cast<double>(emitted_[k] + 1) * spacing_) {
      const double along =
          come - static_cast<double>(emitted_[k] + 1) * spacing_ - (layers_inside - 0.5) * spacing_;
      water.push_back(
          {position(columns_[k], along, time), columns_[k].speed, static_cast<std::uint32_t>(k)});
      ++emitted_[k];
    }
  }
  return water;
}

bool Nozzle::is_uniform() const {
  return std::all_of(columns_.begin(), columns_.end(), [this](const Column& column) {
    return std::abs(column.speed - columns_.front().speed) <= 1e-9 * columns_.front().speed;
  });
}

double Nozzle::fastest() const {
  double fastest = 0.0;
  for (const Column& column : columns_) fastest = std::max(fastest, column.speed);
  return fastest;
}

double Nozzle::column_area() const {
  return particle_mass_ / (density_ * spacing_);
}

void Nozzle::respond(double time, double dt, std::span<const double> pressure) {
  const double open = open_time(time);
  for (std::size_t k = 0; k < pumps_.size(); ++k) pumps_[k].respond(open, dt, pressure[k]);
}

std::vector<double> Nozzle::pump_state() const {
  std::vector<double> state;
  for (const PumpLimit& pump : pumps_)
    for (const double number : pump.state()) state.push_back(number);
  return state;
}

void Nozzle::restore_pump(const std::vector<double>& state) {
  const auto numbers = static_cast<std::ptrdiff_t>(PumpLimit::state_length);
  auto next = state.begin();
  for (PumpLimit& pump : pumps_) {
    pump.restore({next, next + numbers});
    next += numbers;
  }
}

double Nozzle::mass_due(double time) const {
  double mass = 0.0;
  for (std::size_t k = 0; k < columns_.size(); ++k)
    mass += particle_mass_ * travelled(k, time) / spacing_;
  return mass;
}

double Nozzle::mass_held_back(double time) const {
  double mass = 0.0;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const double lost = open_time(time) - pumps_[k].flow_time(open_time(time));
    mass += particle_mass_ * columns_[k].speed * lost / spacing_;
  }
  return mass;
}

double Nozzle::mass_emitted() const {
  double mass = 0.0;
  for (std::uint64_t count : emitted_) mass += particle_mass_ * static_cast<double>(count);
  return mass;
}

}  // namespace kerf
