// SPDX-License-Identifier: Apache-2.0
// This file implements kerf bench, which measures the speed of complete steps of cubes and of the
// tofu case in both formulations.
#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/embedded.hpp"
#include "core/error.hpp"
#include "core/version.hpp"
#include "engine/device.hpp"
#include "input/read.hpp"
#include "model/case.hpp"
#include "simd/instruction_set.hpp"

namespace kerf {
namespace {

struct BenchOptions {
  double seconds = 5.0;  // for each load
  MachineOptions machine;
  std::string json;
  std::vector<std::string> cases;  // files to time instead of the loads of the program
};

struct Load {
  std::string name;
  std::string text;  // of a case
};

struct Result {
  std::string name;
  std::size_t particles = 0;
  std::uint64_t steps = 0;
  double seconds = 0.0;
  double particle_steps = 0.0;     // per second
  double pair_interactions = 0.0;  // per second; each ordered pair of each pass counts
  double neighbours = 0.0;         // per particle, with the skin
  double bytes = 0.0;              // per particle, with the list
  std::vector<StageTime> stages;
};

constexpr std::string_view water_cube = R"toml(
title = "Bench: a falling cube of water, 30 x 30 x 30 particles"
dimension = 3
formulation = "{}"
[time]
end = "1 s"
[domain]
minimum = ["-15 mm", "-1 m", "-15 mm"]
maximum = ["45 mm", "45 mm", "45 mm"]
[materials.bench_water]
base = "water"
sound_speed = "20 m/s"
[[body]]
name = "water"
material = "bench_water"
shape = {{ type = "box", minimum = ["0 mm", "0 mm", "0 mm"], maximum = ["30 mm", "30 mm", "30 mm"] }}
spacing = "1 mm"
velocity = ["0 m/s", "-1 m/s", "0 m/s"]
)toml";

constexpr std::string_view elastic_cube = R"toml(
title = "Bench: a vibrating cube of tofu, 30 x 30 x 30 particles"
dimension = 3
formulation = "{}"
[time]
end = "1 s"
[[body]]
name = "block"
material = "tofu"
shape = {{ type = "box", minimum = ["0 mm", "0 mm", "0 mm"], maximum = ["30 mm", "30 mm", "30 mm"] }}
spacing = "1 mm"
velocity_expression = ["0.01*sin(200*y)", "0.01*sin(200*z)", "0.01*sin(200*x)"]
)toml";

std::vector<Load> standard_loads() {
  std::vector<Load> loads;
  for (const Formulation formulation : {Formulation::standard, Formulation::shinohara2004}) {
    const std::string name = formulation_name(formulation);
    loads.push_back({"water 3D, " + name, fmt::format(water_cube, name)});
    loads.push_back({"elastic 3D, " + name, fmt::format(elastic_cube, name)});
  }
  for (const EmbeddedText& text : case_templates())
    if (text.name == "tofu-5ms-standard" || text.name == "tofu-5ms")
      loads.push_back({std::string(text.name), std::string(text.text)});
  return loads;
}

Result measure(const Load& load, double seconds) {
  using Clock = std::chrono::steady_clock;
  const Case description =
      load.text.empty() ? read_case(load.name) : parse_case(load.text, load.name);
  const auto simulation = make_simulation(description);
  for (int warm_up = 0; warm_up < 3; ++warm_up) simulation->advance();
  Result result;
  result.name = load.name;
  const double pairs_before = simulation->pair_interactions();
  double particle_steps = 0.0;
  const auto start = Clock::now();
  while (result.seconds < seconds && !simulation->finished()) {
    simulation->advance();
    particle_steps += static_cast<double>(simulation->particles());
    ++result.steps;
    result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
  result.particles = simulation->particles();
  result.particle_steps = particle_steps / result.seconds;
  result.pair_interactions = (simulation->pair_interactions() - pairs_before) / result.seconds;
  result.neighbours = simulation->neighbours_per_particle();
  result.bytes = simulation->bytes_per_particle();
  result.stages = simulation->stage_times();
  return result;
}

nlohmann::json to_json(const Result& result) {
  nlohmann::json stages;
  for (const StageTime& stage : result.stages) stages[stage.name] = stage.seconds;
  return {{"name", result.name},
          {"particles", result.particles},
          {"steps", result.steps},
          {"seconds", result.seconds},
          {"particle_steps_per_second", result.particle_steps},
          {"pair_interactions_per_second", result.pair_interactions},
          {"neighbours_per_particle", result.neighbours},
          {"bytes_per_particle", result.bytes},
          {"stage_seconds", stages}};
}

void bench(const BenchOptions& options) {
  take_machine(options.machine);
  const int threads = threads_of(options.machine);
  const char* const instructions =
      options.machine.device == Device::gpu ? "general" : instruction_set_name();
  fmt::print("Kerf {}, {}, {} threads on {}\n", program_version, compiler_name(), threads,
             device_name());
  fmt::print(
      "Rates per step: one in the standard formulation, two (midpoint) in that of the paper. "
      "Instruction set: {}.\n\n",
      instructions);
  fmt::print("{:<25} {:>10} {:>7} {:>16} {:>18} {:>11} {:>11}\n", "load", "particles", "steps",
             "particle-steps/s", "pair interact./s", "neighbours", "bytes/part.");
  nlohmann::json results;
  std::vector<Load> loads;
  for (const std::string& file : options.cases) loads.push_back({file, ""});
  if (loads.empty()) loads = standard_loads();
  for (const Load& load : loads) {
    const Result r = measure(load, options.seconds);
    fmt::print("{:<25} {:>10} {:>7} {:>16.3e} {:>18.3e} {:>11.1f} {:>11.0f}\n", r.name, r.particles,
               r.steps, r.particle_steps, r.pair_interactions, r.neighbours, r.bytes);
    results.push_back(to_json(r));
  }
  if (options.json.empty()) return;
  std::ofstream file(options.json);
  file << nlohmann::json{{"version", program_version},
                         {"compiler", compiler_name()},
                         {"device", word_of(options.machine.device)},
                         {"processor", device_name()},
                         {"instruction_set", instructions},
                         {"threads", threads},
                         {"loads", results}}
              .dump(2)
       << '\n';
  if (!file.flush())
    throw UserError("cannot write " + options.json + "; give --json a file in a writable folder",
                    exit_files);
}

}  // namespace

void add_bench_command(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("bench", "Measure how fast this build runs on this machine");
  auto options = std::make_shared<BenchOptions>();
  command->add_option("CASE", options->cases, "case files to measure; default: built-in cases");
  command->add_option("--seconds", options->seconds, "Time per case, s")
      ->check(CLI::Range(0.1, 600.0))
      ->capture_default_str();
  add_machine_options(*command, options->machine);
  command->add_option("--json", options->json, "Also write the results to this file");
  command->callback([options] { bench(*options); });
}

}  // namespace kerf
