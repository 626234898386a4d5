// SPDX-License-Identifier: Apache-2.0
// What a case file says, as plain data in SI units. No behaviour lives here.
// Vertical is y in two and three dimensions; a two-dimensional case is a plane-strain slice whose
// masses, forces and energies are per metre of depth. Entries of `Point` beyond the dimension are
// 0.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/formulation.hpp"
#include "model/machine.hpp"
#include "model/material.hpp"
#include "model/mesh_shape.hpp"
#include "model/water_scheme.hpp"

namespace kerf {

// Each `..._words` lists the words that case files use for an enumeration, in its order.
enum class PrecisionKind { mixed, double_precision };
inline constexpr std::array<std::string_view, 2> precision_words{"mixed", "double"};

struct Box {
  Point minimum{};  // m
  Point maximum{};  // m
  bool operator==(const Box&) const = default;
};

// Sides of a box, such as those of the domain that are symmetry planes.
struct Faces {
  std::array<bool, 3> minimum{};  // x-, y-, z-
  std::array<bool, 3> maximum{};  // x+, y+, z+
  bool any() const { return *this != Faces{}; }
  bool operator==(const Faces&) const = default;
};
inline constexpr std::array<std::string_view, 6> face_words{"x-", "x+", "y-", "y+", "z-", "z+"};

// A region of space. `kind` selects which members hold.
//   box       minimum, maximum
//   disc      centre, radius; in 3D a cylinder along `axis` from `centre` with `length`
//   ring      centre, radius (outer), inner_radius; in 3D a tube along `axis` with `length`
//   polygon   vertices in (x, y); in 3D an extrusion from z = depth_minimum to depth_maximum
//   sphere    centre, radius (3D only)
//   join      the points in any of `parts`           (case files spell it "union")
//   difference  the points in parts[0] and in no other part
//   mesh      what the surface of `mesh` encloses (3D only)
struct Shape {
  enum class Kind { box, disc, ring, polygon, sphere, join, difference, mesh };
  Kind kind = Kind::box;
  Box box;
  Point centre{};
  Point axis{0.0, 0.0, 1.0};                    // unit vector
  double radius = 0.0;                          // m
  double inner_radius = 0.0;                    // m
  double length = 0.0;                          // m
  std::vector<std::array<double, 2>> vertices;  // m
  double depth_minimum = 0.0;                   // m
  double depth_maximum = 0.0;                   // m
  std::vector<Shape> parts;
  MeshShape mesh;
  bool operator==(const Shape&) const = default;
};
inline constexpr std::array<std::string_view, 8> shape_words{
    "box", "disc", "ring", "polygon", "sphere", "union", "difference", "mesh"};

enum class Role { elastic, water, rigid };
inline constexpr std::array<std::string_view, 3> role_words{"elastic", "water", "rigid"};
enum class Lattice { square, hexagonal };  // square is cubic in 3D
inline constexpr std::array<std::string_view, 2> lattice_words{"square", "hexagonal"};

// Which layer of a rigid body repels, eq. (43): the outermost one towards a side, or every side.
enum class RepellingLayer { top, bottom, left, right, front, back, all };
inline constexpr std::array<std::string_view, 7> repelling_layer_words{
    "top", "bottom", "left", "right", "front", "back", "all"};

// A body that is coarser further away from where it matters: its spacing doubles at the distances
// width, 2 width, ... from `around`, or from the water of the jets.
struct Grading {
  int levels = 0;               // how often the spacing doubles at most; 0 = the body is uniform
  double width = 0.0;           // m
  std::optional<Shape> around;  // distances are from its bounding box; none = from the jets
  // What follows from the jets of the case where `around` is none.
  struct Line {
    Point place{}, direction{};  // m, unit vector
    double radius = 0.0;         // m
    bool operator==(const Line&) const = default;
  };
  std::vector<Line> lines;
  bool operator==(const Grading&) const = default;
};

struct Body {
  std::string name;
  Role role = Role::elastic;
  int material = -1;  // index into Case::materials; -1 for rigid
  Shape shape;
  double spacing = 0.0;  // m
  Lattice lattice = Lattice::square;
  Point offset{};          // m, shift of the lattice origin
  Grading grading;         // `spacing` is the finest
  double jitter = 0.0;     // of the spacing, how far particles are taken off the lattice
  std::uint64_t seed = 1;  // of what is random in this body
  std::array<std::string, 3> velocity{"0", "0", "0"};  // m/s, expressions in x, y, z (m)
  double pressure = 0.0;                               // Pa, of water as laid out
  bool fixed = false;
  // Prescribed displacement from the initial place, m, expressions in t (s); empty = free.
  std::array<std::string, 3> displacement;
  Faces absorbing;        // those that let waves out (elastic only)
  std::string joined_to;  // name of a body this one is bonded to; empty = its own piece
  // Rigid bodies only, eq. (43).
  RepellingLayer repelling_layer = RepellingLayer::top;
  double repulsion = 0.0;                                     // D, m^2/s^2
  double friction = std::numeric_limits<double>::infinity();  // 1; infinity: the other decides
  bool operator==(const Body&) const = default;
};

// A jet leaves its nozzle at `position - standoff * direction` and flies along
// direction = (sin angle cos azimuth, -cos angle, sin angle sin azimuth). A nozzle that traverses
// moves from there at the time start + dwell on; its water moves with it until it has left.
struct Jet {
  std::string name;
  int material = -1;      // index into Case::materials, a water
  double speed = 0.0;     // m/s, mean over the section
  double width = 0.0;     // m, of a slot; diameter where the nozzle is round
  double length = 0.0;    // m, 3D: of a slot, at right angles to `across` of JetAxis; 0 = round
  Point position{};       // m, the point on the workpiece that the axis aims at
  double standoff = 0.0;  // m
  double angle = 0.0;     // rad, 0 = straight down
  double azimuth = 0.0;   // rad, 3D only
  double spacing = 0.0;   // m
  double start = 0.0;     // s
  double stop = 0.0;      // s; infinity = as long as the run lasts
  Point traverse{};       // m/s, velocity of the nozzle
  double dwell = 0.0;     // s, how long the nozzle stands still after `start`
  // Water flows for the first `duty` of each period; 0 = without pause.
  double pulse_frequency = 0.0;  // Hz
  double duty = 1.0;             // 1
  // Speed over the section, expression in r (0 on the axis, 1 at the edge), any scale: the mean is
  // normalised to `speed`. "1" = uniform.
  std::string profile = "1";
  bool operator==(const Jet&) const = default;
};

// Fig. 7 of Shinohara et al. (2004): water of a jet that flows back towards its nozzle is erased.
struct BackFlowRemoval {
  // Erased when v.direction < speed_fraction * jet speed; 0 = moves back in the room, the speed of
  // the water front over the jet's = moves back from the bottom of the crater.
  double speed_fraction = 0.0;
  bool operator==(const BackFlowRemoval&) const = default;
};

struct Probe {
  enum class Kind { point, plane };
  Kind kind = Kind::point;
  std::string name;
  Point position{};             // m
  Point normal{0.0, 1.0, 0.0};  // unit; plane only: force of the +normal side on the other side
  bool operator==(const Probe&) const = default;
};
inline constexpr std::array<std::string_view, 2> probe_words{"point", "plane"};

struct ArtificialStress {  // Gray, Monaghan & Swift (2001)
  double epsilon = 0.0;    // 1; 0 = off
  double exponent = 4.0;   // 1
  bool operator==(const ArtificialStress&) const = default;
};

struct Numerics {  // of the `standard` formulation
  WaterScheme water = WaterScheme::riemann;
  bool shifting = true;  // of water's particles, away from its surfaces
  int subcycles = 8;     // steps that go on with the same forces of bonds, at most
  bool operator==(const Numerics&) const = default;
};

struct TimeControl {
  double end = 0.0;           // s
  double courant = 0.25;      // 1, factor of the acoustic limit
  double maximum_step = 0.0;  // s; infinity = none
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
  std::vector<Jet> jets;           // the last one is the machine's, where there is one
  std::optional<Machine> machine;  // what was given instead of a jet
  std::optional<BackFlowRemoval> back_flow_removal;
  std::vector<Probe> probes;
  OutputControl output;
  bool operator==(const Case&) const = default;
};

}  // namespace kerf
