// SPDX-License-Identifier: Apache-2.0
// Continuous inflow of a jet. Water leaves the nozzle in columns of equal area; each column emits
// particles of mass rho (A/N) d whenever it has travelled another spacing d, so that the mass that
// has entered differs from the integral of rho V A by less than a layer, and that remainder is
// carried to the next (`carried`).
#pragma once

#include <cstdint>
#include <vector>

#include "case/case.hpp"

namespace kerf {

struct InletParticle {
  Point position;  // m
  double speed;    // m/s, along the jet
};

class Nozzle {
 public:
  Nozzle(const Jet& jet, double water_density, int dimension);
  // Gives up the columns beyond symmetry planes of the domain, which are mirror images of others.
  void cut_at(const Faces& planes, const Box& domain);

  const Point& direction() const { return direction_; }
  const Point& exit() const { return exit_; }
  double particle_mass() const { return particle_mass_; }  // kg (2D: kg/m)
  double peak_speed() const;                               // m/s, of the fastest column
  std::size_t columns() const { return columns_.size(); }

  // How long the nozzle has been open at time t, s.
  double open_time(double time) const;

  // The water that stands in the nozzle at t = 0.
  std::vector<InletParticle> standing_water() const;
  // What has entered between the last call and `time`.
  std::vector<InletParticle> emit(double time);

  double mass_due(double time) const;  // kg, integral of rho V A
  double mass_emitted() const;         // kg

  const std::vector<std::uint64_t>& emitted() const { return emitted_; }
  void restore(std::vector<std::uint64_t> emitted) { emitted_ = std::move(emitted); }

 private:
  struct Column {
    Point offset;  // m, from the axis
    double speed;  // m/s
  };
  void lay_out_columns(const Jet& jet, int dimension);
  Point place(const Column& column, double along) const;

  static constexpr int layers_inside = 4;  // more than the support of 2 h = 3 d
  double spacing_, start_, stop_;
  double particle_mass_ = 0.0;
  Point direction_{}, exit_{};
  std::vector<Column> columns_;
  std::vector<std::uint64_t> emitted_;  // per column
};

}  // namespace kerf
