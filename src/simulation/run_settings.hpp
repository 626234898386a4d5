// SPDX-License-Identifier: Apache-2.0
// The settings of a run: the input of the engines, as plain data in SI units. The engines are
// templates with long compile times; this file makes them independent of the data of cases
// (model/case.hpp), most of which they do not need.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/nozzle.hpp"
#include "geometry/solid_region.hpp"
#include "machine/travelling_frame.hpp"
#include "model/medium.hpp"
#include "model/water_scheme.hpp"
#include "particles/new_particle.hpp"
#include "simulation/media_order.hpp"
#include "simulation/motion.hpp"
#include "simulation/run_loads.hpp"

namespace kerf {

struct Case;

// Points at which pressure and velocity are sampled and averaged, or a plane across which forces
// are summed.
struct RunProbe {
  bool is_plane = false;
  Point position{};           // m
  Point normal{};             // unit vector, of a plane
  std::vector<Point> points;  // m; none of a plane
};

// A part of an absorbing face.
struct AbsorbingElement {
  Point position{};   // m, its middle
  double area = 0.0;  // m^2 (2D: m)
};

// A side of a body that absorbs waves.
struct AbsorbingSide {
  std::size_t source = 0;  // body
  int axis = 0;            // of the normal
  Box edges;               // m, the box of the body as far as symmetry planes leave it
  std::vector<AbsorbingElement> elements;
};

// A window of the workpiece that travels with the nozzle.
struct MovingWindow {
  TravellingFrame frame;
  std::vector<AbsorbingSide> absorbing;  // of every window but the first, in the place of that
  // Returns the solid of the window after some shifts, as laid out.
  std::function<std::vector<NewParticle>(std::uint64_t)> solid;

  // Returns the absorbing sides of the window after some shifts, from the second one on.
  std::vector<AbsorbingSide> absorbing_after(std::uint64_t shifts) const;
};

struct RunSettings {
  double end_time = 0.0;                 // s
  double courant = 0.45;                 // 1, factor of the acoustic limit
  double maximum_step = 0.0;             // s; 0 or infinity = none
  double relax_time = 0.0;               // s, until which solids are settled
  Point gravity{};                       // m/s^2
  Point domain_minimum{};                // m
  Point domain_maximum{};                // m
  std::array<bool, 3> mirror_minimum{};  // which faces of the domain are symmetry planes
  std::array<bool, 3> mirror_maximum{};
  std::vector<RunProbe> probes;
  bool removes_back_flow = false;  // whether water may be marked `erased`

  // Of the formulations.
  double smoothing_ratio = 1.3;             // h / spacing
  double artificial_stress = 0.0;           // 1, epsilon of Gray et al. (2001); 0 = off
  double artificial_stress_exponent = 4.0;  // 1
  WaterScheme water_scheme = WaterScheme::riemann;
  bool shifting = true;
  bool smooth_walls = false;
  int subcycles = 8;  // steps with the same bond forces, at most
  bool sleep = true;  // whether solid that nothing has reached is left out of the steps

  // The content. Vectors marked "per medium" have the order of media_order.hpp.
  std::vector<std::string> source_names;  // of bodies, then of jets, as in "body 'plate'"
  std::vector<Nozzle> nozzles;            // per jet
  Motion motion;
  std::vector<MediumOrigin> origins;     // per medium
  std::vector<Medium<double>> media;     // per medium
  std::vector<BondRegion> bond_regions;  // per medium; empty: no body has voids
  std::vector<AbsorbingSide> absorbing;
  std::optional<MovingWindow> window;
  std::vector<RunLoad> loads;
  std::vector<NewParticle> particles;  // of the start, in the order of their ids
};

// Lays out the particles of a case and collects the settings of its run. Throws UserError where the
// case cannot be built.
RunSettings run_settings(const Case& description);

}  // namespace kerf
