// SPDX-License-Identifier: Apache-2.0
// Nozzle is the continuous inflow of a jet. Water leaves the nozzle in columns of equal area; each
// column emits particles of mass rho (A/N) d whenever it has travelled another spacing d, so that
// the emitted mass differs from the integral of rho V A by less than a layer, and that remainder is
// carried to the next layer. V is the speed of the column, times the share of it that the pressure
// at its exit leaves where the pump holds its pressure (geometry/pump_limit.hpp). A pulsed jet
// sends slugs of whole layers, so that the water stops between two layers and each leaves at full
// speed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/pump_limit.hpp"
#include "model/point.hpp"

namespace kerf {

struct Box;
struct Faces;
struct Jet;

struct InletParticle {
  Point position;  // m
  double speed;    // m/s, of its column without pressure at the exit
  std::uint32_t column = 0;
};

// Returns the area of the section, m^2 (2D: m).
double nozzle_area(const Jet& jet, int dimension);
// Returns the approximate number of columns.
double nozzle_columns(const Jet& jet, int dimension);
// Returns the speed of the fastest water of a jet, m/s: the largest of its profile at its
// particles.
double fastest_water(const Jet& jet, int dimension);
// Returns the jet with a spacing at which it has about `most` columns at most, and as many across,
// even or odd, as before.
Jet coarsened(const Jet& jet, int dimension, double most);
// Returns the approximate number of particles that a jet emits until the time `end`, s.
double entering_particles(const Jet& jet, int dimension, double end);

// The slugs of a pulsed jet. They are of whole layers, and as long as the particles can hold: at
// least `least_slug` layers of water and `least_gap` layers without follow each other. Where the
// pulses of the case are shorter, several of them come as one, with the same mean flow.
struct Slugs {
  static constexpr double least_slug = 2.0, least_gap = 1.0;
  double period = 0.0;  // s; 0 = a steady jet
  double merged = 1.0;  // pulses of the case in each
  double layers = 0.0;  // in each, on average
};
Slugs slugs_of(const Jet& jet);
// Returns the greatest spacing at which each pulse of a pulsed jet comes as a slug of its own, m.
double pulse_spacing(const Jet& jet);

class Nozzle {
 public:
  static constexpr int layers_inside = 4;  // of water at t = 0: more than the support of 2 h = 3 d

  Nozzle(const Jet& jet, double water_density, int dimension);
  // Removes the columns beyond symmetry planes of the domain, which are mirror images of others.
  void cut_at(const Faces& planes, const Box& domain);

  const Point& direction() const { return direction_; }
  double fastest() const;   // m/s, of all columns without pressure at the exit
  bool is_uniform() const;  // whether all columns have the same speed then
  // Return the position of the nozzle's exit at a time, m, and its velocity, m/s.
  Point exit(double time = 0.0) const;
  Point velocity(double time) const;
  double particle_mass() const { return particle_mass_; }  // kg (2D: kg/m)
  std::size_t columns() const { return columns_.size(); }

  // Return for how long water has flowed until the time, s, and whether it flows at the time.
  double open_time(double time) const;
  bool is_open(double time) const;
  // Returns how far the water of a column has come until the time, m.
  double travelled(std::size_t column, double time) const {
    return columns_[column].speed * pumps_[column].flow_time(open_time(time));
  }

  // The pump's reaction to the pressure at the exit of a column.
  const PumpLimit& pump(std::size_t column) const { return pumps_[column]; }
  bool holds_pressure() const { return holds_pressure_; }
  double column_area() const;  // m^2 (2D: m)
  // Takes the pressure on the water of each column over the step of `dt` s that ends at `time`, Pa.
  void respond(double time, double dt, std::span<const double> pressure);

  // Returns the particles inside the nozzle at t = 0.
  std::vector<InletParticle> standing_water() const;
  // Returns the particles that have entered between the last call and `time`, s.
  std::vector<InletParticle> emit(double time);

  double mass_due(double time) const;        // kg, integral of rho V A
  double mass_emitted() const;               // kg
  double mass_held_back(double time) const;  // kg, that would have come without pressure

  const std::vector<std::uint64_t>& emitted() const { return emitted_; }
  void restore(std::vector<std::uint64_t> emitted) { emitted_ = std::move(emitted); }
  std::vector<double> pump_state() const;  // of one column after the other
  void restore_pump(const std::vector<double>& state);

 private:
  struct Column {
    Point offset;  // m, from the axis
    double speed;  // m/s
  };
  void lay_out_columns(const Jet& jet, int dimension);
  // Returns the position of a column at the distance `along` the jet from the exit at `time`, m.
  Point position(const Column& column, double along, double time) const;
  double moving_time(double time) const;   // s
  void start_columns();                    // when they are laid out
  double layers_until(double slug) const;  // whole ones, in all slugs before this one
  bool is_between_slugs(double time) const;

  double density_;  // kg/m^3
  double spacing_, start_, stop_, dwell_;
  bool holds_pressure_;
  Slugs slugs_;
  double layer_time_;  // s, in which water of the mean speed advances by a layer
  double particle_mass_ = 0.0;
  Point direction_{}, first_exit_{}, traverse_{};
  std::vector<Column> columns_;
  std::vector<PumpLimit> pumps_;        // per column
  std::vector<std::uint64_t> emitted_;  // per column
};

}  // namespace kerf
