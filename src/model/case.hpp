// SPDX-License-Identifier: Apache-2.0
// This header declares the data of a case in SI units.
// Vertical is y in two and three dimensions; a two-dimensional case is a plane-strain slice whose
// masses, forces and energies are per metre of depth. Entries of `Point` beyond the dimension are
// 0.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/body.hpp"
#include "model/formulation.hpp"
#include "model/jet.hpp"
#include "model/load.hpp"
#include "model/machine.hpp"
#include "model/material.hpp"
#include "model/water_scheme.hpp"
#include "model/workpiece_setting.hpp"

namespace kerf {

// Each `..._words` lists the words that case files use for an enumeration, in its order.
enum class PrecisionKind { mixed, double_precision };
inline constexpr std::array<std::string_view, 2> precision_words{"mixed", "double"};

// Fig. 7 of Shinohara et al. (2004): water of a jet that flows back towards its nozzle is erased.
struct BackFlowRemoval {
  // Erased when v.direction < speed_fraction * jet speed; 0 = moves back in the room, the speed of
  // the water front over the jet's = moves back from the bottom of the crater.
  double speed_fraction = 0.0;
  bool operator==(const BackFlowRemoval&) const = default;
};

struct Probe {
  enum class Kind { point, plane, gauge };
  Kind kind = Kind::point;
  std::string name;
  Point position{};  // m
  // Unit; of a plane: force of the +normal side on the other side; of a gauge: that of its face.
  Point normal{0.0, 1.0, 0.0};
  double diameter = 0.0;  // m, of the face of a gauge
  bool is_plane() const { return kind == Kind::plane; }
  bool operator==(const Probe&) const = default;
};
inline constexpr std::array<std::string_view, 3> probe_words{"point", "plane", "gauge"};

struct ArtificialStress {  // Gray, Monaghan & Swift (2001)
  double epsilon = 0.0;    // 1; 0 = off
  double exponent = 4.0;   // 1
  bool operator==(const ArtificialStress&) const = default;
};

struct Numerics {  // of the `standard` formulation
  WaterScheme water = WaterScheme::riemann;
  bool shifting = true;      // of water's particles, away from its surfaces
  bool smooth_walls = true;  // walls act along the normals of their faces
  int subcycles = 8;         // steps that go on with the same forces of bonds, at most
  bool sleep = true;         // whether solid that nothing has reached is left out of the steps
  bool operator==(const Numerics&) const = default;
};

// What ends a run besides its end time: a cut that no longer changes along the path of the nozzle.
enum class RunStop { end, stationary };
inline constexpr std::array<std::string_view, 2> run_stop_words{"end", "stationary"};

struct TimeControl {
  double end = 0.0;           // s
  double courant = 0.45;      // 1, factor of the acoustic limit
  double maximum_step = 0.0;  // s; infinity = none
  // s, of the run after the cut-through; infinity = until the end.
  double after_cut = std::numeric_limits<double>::infinity();
  RunStop stop = RunStop::end;
  double stop_tolerance = 0.03;  // 1, change of a stationary cut
  double relax = 0.0;            // s, until which solids are settled by kinetic damping; 0 = never
  bool operator==(const TimeControl&) const = default;
};

struct OutputControl {
  std::vector<double> frame_times;    // s, ascending, VTKHDF frames
  std::vector<double> picture_times;  // s, ascending
  double series_interval = 0.0;       // s
  double checkpoint_interval = 60.0;  // s of wall time
  bool operator==(const OutputControl&) const = default;
};

struct Case {
  std::string title;
  int dimension = 2;
  Formulation formulation = Formulation::standard;
  PrecisionKind precision = PrecisionKind::mixed;
  TimeControl time;
  Point gravity{};               // m/s^2
  Box domain;                    // m; particles that leave it are removed and accounted for
  Faces symmetry;                // those of the domain that are symmetry planes
  double smoothing_ratio = 1.3;  // h / spacing
  ArtificialStress artificial_stress;
  Numerics numerics;
  std::vector<Material> materials;
  std::vector<Body> bodies;
  std::vector<Load> loads;         // on elastic bodies
  std::vector<Jet> jets;           // the last one is the machine's, where there is one
  std::optional<Machine> machine;  // what was given instead of a jet
  // What was given instead of a body: that is the first one.
  std::optional<WorkpieceSetting> workpiece;
  std::optional<BackFlowRemoval> back_flow_removal;
  std::vector<Probe> probes;
  OutputControl output;
  bool operator==(const Case&) const = default;
};

}  // namespace kerf
