// SPDX-License-Identifier: Apache-2.0
// This file implements kerf check, which validates a case and prints the numbers that follow from
// it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "analysis/derived.hpp"
#include "app/check_json.hpp"
#include "app/check_warnings.hpp"
#include "app/checked_case.hpp"
#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/measured_pace.hpp"
#include "app/run_cost.hpp"
#include "core/error.hpp"
#include "engine/device.hpp"
#include "geometry/closed_surface.hpp"
#include "geometry/fill.hpp"
#include "geometry/particle_estimate.hpp"
#include "geometry/surface_fit.hpp"
#include "input/read.hpp"
#include "input/schema.hpp"
#include "machine/machine_jet.hpp"
#include "model/case.hpp"
#include "output/readable.hpp"
#include "output/result_reference.hpp"
#include "report/html.hpp"

namespace kerf {

namespace {

struct CheckOptions {
  std::string file;
  bool keys = false, metrics = false, schema = false;  // references to be printed instead
  bool no_timing = false, json = false;
  int ranks = 0;  // 0: no plan of ranks
  double latency = 1e6 * Network{}.latency, bandwidth = 1e-9 * Network{}.bandwidth;  // us, GB/s
  MachineOptions machine;
};

void row(const std::string& name, const std::string& value) {
  fmt::print("  {:<34} {}\n", name, value);
}

void print_speeds(const DerivedNumbers& numbers) {
  fmt::print("\nSpeeds\n");
  row("fastest jet or body, V", fmt::format("{:.4g} m/s", numbers.jet_speed));
  if (numbers.water_sound_speed > 0.0) {
    row("sound speed of the water, c", fmt::format("{:.4g} m/s", numbers.water_sound_speed));
    row("Mach number, V / c", fmt::format("{:.4g}", numbers.mach));
  }
  if (numbers.longitudinal_speed == 0.0) return;
  row("longitudinal waves, c_p", fmt::format("{:.4g} m/s", numbers.longitudinal_speed));
  row("shear waves, c_s", fmt::format("{:.4g} m/s", numbers.shear_speed));
  row("Rayleigh waves, c_R", fmt::format("{:.4g} m/s", numbers.rayleigh_speed));
  if (numbers.reflection_time > 0.0)
    row("waves reflected by an edge after", readable(numbers.reflection_time, "s"));
  row("V / c_R", fmt::format("{:.4g}", numbers.speed_over_rayleigh));
  row("V / c_p", fmt::format("{:.4g}", numbers.speed_over_longitudinal));
}

// Returns what a jet gives while its water flows, and the mean over its pulses if it has any.
std::string with_mean(double flowing, double share, const std::string& unit) {
  const std::string text = readable(flowing, unit);
  return share == 1.0 ? text
                      : fmt::format("{} while water flows, {} in the mean", text,
                                    readable(share * flowing, unit));
}

void print_machine(const Case& description) {
  if (!description.machine) return;
  const Machine& machine = *description.machine;
  const Jet& jet = description.jets.back();
  const auto& water = description.materials[static_cast<std::size_t>(machine.material)];
  const MachineNumbers numbers = machine_numbers(machine, water, description.dimension);
  const char* per_depth = description.dimension == 2 ? "/m" : "";
  fmt::print("\nMachine\n");
  row("pressure at the orifice", readable(machine.pressure, "Pa"));
  row("speed of the jet", fmt::format("{:.4g} m/s", numbers.speed));
  row("contraction, jet over orifice", fmt::format("{:.4g}", numbers.contraction));
  row("width of the jet behind the orifice", readable(numbers.diameter, "m"));
  const double share = machine.is_pulsed() ? machine.duty : 1.0;
  row("flow rate",
      with_mean(numbers.flow_rate * 6e4, share, html::flow_rate_unit(description.dimension)));
  row("power of the jet", with_mean(numbers.power, share, std::string("W") + per_depth));
  row("hammer pressure, real water", readable(numbers.hammer_pressure, "Pa"));
  row("width at the workpiece (model)", readable(numbers.diameter_at_workpiece, "m"));
  row("share of water there (model)", fmt::format("{:.4g}", numbers.water_share_at_workpiece));
  if (jet.pulse_frequency > 0.0)
    row("pulses",
        fmt::format("{}, water for {:.3g} of each", readable(jet.pulse_frequency, "Hz"), jet.duty));
}

void print_piece(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return;
  fmt::print("\nWhat is simulated\n");
  for (const std::string& sentence : sentences) fmt::print("  {}\n", sentence);
}

void print_loads(const DerivedNumbers& numbers) {
  fmt::print("\nLoads\n");
  if (numbers.stagnation_pressure > 0.0) {
    row("stagnation pressure, rho V^2 / 2", readable(numbers.stagnation_pressure, "Pa"));
    row(numbers.water_is_weakly_compressible ? "hammer pressure, rho c V"
                                             : "hammer pressure, rho (c + s V) V",
        readable(numbers.hammer_pressure_numerical, "Pa"));
    row("hammer pressure, c = 1481 m/s", readable(numbers.hammer_pressure_real, "Pa"));
  }
  if (numbers.contact_stress > 0.0)
    row("contact stress on the solid", readable(numbers.contact_stress, "Pa"));
  if (numbers.failure_strain > 0.0)
    row("failure strain of the solid", fmt::format("{:.4g}", numbers.failure_strain));
  if (numbers.resistance > 0.0) row("resistance of the solid", readable(numbers.resistance, "Pa"));
  if (numbers.cauchy_number > 0.0)
    row("Cauchy number, rho V^2 / E", fmt::format("{:.4g}", numbers.cauchy_number));
  if (numbers.hydrodynamic_front_speed > 0.0)
    row("front speed without strength",
        fmt::format("{:.4g} m/s", numbers.hydrodynamic_front_speed));
  row("regime", numbers.regime);
}

std::string simulated_time(const Case& description, const DerivedNumbers& numbers) {
  const std::string end = readable(description.time.end, "s");
  return numbers.likely_end < description.time.end
             ? fmt::format(
                   "{} where the jet passes as through a liquid, on which the following "
                   "numbers rest; else up to {}",
                   readable(numbers.likely_end, "s"), end)
             : end;
}

std::string particles_with_water(const Case& description, const DerivedNumbers& numbers) {
  const std::string likely = fmt::format("{}", numbers.particles_likely);
  return numbers.particles_likely < numbers.particles_expected
             ? fmt::format("{}; at most {} at one time up to {}, which the memory is for", likely,
                           numbers.particles_expected, readable(description.time.end, "s"))
             : likely;
}

void print_cost(const Case& description, const DerivedNumbers& numbers, const Pace& pace) {
  const RunCost cost = run_cost(numbers, pace);
  fmt::print("\nCost\n");
  for (const auto& [name, particles] : particle_rows(description)) row(name, particles);
  row("initial particles", fmt::format("{}", numbers.particles_initial));
  row("particles including jet water", particles_with_water(description, numbers));
  row("simulated time", simulated_time(description, numbers));
  row("time step", readable(numbers.time_step / pace.step_factor, "s"));
  row("steps",
      cost.steps < 1e12 ? fmt::format("{:.0f}", cost.steps) : fmt::format("{:.3g}", cost.steps));
  row("memory", fmt::format("{} of the process at its peak, of which {} are the particles",
                            readable(cost.memory, "B"), readable(cost.particle_memory, "B")));
  row("speed on this machine", fmt::format("{:.3g} particle-steps/s", 1.0 / pace.particle_step));
  row("run time", run_time_text(cost, pace));
}

// Returns the volume of the particles of a body, m^3.
double filled_volume(const Case& description, const Body& body) {
  const CountedSide everywhere;
  return estimate_particles(body, description.dimension, everywhere).uniform(3) *
         particle_volume(body, 3);
}

void print_meshes(const Case& description) {
  if (meshes_of(description).empty()) return;
  fmt::print("\nMeshes\n");
  for (const Body& body : description.bodies) {
    if (body.shape.kind != Shape::Kind::mesh) continue;
    const ClosedSurface& surface = *body.shape.mesh.surface;
    const double volume = surface.volume(), filled = filled_volume(description, body);
    const std::string shares = shares_volume(body, 3)
                                   ? std::string("its particles share this volume")
                                   : fmt::format("particles fill {:.4g} m3 ({:+.2f}%)", filled,
                                                 100.0 * (filled / volume - 1.0));
    row(body.name,
        fmt::format("{:.4g} m3 in {} triangles; {}", volume, surface.triangles(), shares));
  }
}

Pace pace_of(const CheckOptions& options, const CostedCase& costed, WallClock::time_point since) {
  const int threads = threads_of(options.machine);
  return options.no_timing
             ? typical_pace(costed.description, threads)
             : measured_pace(costed.description, costed.numbers, threads, limits_of_answer(since));
}

void print_numbers(const CheckedCase& checked) {
  const auto& [text, file, description, numbers, pace] = checked.costed;
  fmt::print("{}: {}.\n", file, verdict_of(checked));
  fmt::print("{} ({}D; bodies: {}, jets: {})\n", description.title, description.dimension,
             description.bodies.size(), description.jets.size());
  print_machine(description);
  print_piece(checked.piece);
  print_speeds(numbers);
  print_loads(numbers);
  print_meshes(description);
}

void print_cost_and_warnings(const CheckedCase& checked) {
  print_cost(checked.costed.description, checked.costed.numbers, checked.costed.pace);
  if (checked.ranks) fmt::print("{}", checked.ranks->text());
  fmt::print("{}", advice_text(checked.costed, checked.memory));
  if (!checked.warnings.empty()) fmt::print("\nWarnings\n");
  for (const auto& warning : checked.warnings) fmt::print("  - {}\n", warning);
}

void check(const CheckOptions& options) {
  const auto start = WallClock::now();
  take_machine(options.machine);
  CheckedCase checked = checked_case(case_text(options.file), options.file);
  if (options.ranks > 0 && options.machine.device == Device::gpu)
    throw UserError(fmt::format("--ranks {}: ranks do not compute on GPUs. Allowed: --device cpu. "
                                "Leave one of the options out.",
                                options.ranks),
                    exit_bad_input);
  if (options.ranks > 0) refuse_unplanned(checked.costed.description, options.file, options.ranks);
  if (!options.json) print_numbers(checked);
  checked.costed.pace = pace_of(options, checked.costed, start);
  if (options.ranks > 0)
    checked.ranks = rank_plan(checked.costed, options.ranks, threads_of(options.machine),
                              {1e-6 * options.latency, 1e9 * options.bandwidth});
  if (options.json)
    fmt::print("{}", check_json(checked));
  else
    print_cost_and_warnings(checked);
}

// Adds an option that takes a number between two others.
template <class Number>
CLI::Option* add_bounded(CLI::App& command, const std::string& name, Number& value, Number least,
                         Number most, const std::string& description) {
  const auto problem = [least, most](const std::string& text) {
    Number number{};
    if (CLI::detail::lexical_cast(text, number) && number >= least && number <= most)
      return std::string();
    return fmt::format(
        "\"{}\" is not a number from {} to {}. Allowed: {} to {}. Give one of these.", text, least,
        most, least, most);
  };
  const CLI::Validator is_bounded(problem, fmt::format("in [{} - {}]", least, most));
  return command.add_option(name, value, description)->check(is_bounded);
}

void add_rank_options(CLI::App& command, CheckOptions& options) {
  CLI::Option* ranks = add_bounded(command, "--ranks", options.ranks, 1, most_planned_ranks,
                                   "Plan the run for 1, 2, 4 ... ranks up to this number; needs a "
                                   "program of the preset mpi (docs/mpi.md)");
  add_bounded(command, "--latency", options.latency, 0.01, 1e6,
              "Time of a short message between ranks, in us")
      ->needs(ranks)
      ->capture_default_str();
  add_bounded(command, "--bandwidth", options.bandwidth, 1e-3, 1e5,
              "Rate at which a rank sends, in GB/s")
      ->needs(ranks)
      ->capture_default_str();
}

}  // namespace

void add_check_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("check",
                                             "Check a case and print its derived numbers, its cost "
                                             "and, where that is too much, what to change");
  auto options = std::make_shared<CheckOptions>();
  auto* file = command->add_option("case", options->file, "Case file (TOML)");
  command->add_flag("--no-timing", options->no_timing, "Estimate the run time without a pilot run");
  command->add_flag("--json", options->json, "Print JSON, in SI units, for programs");
  add_machine_options(*command, options->machine);
  add_rank_options(*command, *options);
  auto* keys =
      command->add_flag("--keys", options->keys, "Print the reference of all keys instead");
  auto* metrics = command->add_flag("--metrics", options->metrics,
                                    "Print the table of all metrics of result.json instead");
  auto* schema = command->add_flag("--result-schema", options->schema,
                                   "Print the JSON Schema of result.json instead");
  for (auto* reference : {keys, metrics, schema}) reference->excludes(file);
  command->callback([options] {
    if (options->keys)
      fmt::print("{}", keys_page());
    else if (options->metrics)
      fmt::print("{}", metrics_table());
    else if (options->schema)
      fmt::print("{}\n", result_schema().dump(2));
    else if (options->file.empty())
      throw CLI::RequiredError("case");
    else
      check(*options);
  });
}

}  // namespace kerf
