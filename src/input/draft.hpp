// SPDX-License-Identifier: Apache-2.0
// A case while its file is being read: values as written, references still by name.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "input/section.hpp"
#include "model/case.hpp"

namespace kerf {

enum class Quality { draft, normal, fine };
inline constexpr std::array<std::string_view, 3> quality_words{"draft", "normal", "fine"};

struct MaterialDraft {
  Material material;
  double sound_speed_factor = 0.0;  // 1; used while the speed of sound is 0
  bool equation_is_open = false;    // of state: it follows from the fastest speed
};

struct BodyDraft {
  Body body;
  std::string material;      // empty for a rigid body
  std::string path;          // of its table, for complaints
  std::string inclusion_of;  // name of the body around; empty = none
  bool has_repulsion = false;
  bool has_offset = false;
};

struct JetDraft {
  Jet jet;
  std::string material;
  std::string path;
};

struct Draft {
  Reading reading;
  Case result;  // bodies, jets, materials and defaults that follow from others come at the end
  std::map<std::string, MaterialDraft>
      materials;  // those of the case and those used of the library
  std::vector<BodyDraft> bodies;
  std::vector<JetDraft> jets;
  bool has_domain = false;
  Quality quality = Quality::normal;
};

void read_time(Draft& draft, Section& top);
void read_domain(Draft& draft, Section& top);
// [back_flow_removal], [artificial_stress] and [numerics].
void read_extras(Draft& draft, Section& top);
void read_materials(Draft& draft, Section& top);
// The material a body or jet names, taken from the library when the case has none of that name.
// Null, with the problem noted, when nobody knows it.
const MaterialDraft* use_material(Draft& draft, Section& section, const std::string& name);

// The same for a jet: what is no water is refused.
const MaterialDraft* use_water(Draft& draft, Section& section, const std::string& name);
// Refuses a duty without pulses. `frequency` in Hz.
void check_pulses(Section& section, double frequency, double duty);
// Notes corners of which the second is not beyond the first along each axis.
void refuse_empty_box(Section& section, const Box& box);

// Reads the file of a mesh.
void read_mesh(Section& section, Shape& shape);
Shape read_shape(Reading& reading, const toml::table& table, const std::string& path);
// Before bodies and times, which may follow from the jets.
void read_machine(Draft& draft, Section& top);
// How many particles of water lie across a jet.
int particles_across(Quality quality, int dimension);
// m; 0 without a jet. The spacing of bodies that give none.
double finest_jet_spacing(const Draft& draft);
// s; 0 without a machine. When the run ends if the case does not say.
double standard_end(const Draft& draft);
void read_bodies(Draft& draft, Section& top);
// Cuts the room of inclusions out of the bodies around them, and bonds them to these.
void place_inclusions(Draft& draft);
void read_jets(Draft& draft, Section& top);
void read_probes(Draft& draft, Section& top);
void read_output(Draft& draft, Section& top);

// Turns names into indices and computes the defaults that follow from the rest of the case: speeds
// of sound, repulsions, the domain.
void finish(Draft& draft);

// Notes bodies and jets of more particles than any machine holds. To be called before anything
// visits particles.
void check_counts(Draft& draft);
// Note what is wrong between the parts of a case: bodies that are empty, outside or overlap; jets
// that start outside or in a body or miss everything; probes outside.
void check_bodies(Draft& draft);
// Notes what a symmetry plane cannot mirror.
void check_symmetry(Draft& draft);
void check_jets(Draft& draft);
void check_probes(Draft& draft);

// A vector as a unit vector; one that already is to rounding stays as it is, bit for bit.
Point unit_vector(const Point& vector);
std::string indexed(std::string_view list, std::size_t index);  // "body[1]" for index 0

}  // namespace kerf
