// SPDX-License-Identifier: Apache-2.0
// Reads [machine], and computes the defaults that follow from a jet: spacings and the end time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/shapes.hpp"
#include "input/draft.hpp"
#include "input/sections.hpp"
#include "input/toml_writer.hpp"
#include "machine/jet_breakup.hpp"
#include "machine/machine_jet.hpp"
#include "machine/simulated_piece.hpp"
#include "machine/travelling_frame.hpp"
#include "model/case.hpp"

namespace kerf {

std::vector<Key> machine_keys() {
  using namespace key_range;
  using enum ValueKind;
  // clang-format off
  return {
      {"pressure", quantity, "Pa", "", up_to(1e9), {}, "", "Pressure at the orifice, above that of the air", stored_in<&Machine::pressure>},
      {"orifice_type", word, "", "sharp", any, orifice_words, "", "Sharp: a round hole in a plate; conical: a round hole at the end of a cone; slit and fan: a flat jet, which widens for a fan", stored_in<&Machine::orifice_type>},
      {"orifice_diameter", quantity, "m", "", up_to(1.0), {}, "", "Diameter of the orifice; of a slit or fan, and in 2D, its width", stored_in<&Machine::orifice_diameter>},
      {"orifice_length", quantity, "m", "", up_to(10.0), {}, "slit+3D fan+3D", "Length of the orifice, at right angles to the traverse", stored_in<&Machine::orifice_length>},
      {"cone_angle", quantity, "rad", "45 deg", {0.0, 1.5707963267948966, true}, {}, "conical", "Angle between the wall of the cone and its axis", stored_in<&Machine::cone_angle>},
      {"fan_angle", quantity, "rad", "", {0.0, 3.0, true}, {}, "fan+3D", "Opening angle of the sheet, from side to side", stored_in<&Machine::fan_angle>},
      {"velocity_coefficient", number, "", standard_velocity_coefficient, up_to(1.0), {}, "", "Speed of the jet over the frictionless speed; 0.95 to 0.98 is usual", stored_in<&Machine::velocity_coefficient>},
      {"discharge_coefficient", number, "", "(the velocity_coefficient times the contraction of an ideal jet: 0.611 out of a plate)", up_to(1.0), {}, "", "Flow rate over that of the full orifice area without friction", stored_in<&Machine::discharge_coefficient>},
      {"standoff", quantity, "m", "", from_zero_to(100.0), {}, "", "Distance from the orifice to the workpiece, along the jet", stored_in<&Machine::standoff>},
      {"coherent_length", quantity, "m", "(28.3 diameters of the jet)", up_to(1e6), {}, "", "Distance up to which the jet is intact in air; a [model](theory/machine.md) describes the breakup beyond it", stored_in<&Machine::coherent_length>},
      {"position", vector, "m", "(the middle of the upper face of the [workpiece]; without one it must be given)", within(1e6), {}, "", "Point on the workpiece that the jet aims at, at the start", stored_in<&Machine::position>},
      {"lead_angle", quantity, "rad", "0 deg", within(1.4), {}, "", "Inclination of the jet forwards along the traverse", stored_in<&Machine::lead_angle>},
      {"tilt_angle", quantity, "rad", "0 deg", within(1.4), {}, "3D", "Inclination of the jet to the right of the traverse", stored_in<&Machine::tilt_angle>},
      {"traverse_speed", quantity, "m/s", "0 m/s", from_zero_to(1e4), {}, "", "Speed of the nozzle over the workpiece", stored_in<&Machine::traverse_speed>},
      {"traverse_direction", vector, "", "(along x)", any, {}, "", "Direction of the traverse, horizontal", stored_in<&Machine::traverse_direction>},
      {"motion", word, "", "(auto with a [workpiece], else travelling)", any, nozzle_motion_words, "", "Whether the nozzle moves in the run; a standing one is simulated at rest, and the depth is [carried to the exposure](theory/exposure.md) of the traverse speed; auto = standing where the nozzle would move by less than its jet while the workpiece is passed", stored_in<&Machine::motion>},
      {"dwell", quantity, "s", "0 s", not_negative, {}, "", "Time before the traverse during which the nozzle does not move", stored_in<&Machine::dwell>},
      {"pulse_frequency", quantity, "Hz", "0 Hz", not_negative, {}, "", "Frequency of a pulsed jet, which needs a duty below 1; 0 = steady", stored_in<&Machine::pulse_frequency>},
      {"duty", number, "", "1", up_to(1.0), {}, "", "Share of each pulse period during which water flows", stored_in<&Machine::duty>},
      {"spacing", quantity, "m", "(the jet's width at the workpiece over the particles that `quality` puts across it)", positive, {}, "", "Distance of neighbouring water particles", stored_in<&Machine::spacing>},
      {"material", name, "", "water", any, {}, "", "Name of a water of this case or of the library", stored_in<&JetDraft::material>},
  };
  // clang-format on
}

namespace {

// Normalises the direction of the traverse, which is horizontal, and along x in 2D.
void resolve_direction(Section& section, Point& direction) {
  const double length = std::hypot(direction[0], direction[2]);
  const bool horizontal = direction[1] == 0.0;
  if (horizontal && length > 0.0) {
    direction = unit_vector(direction);
    return;
  }
  section.refuse("traverse_direction",
                 horizontal ? "the direction is zero" : "the direction is not horizontal",
                 "Correct the vector: y is the vertical", "a horizontal vector that is not 0");
  direction = {1.0, 0.0, 0.0};
}

void resolve_coefficients(Section& section, Machine& machine) {
  if (!section.has("discharge_coefficient"))
    machine.discharge_coefficient = machine.velocity_coefficient * standard_contraction(machine);
  if (machine.discharge_coefficient > machine.velocity_coefficient)
    section.refuse(
        "discharge_coefficient", "the jet would be wider than its orifice",
        "Lower it, or correct the velocity_coefficient",
        fmt::format("at most the velocity_coefficient, {:g}", machine.velocity_coefficient));
}

}  // namespace

int particles_across(Quality quality, int dimension) {
  static constexpr int in_plane[] = {8, 12, 20}, in_space[] = {6, 8, 12};
  const auto level = static_cast<std::size_t>(quality);
  return dimension == 2 ? in_plane[level] : in_space[level];
}

void read_machine(Draft& draft, Section& top) {
  const toml::table* written = top.table("machine");
  if (!written) return;
  Section section(draft.reading, *written, "machine", "machine");
  JetDraft entry;
  entry.path = "machine";
  section.read(entry);
  const MaterialDraft* water = use_water(draft, section, entry.material);
  Machine machine;
  section.read(machine);
  if (!section.has("position") && !top.has("workpiece"))
    section.refuse("position", "the key is missing", "Add it, or describe a [workpiece]");
  resolve_coefficients(section, machine);
  resolve_direction(section, machine.traverse_direction);
  if (!section.has("motion") && top.has("workpiece")) machine.motion = NozzleMotion::automatic;
  check_pulses(section, machine.pulse_frequency, machine.duty);
  section.refuse_unknown();
  if (!water || draft.reading.problems.any()) return;
  const int dimension = draft.reading.dimension;
  const auto numbers = [&] { return machine_numbers(machine, water->material, dimension); };
  if (!section.has("coherent_length"))
    machine.coherent_length = coherent_diameters * numbers().diameter;
  if (!section.has("spacing"))
    machine.spacing = numbers().diameter_at_workpiece / particles_across(draft.quality, dimension);
  entry.jet = machine_jet(machine, water->material, dimension);
  if (draft.reading.formulation == formulation_name(Formulation::standard))
    entry.jet.feed = Feed::pressure;
  draft.result.machine = machine;
  draft.jets.push_back(std::move(entry));
}

void write_machine(TomlWriter& writer, const Case& description) {
  const Machine& machine = *description.machine;
  writer.table("[machine]", "machine", machine,
               {{"material", material_text(description, machine.material)}});
}

double finest_jet_spacing(const Draft& draft) {
  double finest = 0.0;
  for (const JetDraft& entry : draft.jets)
    finest = finest > 0.0 ? std::min(finest, entry.jet.spacing) : entry.jet.spacing;
  return finest;
}

namespace {

// The contact is noticed when the front is so deep, in spacings of the jet.
constexpr double contact_spacings = 4.0;

// Returns the time after which a nozzle at rest shows what one that moves cuts, s: the last water
// of the exposure w / u goes on cutting until it is at the front, at most at the far face.
double end_of_exposure(const Machine& machine, const Jet& jet, double thickness, int dimension) {
  const double way =
      jet.standoff + thickness / std::cos(jet.angle) + contact_spacings * jet.spacing;
  return way / jet.speed + exposure_time(machine, jet, dimension);
}

}  // namespace

// A jet penetrates a material without strength at half its speed. The end time is twice the time of
// such a penetration, for workpieces with strength; for a moving nozzle it is the time for a
// traverse of four jet widths. A nozzle at rest over a [workpiece] has twice as long, because its
// run ends soon after a cut; in place of a moving one it then carries the depth over fewer decades.
double standard_end(const Draft& draft) {
  if (!draft.result.machine) return 0.0;
  const WorkpieceSetting& workpiece = draft.workpiece.setting;
  const bool travels = workpiece.frame == WorkpieceFrame::travelling;
  if (travels && draft.result.machine->traverse_speed == 0.0) return 0.0;  // refused already
  if (travels) return travelling_frame(workpiece, draft.jets.back().jet).end_time();
  const Jet& jet = draft.jets.back().jet;
  double low = jet.position[1], high = low;
  for (const BodyDraft& entry : draft.bodies) {
    if (entry.body.role != Role::elastic) continue;
    const Box around = bounding_box(entry.body.shape, draft.reading.dimension);
    low = std::min(low, around.minimum[1]);
    high = std::max(high, around.maximum[1]);
  }
  const double through = passage_time(jet, high - low);
  const Machine& machine = *draft.result.machine;
  const bool stands = machine.motion == NozzleMotion::standing && machine.traverse_speed > 0.0;
  if (stands || (draft.result.workpiece && machine.traverse_speed == 0.0))
    return std::min(2.0 * through,
                    end_of_exposure(machine, jet, high - low, draft.reading.dimension));
  const double speed = std::hypot(jet.traverse[0], jet.traverse[2]);
  const double along = speed > 0.0 ? jet.dwell + traverse_widths * jet.width / speed : 0.0;
  return std::max(through, along);
}

}  // namespace kerf
