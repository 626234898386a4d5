// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "case/schema.hpp"

namespace kerf {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Range any{-infinity, infinity};
constexpr Range positive{0.0, infinity, true};
constexpr Range not_negative{0.0, infinity};
constexpr Range up_to(double maximum) {
  return {0.0, maximum, true};
}
constexpr Range from_zero_to(double maximum) {
  return {0.0, maximum};
}
constexpr Range within(double limit) {
  return {-limit, limit};
}

using enum ValueKind;

// clang-format off
constexpr Key table_of_keys[] = {
{"", "title", text, "", "", any, "", "", "One line that says what the case is"},
{"", "dimension", integer, "", "", {2, 3}, "", "", "2 = plane strain, everything per metre of depth; 3 = space. Vertical is y in both"},
{"", "formulation", word, "", "standard", any, "standard shinohara2004", "", "The equations: Riemann SPH for water with total Lagrangian SPH for solids, or those of Shinohara, Okabe & Nakayama (2004)"},
{"", "precision", word, "", "mixed", any, "mixed double", "", "mixed = positions in double, fields in single precision; double = all in double"},
{"", "smoothing_ratio", number, "", "1.5", {1.0, 3.0}, "", "shinohara2004", "Smoothing length over particle spacing, h / d"},
{"", "smoothing_ratio", number, "", "1.3", {1.0, 3.0}, "", "standard", "Smoothing length over particle spacing, h / d"},
{"", "gravity", vector, "m/s2", "0 m/s2", within(1e4), "", "", "Acceleration on every particle that is not rigid"},
{"", "quality", word, "", "normal", any, "draft normal fine", "", "How fine what gives no spacing is: 8, 12 or 20 particles of water across a jet in 2D, 6, 8 or 12 in 3D"},
{"", "time", table, "", "(with a [machine], long enough to cut through what resists little)", any, "", "", "How long the run is and how it steps"},
{"", "domain", table, "", "(around all bodies and jets)", any, "", "", "Where particles may be"},
{"", "materials", table, "", "(the library's)", any, "", "", "Materials of this case, by name"},
{"", "body", tables, "", "(none)", any, "", "", "Things made of particles at the start"},
{"", "machine", table, "", "(none)", any, "", "", "The setting of a water-jet machine, from which a jet follows"},
{"", "jet", tables, "", "(none)", any, "", "", "Nozzles that let water in"},
{"", "backflow_eraser", table, "", "(off)", any, "", "", "Erases jet water that flows back"},
{"", "probe", tables, "", "(none)", any, "", "", "Places where the run is measured"},
{"", "artificial_stress", table, "", "(off)", any, "", "shinohara2004", "Cure of the tensile instability"},
{"", "numerics", table, "", "(all defaults)", any, "", "standard", "How the equations of water are summed, and which steps solids take"},
{"", "output", table, "", "(all defaults)", any, "", "", "What is written, and when"},

{"time", "end", quantity, "s", "(must be given without a [machine]; else the jet's flight and 4 times the workpiece's height, at the jet's speed, or 4 jet widths of traverse)", up_to(1e6), "", "", "When the run ends"},
{"time", "courant", number, "", "0.25", up_to(1.0), "", "", "Factor of the acoustic limit of the time step"},
{"time", "maximum_step", quantity, "s", "none", positive, "", "", "Largest time step"},

{"domain", "minimum", vector, "m", "", within(1e8), "", "", "Lowest corner"},
{"domain", "maximum", vector, "m", "", within(1e8), "", "", "Highest corner"},
{"domain", "symmetry", faces, "", "(none)", any, "x- x+ y- y+", "2D+standard", "Faces of the domain that are symmetry planes: everything goes on beyond them as its mirror image"},
{"domain", "symmetry", faces, "", "(none)", any, "x- x+ y- y+ z- z+", "3D+standard", "Faces of the domain that are symmetry planes: everything goes on beyond them as its mirror image"},

{"materials", "base", name, "", "(none)", any, "", "", "Material of the library whose values stand where this one gives none"},
{"materials", "kind", word, "", "(that of the base)", any, "elastic water", "", "What the material is; needed where there is no base"},
{"materials", "density", quantity, "kg/m3", "", up_to(1e5), "", "", "Density at rest"},
{"materials", "youngs_modulus", quantity, "Pa", "", up_to(1e13), "", "elastic", "Young's modulus E"},
{"materials", "poisson_ratio", number, "", "", {-1.0, 0.5, true, true}, "", "elastic", "Poisson's ratio"},
{"materials", "failure_strain", number, "", "0", from_zero_to(10.0), "", "elastic", "Strain at which the material fractures: the equivalent strain of a particle, or in the standard formulation what the criterion says, at a bond; 0 = never"},
{"materials", "fracture_energy", quantity, "J/m2", "0 J/m2", from_zero_to(1e7), "", "elastic", "Energy that a crack takes per area, in place of a failure_strain: the strain then follows from the spacing. In the standard formulation only"},
{"materials", "elasticity", word, "", "neo_hookean", any, "neo_hookean st_venant_kirchhoff", "elastic+standard", "Law of elasticity; where the material flows it is Hencky's"},
{"materials", "plasticity", word, "", "(that of the base, or none)", any, "none von_mises johnson_cook drucker_prager", "elastic+standard", "Law by which it flows: a metal (von_mises, johnson_cook), or rock (drucker_prager)"},
{"materials", "criterion", word, "", "principal_strain", any, "principal_strain equivalent_strain principal_stress strain_energy crack_band grady_kipp", "elastic+standard", "What is compared with its limit at a bond: a strain or the energy stored by tension with the failure_strain, the largest principal stress with the tensile_strength; crack_band: softening from the failure_strain on that takes the fracture_energy; grady_kipp: damage by cracks that grow from flaws"},
{"materials", "tensile_strength", quantity, "Pa", "", positive, "", "principal_stress", "Largest principal stress that it bears"},
{"materials", "weibull_k", quantity, "m-3", "", positive, "", "grady_kipp", "k of the number k strain^m of flaws per volume that are active at a strain"},
{"materials", "weibull_m", number, "", "", {1.0, 100.0}, "", "grady_kipp", "m of the number k strain^m of flaws per volume"},
{"materials", "crack_speed_share", number, "", "0.4", up_to(1.0), "", "grady_kipp", "Speed at which cracks grow from flaws over that of longitudinal waves"},
{"materials", "flaw_depth", quantity, "m", "1 m", up_to(1e6), "", "grady_kipp", "Depth of a 2D slice whose flaws count; without a meaning in 3D"},
{"materials", "friction", number, "", "0", from_zero_to(10.0), "", "elastic+standard", "Coefficient of dry friction on other bodies; of two that touch, the lesser holds"},
{"materials", "yield_strength", quantity, "Pa", "", positive, "", "von_mises johnson_cook", "Stress at which it begins to flow; A of Johnson & Cook"},
{"materials", "hardening_modulus", quantity, "Pa", "0 Pa", not_negative, "", "von_mises", "Slope H of the strength over plastic strain"},
{"materials", "saturation_stress", quantity, "Pa", "0 Pa", not_negative, "", "von_mises", "Q of Voce's hardening Q [1 - exp(-strain / saturation_strain)]"},
{"materials", "saturation_strain", number, "", "1", positive, "", "von_mises", "Plastic strain of Voce's hardening"},
{"materials", "hardening_coefficient", quantity, "Pa", "0 Pa", not_negative, "", "johnson_cook", "B of Johnson & Cook"},
{"materials", "hardening_exponent", number, "", "1", {0.0, 10.0, true}, "", "johnson_cook", "n of Johnson & Cook"},
{"materials", "rate_coefficient", number, "", "0", from_zero_to(1.0), "", "johnson_cook", "C of Johnson & Cook"},
{"materials", "reference_rate", quantity, "1/s", "1 1/s", positive, "", "johnson_cook", "Strain rate at and below which the rate does not count"},
{"materials", "thermal_exponent", number, "", "1", {0.0, 10.0, true}, "", "johnson_cook", "m of Johnson & Cook"},
{"materials", "heat_capacity", quantity, "J/(kg K)", "0 J/(kg K)", not_negative, "", "von_mises johnson_cook", "Specific heat; 0 = plastic work warms nothing"},
{"materials", "heat_share", number, "", "0.9", from_zero_to(1.0), "", "von_mises johnson_cook", "Part of the plastic work that becomes heat (Taylor & Quinney)"},
{"materials", "temperature", quantity, "K", "0 K", not_negative, "", "johnson_cook", "Temperature at the start"},
{"materials", "reference_temperature", quantity, "K", "0 K", not_negative, "", "johnson_cook", "Temperature at and below which heat takes nothing off the strength"},
{"materials", "melting_temperature", quantity, "K", "0 K", not_negative, "", "johnson_cook", "Temperature at which no strength is left; 0 = temperature changes no strength"},
{"materials", "damage_d1", number, "", "0", any, "", "von_mises johnson_cook", "D1 of Johnson & Cook's plastic strain at failure"},
{"materials", "damage_d2", number, "", "0", any, "", "von_mises johnson_cook", "D2 of Johnson & Cook, before exp(D3 p/q)"},
{"materials", "damage_d3", number, "", "0", any, "", "von_mises johnson_cook", "D3 of Johnson & Cook, of the triaxiality"},
{"materials", "damage_d4", number, "", "0", any, "", "von_mises johnson_cook", "D4 of Johnson & Cook, of the rate"},
{"materials", "damage_d5", number, "", "0", any, "", "von_mises johnson_cook", "D5 of Johnson & Cook, of the temperature"},
{"materials", "least_plastic_failure", number, "", "0", from_zero_to(100.0), "", "von_mises johnson_cook", "Least plastic strain at failure that the D1 to D5 may give; 0 = no damage"},
{"materials", "cohesion", quantity, "Pa", "", not_negative, "", "drucker_prager", "Cohesion of Mohr & Coulomb, which the cone is fitted to: in plane strain in 2D, along the compressive meridian in 3D"},
{"materials", "friction_angle", quantity, "rad", "", {0.0, 1.5, false, true}, "", "drucker_prager", "Angle of internal friction"},
{"materials", "dilation_angle", quantity, "rad", "0 deg", {0.0, 1.5, false, true}, "", "drucker_prager", "Angle of dilation"},
{"materials", "tension_cut_off", quantity, "Pa", "none", not_negative, "", "drucker_prager", "Mean tension that it bears; none = the apex of the cone"},
{"materials", "viscosity", quantity, "Pa s", "0 Pa s", from_zero_to(1e6), "", "water", "Dynamic viscosity"},
{"materials", "equation_of_state", word, "", "(tait; shock_hugoniot where something moves faster than 150 m/s and neither a speed of sound nor an exponent is given)", any, "tait shock_hugoniot", "water+standard", "Pressure by the density: weakly compressible water, or one whose shocks run as in real water"},
{"materials", "sound_speed", quantity, "m/s", "(sound_speed_factor times the fastest speed; 1481 m/s with shock_hugoniot)", up_to(1e8), "", "water", "Speed of sound of the equation of state at rest"},
{"materials", "sound_speed_factor", number, "", "10", {1.0, 1000.0}, "", "tait", "Speed of sound over the fastest speed V of jets and bodies or, for water that falls, V = sqrt(2 g H), H = height of the water; eq. (18)"},
{"materials", "tait_exponent", number, "", "7", {1.0, 15.0, true}, "", "tait", "Exponent n of the equation of state, eq. (15)"},
{"materials", "hugoniot_slope", number, "", "1.975", {0.0, 10.0, true}, "", "shock_hugoniot", "s of the speed c + s u of a shock that leaves matter at the speed u behind"},
{"materials", "artificial_linear", number, "", "0.01", from_zero_to(10.0), "", "water", "A of the artificial viscosity, eq. (38)"},
{"materials", "artificial_linear", number, "", "2.5", from_zero_to(10.0), "", "elastic", "A of the artificial viscosity, eq. (38)"},
{"materials", "artificial_quadratic", number, "", "0", from_zero_to(10.0), "", "water", "B of the artificial viscosity, eq. (38)"},
{"materials", "artificial_quadratic", number, "", "2.5", from_zero_to(10.0), "", "elastic", "B of the artificial viscosity, eq. (38)"},
{"materials", "artificial_softening", number, "", "0.1", up_to(1.0), "", "", "C of the artificial viscosity, eq. (39)"},
{"materials", "source", text, "", "(the case file)", any, "", "", "Where the values come from"},

{"body", "name", name, "", "", any, "", "", "Name of the body, its own"},
{"body", "role", word, "", "(the kind of its material)", any, "elastic water rigid", "", "What the body is; rigid ones need no material"},
{"body", "material", name, "", "", any, "", "elastic water", "Name of a material of this case or of the library"},
{"body", "shape", table, "", "", any, "", "", "The region it fills"},
{"body", "spacing", quantity, "m", "(that of the finest jet; without a jet it must be given)", positive, "", "", "Distance of its particles, their diameter d"},
{"body", "lattice", word, "", "square", any, "square hexagonal", "", "How particles are laid out; square is cubic in 3D, hexagonal is close-packed in 3D"},
{"body", "offset", vector, "m", "0 m", any, "", "", "Shift of the lattice, at most one spacing along each axis"},
{"body", "grading", table, "", "(off: one spacing)", any, "", "elastic+standard rigid+standard", "Coarser particles further away from where it matters; `spacing` is the finest. For a square lattice without offset"},
{"body", "jitter", number, "", "0", from_zero_to(0.3), "", "elastic+standard water+standard", "How far particles are taken off the lattice at random, in spacings, before the layout is relaxed: neither cracks nor flows then find rows to run along"},
{"body", "seed", integer, "", "1", {0, 2147483647}, "", "elastic+standard water+standard", "Seed of what is random in this body"},
{"body", "velocity", vector, "m/s", "0 m/s", within(1e5), "", "elastic water", "Velocity at the start"},
{"body", "velocity_expression", expressions, "", "(velocity)", any, "", "elastic water", "Velocity at the start in m/s as formulas of x, y, z in m"},
{"body", "pressure", quantity, "Pa", "0 Pa", not_negative, "", "water+standard", "Pressure at the start: the water is laid out compressed"},
{"body", "fixed", flag, "", "false", any, "", "elastic rigid", "The particles stay where they are; a rigid body without a displacement_expression does anyway"},
{"body", "displacement_expression", expressions, "", "(free)", any, "", "elastic rigid", "Prescribed displacement in m as formulas of t in s, 0 at t = 0"},
{"body", "absorbing", faces, "", "(none)", any, "x- x+ y- y+", "2D+elastic+standard", "Faces of the body, a box, that let waves out, as if it went on without end"},
{"body", "absorbing", faces, "", "(none)", any, "x- x+ y- y+ z- z+", "3D+elastic+standard", "Faces of the body, a box, that let waves out, as if it went on without end"},
{"body", "joined_to", name, "", "(nothing)", any, "", "elastic", "Name of an elastic body that this one is bonded to, as one piece"},
{"body", "inclusion_of", name, "", "(nothing)", any, "", "elastic water", "Name of an elastic body that this one lies in: its room is cut out of that body, whose lattice it continues where both are square and of one spacing; what is elastic is also bonded to it"},
{"body", "repelling_layer", word, "", "top", any, "top bottom left right front back all", "rigid", "The outermost layer of particles that repels, eq. (43)"},
{"body", "friction", number, "", "none", from_zero_to(10.0), "", "rigid+standard", "Coefficient of dry friction; none = that of what slides on it"},
{"body", "repulsion", quantity, "m2/s2", "(the square of the fastest speed)", not_negative, "", "rigid", "Strength D of the repulsion, eq. (43)"},

{"grading", "levels", integer, "", "", {1, 4}, "", "", "How often the spacing doubles at most"},
{"grading", "width", quantity, "m", "", positive, "", "", "The spacing doubles beyond this distance, again beyond twice it, and so on"},
{"grading", "around", table, "", "(the water of the jets, along their whole axes)", any, "", "", "A shape; distances are from the box around it, of a union from those around its parts"},

{"shape", "type", word, "", "", any, "box disc ring polygon sphere union difference mesh", "", "Kind of shape; in 3D a disc is a cylinder, a ring a tube, a polygon an extrusion"},
{"shape", "minimum", vector, "m", "", within(1e6), "", "box", "Lowest corner"},
{"shape", "maximum", vector, "m", "", within(1e6), "", "box", "Highest corner"},
{"shape", "centre", vector, "m", "", within(1e6), "", "disc ring sphere", "Centre; of a cylinder or tube, the centre of its first end"},
{"shape", "radius", quantity, "m", "", up_to(1e6), "", "disc ring sphere", "Radius, of a ring the outer one"},
{"shape", "inner_radius", quantity, "m", "", up_to(1e6), "", "ring", "Inner radius"},
{"shape", "axis", vector, "", "(0, 0, 1)", any, "", "disc+3D ring+3D", "Direction of the axis, of any length"},
{"shape", "length", quantity, "m", "", up_to(1e6), "", "disc+3D ring+3D", "Length along the axis"},
{"shape", "vertices", vertices, "m", "", within(1e6), "", "polygon", "Corners (x, y) in order, either way round; the last joins the first"},
{"shape", "depth_minimum", quantity, "m", "", within(1e6), "", "polygon+3D", "Lowest z of the extrusion"},
{"shape", "depth_maximum", quantity, "m", "", within(1e6), "", "polygon+3D", "Highest z of the extrusion"},
{"shape", "parts", tables, "", "", any, "", "union difference", "Shapes; a union holds the points of any, a difference those of the first and no other"},
{"shape", "file", text, "", "", any, "", "mesh", "File of a closed surface of triangles, STL or OBJ; its path is seen from the folder of the case file"},
{"shape", "scale", quantity, "m", "1 mm", up_to(1e6), "", "mesh", "What one unit of the file is: STL has none"},
{"shape", "position", vector, "m", "0 m", within(1e6), "", "mesh", "Where the origin of the file comes to lie"},
{"shape", "rotation", vector, "rad", "0 rad", within(1e3), "", "mesh", "Angles by which the part is turned about x, then y, then z, before it is moved; [\"-90 deg\", \"0 deg\", \"0 deg\"] brings the z of a drawing upright"},
{"shape", "checksum", text, "", "(any file will do)", any, "", "mesh", "Of the bytes of the file, as case.used.toml has it: a file that was changed is refused"},

{"machine", "pressure", quantity, "Pa", "", up_to(1e9), "", "", "Pressure at the orifice, above that of the air"},
{"machine", "orifice_type", word, "", "sharp", any, "sharp conical slit fan", "", "Sharp: a round hole in a plate; conical: a round hole at the end of a cone; slit and fan: a flat jet, that of a fan opening"},
{"machine", "orifice_diameter", quantity, "m", "", up_to(1.0), "", "", "Diameter of the orifice; of a slit or fan, and in 2D, its width"},
{"machine", "orifice_length", quantity, "m", "", up_to(10.0), "", "slit+3D fan+3D", "Length of the orifice, at right angles to the traverse"},
{"machine", "cone_angle", quantity, "rad", "45 deg", {0.0, 1.5707963267948966, true}, "", "conical", "Angle between the wall of the cone and its axis"},
{"machine", "fan_angle", quantity, "rad", "", {0.0, 3.0, true}, "", "fan+3D", "Whole angle by which the sheet opens"},
{"machine", "velocity_coefficient", number, "", "0.98", up_to(1.0), "", "", "Speed of the jet over that without friction; 0.95 to 0.98 is usual"},
{"machine", "discharge_coefficient", number, "", "(the velocity_coefficient times the contraction of an ideal jet: 0.611 out of a plate)", up_to(1.0), "", "", "Flow over that of the whole orifice without friction"},
{"machine", "standoff", quantity, "m", "", from_zero_to(100.0), "", "", "Distance from the orifice to the workpiece, along the jet"},
{"machine", "coherent_length", quantity, "m", "(28.3 diameters of the jet)", up_to(1e6), "", "", "Distance up to which the air leaves the jet whole; beyond, a [model](theory/machine.md) breaks it up"},
{"machine", "position", vector, "m", "", within(1e6), "", "", "Point on the workpiece that the jet aims at, at the start"},
{"machine", "lead_angle", quantity, "rad", "0 deg", within(1.4), "", "", "How far the jet leans forwards along the traverse"},
{"machine", "tilt_angle", quantity, "rad", "0 deg", within(1.4), "", "3D", "How far the jet leans to the right of the traverse"},
{"machine", "traverse_speed", quantity, "m/s", "0 m/s", from_zero_to(1e4), "", "", "Speed of the nozzle over the workpiece"},
{"machine", "traverse_direction", vector, "", "(along x)", any, "", "", "Its direction, horizontal"},
{"machine", "dwell", quantity, "s", "0 s", not_negative, "", "", "How long the nozzle stands still before it traverses"},
{"machine", "pulse_frequency", quantity, "Hz", "0 Hz", not_negative, "", "", "Frequency of a pulsed jet; 0 = steady"},
{"machine", "duty", number, "", "1", up_to(1.0), "", "", "Part of each pulse in which water flows"},
{"machine", "spacing", quantity, "m", "(the jet's width at the workpiece over the particles that `quality` puts across it)", positive, "", "", "Distance of the water's particles"},
{"machine", "material", name, "", "water", any, "", "", "Name of a water of this case or of the library"},

{"jet", "name", name, "", "", any, "", "", "Name of the jet, its own"},
{"jet", "material", name, "", "water", any, "", "", "Name of a water of this case or of the library"},
{"jet", "speed", quantity, "m/s", "", up_to(1e4), "", "", "Mean speed over the section"},
{"jet", "width", quantity, "m", "", up_to(1e6), "", "2D slot", "Width of the slot of a two-dimensional jet, or of one in 3D that has a length; a jet in 3D without one is round and has a diameter"},
{"jet", "diameter", quantity, "m", "", up_to(1e6), "", "3D+round", "Diameter of the round jet; a jet in 2D is a slot and has a width"},
{"jet", "length", quantity, "m", "", up_to(1e6), "", "3D+slot", "Length of a slot, at right angles to the plane of the jet and the vertical; for a jet straight down along z"},
{"jet", "position", vector, "m", "", within(1e6), "", "", "Point on the workpiece that the axis of the jet aims at"},
{"jet", "standoff", quantity, "m", "", from_zero_to(1e6), "", "", "Distance from the nozzle to that point"},
{"jet", "angle", quantity, "rad", "0 deg", within(3.141592653589793), "", "", "Tilt from straight down, towards +x"},
{"jet", "azimuth", quantity, "rad", "0 deg", within(6.283185307179586), "", "3D", "Turn of the tilt about the vertical, from +x towards +z"},
{"jet", "spacing", quantity, "m", "(the width or diameter over the particles that `quality` puts across it)", positive, "", "", "Distance of its particles, their diameter d"},
{"jet", "start", quantity, "s", "0 s", not_negative, "", "", "When the water starts"},
{"jet", "stop", quantity, "s", "none", positive, "", "", "When the water stops"},
{"jet", "traverse", vector, "m/s", "0 m/s", within(1e4), "", "", "Velocity of the nozzle"},
{"jet", "dwell", quantity, "s", "0 s", not_negative, "", "", "How long the nozzle stands still after the start"},
{"jet", "pulse_frequency", quantity, "Hz", "0 Hz", not_negative, "", "", "Frequency of a pulsed jet; 0 = steady"},
{"jet", "duty", number, "", "1", up_to(1.0), "", "", "Part of each pulse in which water flows, from its start"},
{"jet", "profile", word, "", "uniform", any, "uniform parabolic power", "", "Speed over the section: uniform, parabolic 1 - r^2, or power (1 - r)^(1/7)"},
{"jet", "profile_expression", expression, "", "(profile)", any, "", "", "Speed over the section as a formula of r, 0 on the axis and 1 at the edge; only its shape counts"},

{"backflow_eraser", "speed_fraction", number, "", "0", from_zero_to(1.0), "", "", "Water is erased when its speed along the jet is less than this fraction of the jet speed: 0 = it moves back in the room; the front's speed over the jet's = it moves back from the bottom of the cut"},

{"probe", "name", name, "", "", any, "", "", "Name of the probe, its own"},
{"probe", "kind", word, "", "point", any, "point plane", "", "point = pressure and velocity there; plane = force of the side the normal points to on the other"},
{"probe", "position", vector, "m", "", within(1e6), "", "", "The point, or a point of the plane"},
{"probe", "normal", vector, "", "(0, 1, 0)", any, "", "plane", "Direction of the normal, of any length"},

{"artificial_stress", "epsilon", number, "", "0.3", from_zero_to(1.0), "", "", "Strength; 0 = off"},
{"artificial_stress", "exponent", number, "", "4", {0.0, 20.0, true}, "", "", "Exponent of the kernel ratio"},

{"numerics", "water", word, "", "riemann", any, "riemann delta_sph", "", "What acts between particles of water: Riemann solutions, or mean pressures with a diffusion of density and an artificial viscosity"},
{"numerics", "shifting", flag, "", "true", any, "", "", "Particles of water in motion are moved to where their neighbours are as dense on every side, but for three rows at its surfaces"},
{"numerics", "subcycles", integer, "", "8", {1, 64}, "", "", "How many steps of water and contact go on, at most, with the same forces within solids, which are looked at as often as their own waves ask for; 1 = at every step"},

{"output", "frame_interval", quantity, "s", "(end / 20)", positive, "", "", "Time between frames"},
{"output", "frame_times", quantities, "s", "(every frame_interval)", not_negative, "", "", "Times of the frames, instead of an interval"},
{"output", "picture_times", quantities, "s", "(0 and quarters of the run)", not_negative, "", "", "Times of the pictures"},
{"output", "series_interval", quantity, "s", "(end / 500)", positive, "", "", "Time between rows of series.csv"},
{"output", "checkpoint_interval", quantity, "s", "60 s", positive, "", "", "Time of the clock on the wall between checkpoints"},
};

constexpr SectionText sections[] = {
{"", "Top level", "The keys before the first table."},
{"time", "`[time]`", "Needed in every case without a `[machine]`."},
{"domain", "`[domain]`", "Particles that leave it are taken out and accounted for. Left out, it is the box around all bodies and nozzles, grown on every side by half its longest edge."},
{"materials", "`[materials.NAME]`", "One table for each material that the library (`kerf materials`) lacks, or that differs from it."},
{"body", "`[[body]]`", "One table for each body."},
{"grading", "`grading = { ... }` of a body", "Off unless the table is there. See [graded resolution](theory/graded_resolution.md)."},
{"shape", "`shape = { ... }` of a body", "Shapes nest: the `parts` of a union or difference are shapes."},
{"machine", "`[machine]`", "What an operator knows, instead of a `[[jet]]`: the jet and its numerics follow from it. See [machine](theory/machine.md)."},
{"jet", "`[[jet]]`", "A jet leaves its nozzle at `standoff` from `position` and flies towards it."},
{"backflow_eraser", "`[backflow_eraser]`", "Off unless the table is there. Used for Fig. 7 of Shinohara et al. (2004); it takes mass away."},
{"probe", "`[[probe]]`", "One table for each probe."},
{"artificial_stress", "`[artificial_stress]`", "Off unless the table is there. After Gray, Monaghan & Swift (2001)."},
{"numerics", "`[numerics]`", "Of the standard formulation. Everything has a default."},
{"output", "`[output]`", "Everything has a default."},
};
// clang-format on

}  // namespace

std::span<const Key> schema() {
  return table_of_keys;
}
std::span<const SectionText> schema_sections() {
  return sections;
}

}  // namespace kerf
