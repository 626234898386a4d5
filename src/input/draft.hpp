// SPDX-License-Identifier: Apache-2.0
// A draft is a case while its file is read: values as written, references by name.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "input/read.hpp"
#include "input/section.hpp"
#include "model/case.hpp"

namespace kerf {

enum class Quality { draft, normal, fine };
inline constexpr std::array<std::string_view, 3> quality_words{"draft", "normal", "fine"};

struct MaterialDraft {
  Material material;
  double sound_speed_factor = 0.0;  // 1; used while the sound speed is 0
  bool equation_is_open = false;    // whether the equation of state depends on the fastest speed
};

struct BodyDraft {
  Body body;
  std::string material;      // empty for a rigid body
  std::string path;          // of its table, for messages
  std::string inclusion_of;  // name of the body that contains this one; empty = none
  bool has_repulsion = false;
  bool has_offset = false;
  bool has_lattice_angle = false;
};

struct JetDraft {
  Jet jet;
  std::string material;
  std::string path;
};

struct WorkpieceDraft {
  WorkpieceSetting setting;
  std::string material;
  toml::table body;  // as a [[body]]
};

struct Draft {
  Reading reading;
  Case result;  // finish() sets bodies, jets, materials and the defaults that follow from others
  std::map<std::string, MaterialDraft> materials;  // of the case, and the used ones of the library
  std::vector<BodyDraft> bodies;
  std::vector<JetDraft> jets;
  WorkpieceDraft workpiece;
  bool has_domain = false;
  Quality quality = Quality::normal;
  ReadEffort effort = {};
  double after_cut = std::numeric_limits<double>::infinity();  // s, the default of [time]
};

void read_time(Draft& draft, Section& top);
void read_domain(Draft& draft, Section& top);
// Reads [back_flow_removal], [artificial_stress] and [numerics].
void read_extras(Draft& draft, Section& top);
void read_materials(Draft& draft, Section& top);
// Returns the material that a body or jet names, from the library if the case has none of that
// name. Reports an unknown material as a problem and returns null.
const MaterialDraft* use_material(Draft& draft, Section& section, const std::string& name);

// Does the same for a jet; refuses a material that is not water.
const MaterialDraft* use_water(Draft& draft, Section& section, const std::string& name);
// Refuses a duty without pulses, and pulses without a duty. `frequency` in Hz.
void check_pulses(Section& section, double frequency, double duty);
// Refuses a box whose second corner is not beyond the first along each axis.
void refuse_empty_box(Section& section, const Box& box);

// Reads the file of a mesh.
void read_mesh(Section& section, Shape& shape);
Shape read_shape(Reading& reading, const toml::table& table, const std::string& path);
// Reads [machine]. It must be called before bodies and times are read, which may follow from jets.
void read_machine(Draft& draft, Section& top);
// Reads [workpiece], chooses the simulated part, and makes a body of it; sets the domain and the
// motion of the nozzle. It must be called after [machine] and before bodies are read.
void read_workpiece(Draft& draft, Section& top);
// Refuse what a frame that travels with the nozzle cannot have: in the case, in the window that is
// chosen, and in [time].
void check_travel(Draft& draft, Section& top, Section& section);
void check_window(Draft& draft, Section& section);
void check_travelling_time(Draft& draft, Section& section);
// Returns the number of water particles across a jet.
int particles_across(Quality quality, int dimension);
// Returns the default spacing of bodies, m; 0 without a jet.
double finest_jet_spacing(const Draft& draft);
// Returns the default end time of the run, s; 0 without a machine.
double standard_end(const Draft& draft);
void read_bodies(Draft& draft, Section& top);
// Turns the lattices along faces, cuts the shapes of inclusions out of the bodies that contain
// them, and bonds them to these.
void place_inclusions(Draft& draft);
void read_loads(Draft& draft, Section& top);
void read_jets(Draft& draft, Section& top);
void read_probes(Draft& draft, Section& top);
void read_output(Draft& draft, Section& top);

// Converts names to indices and computes the defaults that follow from the rest of the case: sound
// speeds, repulsions, the domain.
void finish(Draft& draft);

// Returns the key of the file that `key` of a body is: of its own table, or of the [workpiece],
// whose size is the shape.
std::string body_key(const Draft& draft, std::size_t number, std::string_view key);
// Refuses bodies and jets with more particles than any computer can hold. It must be called before
// functions that visit particles.
void check_counts(Draft& draft);
// These functions report inconsistent parts of a case: bodies that are empty, outside the domain or
// overlap; jets that start outside the domain or in a body, or miss every body; probes outside the
// domain.
void check_bodies(Draft& draft);
// Refuses bodies that are joined to one that they do not touch.
void check_joints(Draft& draft);
// Refuses what is not symmetric about a symmetry plane.
void check_symmetry(Draft& draft);
void check_loads(Draft& draft);
void check_jets(Draft& draft);
// Refuses jets whose nozzles overlap at any time of the run.
void check_nozzles(Draft& draft);
void check_probes(Draft& draft);
// Refuses fracture limits at which a body would never break, or at rest.
void check_fracture(Draft& draft);

// Returns the unit vector of a vector; a vector that is one up to rounding is returned unchanged,
// bit for bit.
Point unit_vector(const Point& vector);
std::string indexed(std::string_view list, std::size_t index);  // "body[1]" for index 0

}  // namespace kerf
