// SPDX-License-Identifier: Apache-2.0
// Runs a case with a jet that is a given factor faster, and prints the fastest particle and the
// error of the energy balance ten times on the way:
//   faster_jet CASE.toml FACTOR FOLDER
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <kerf/kerf.hpp>

namespace {

void print_state(const kerf::Simulation& simulation, const kerf::Frame& frame) {
  double fastest = 0.0;
  for (const auto& v : frame.velocity) fastest = std::max(fastest, std::hypot(v[0], v[1], v[2]));
  std::printf("%9.4f ms  %6zu particles  fastest %8.3f m/s  energy error %8.1e\n",
              1e3 * simulation.time(), simulation.particles(), fastest,
              simulation.balance().energy_drift());
}

void run(const char* file, double factor, const char* folder) {
  kerf::Case description = kerf::read_case(file);
  for (kerf::Jet& jet : description.jets) jet.speed *= factor;

  kerf::RunOptions options;
  options.folder = folder;
  options.replace = true;
  kerf::Run cut(description, file, options);
  for (int part = 1; part <= 10 && !cut.is_over(); ++part) {
    cut.until(0.1 * part * description.time.end);
    print_state(cut.simulation(), cut.frame());
  }
  cut.finish();
  std::printf("results: %s/report.html\n", folder);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    std::fprintf(stderr, "usage: faster_jet CASE.toml FACTOR FOLDER\n");
    return 2;
  }
  try {
    run(arguments[1], std::atof(arguments[2]), arguments[3]);
  } catch (const kerf::UserError& error) {
    std::fprintf(stderr, "faster_jet: %s\n", error.what());
    return error.exit_code();
  }
  return 0;
}
