// SPDX-License-Identifier: Apache-2.0
// Each limit of the time step applies in a case made for it, with the value of its formula; an
// invalid state is refused with particle, time and cause.
#include <cmath>
#include <limits>

#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

// A square of water of 1 mm or tofu of 2 mm, at rest.
Case square(Role role) {
  Case c = empty_case(2, PrecisionKind::double_precision);
  c.bodies = {body("square", role, box({0.0, 0.0, 0.0}, {0.01, 0.01, 0.0}),
                   role == Role::water ? 1e-3 : 2e-3)};
  return c;
}

StepInfo first_step(const Case& c) {
  const auto simulation = make_simulation(c);
  simulation->advance();
  EXPECT_NEAR(simulation->time(), simulation->last_step().dt, 1e-15);
  return simulation->last_step();
}

void expect_step(const Case& c, const std::string& limit, double dt) {
  const StepInfo step = first_step(c);
  EXPECT_EQ(step.limit, limit);
  EXPECT_NEAR(step.dt, dt, 1e-12 * dt);
}

// C h / (c + |v| + 1.2 A c).
TEST(TimeStep, AcousticInWater) {
  Case c = square(Role::water);
  expect_step(c, "acoustic (water)", 0.25 * 1.5e-3 / (50.0 + 1.2 * 0.01 * 50.0));
  c.time.courant = 0.1;
  c.bodies[0].velocity = {"3", "4", "0"};
  expect_step(c, "acoustic (water)", 0.1 * 1.5e-3 / (50.0 + 5.0 + 1.2 * 0.01 * 50.0));
}

TEST(TimeStep, AcousticInSolid) {
  const double k = 1e5 / (3.0 * 0.4), g = 1e5 / 2.6;
  const double fastest = std::sqrt((k + 4.0 / 3.0 * g) / 940.0), c_0 = std::sqrt(k / 940.0);
  expect_step(square(Role::elastic), "acoustic (solid)", 0.25 * 3e-3 / (fastest + 1.2 * 2.5 * c_0));
}

TEST(TimeStep, Acceleration) {
  Case c = square(Role::water);
  c.gravity = {0.0, -1e8, 0.0};
  expect_step(c, "acceleration", 0.25 * std::sqrt(1.5e-3 / 1e8));
}

TEST(TimeStep, Viscosity) {
  Case c = square(Role::water);
  c.materials[1].viscosity = 500.0;
  expect_step(c, "viscosity", 0.125 * 1.5e-3 * 1.5e-3 * 1000.0 / 500.0);
}

// A density may rise by (0.6 / C)^(1/3) - 1 in a step: water that runs together at a rate of 4e5
// 1/s.
TEST(TimeStep, Compression) {
  Case c = empty_case(2, PrecisionKind::double_precision);
  c.formulation = Formulation::standard;
  c.time.courant = 0.45;
  c.bodies = {body("square", Role::water, box({0.0, 0.0, 0.0}, {0.004, 0.004, 0.0}), 1e-3)};
  c.bodies[0].velocity = {"-2e5 * (x - 0.002)", "-2e5 * (y - 0.002)", "0"};
  const auto simulation = make_simulation(c);
  const Archive start = saved(*simulation);
  const auto& rates = std::get<std::vector<double>>(start.arrays.at("particles/compression_rate"));
  const double fastest = *std::max_element(rates.begin(), rates.end());
  EXPECT_GT(fastest, 1e5);
  EXPECT_LT(fastest, 4.2e5);
  simulation->advance();
  EXPECT_EQ(simulation->last_step().limit, "compression");
  const double rise = std::cbrt(0.6 / 0.45) - 1.0;
  EXPECT_NEAR(simulation->last_step().dt, rise / fastest, 1e-12 / fastest);
}

TEST(TimeStep, MaximumStep) {
  Case c = square(Role::water);
  c.time.maximum_step = 1e-6;
  expect_step(c, "maximum step", 1e-6);
}

// The last step ends the run exactly, for any small remaining time.
TEST(TimeStep, EndOfRun) {
  Case c = square(Role::water);
  c.time.end = 1e-7;
  expect_step(c, "end of run", 1e-7);
  c.time.end = 1e-4;
  const auto simulation = make_simulation(c);
  take_steps(*simulation, 1000);
  EXPECT_TRUE(simulation->finished());
  EXPECT_EQ(simulation->time(), 1e-4);
  EXPECT_LT(simulation->step(), 20u);
}

// The named particle is the moving one.
TEST(TimeStep, NamesTheParticle) {
  Case c = square(Role::water);
  c.bodies[0].velocity = {"x > 0.009 && y > 0.009 ? 1 : 0", "0", "0"};
  const auto simulation = make_simulation(c);
  const Frame frame = simulation->frame();
  simulation->advance();
  const std::size_t k =
      by_id(frame).at(static_cast<std::uint32_t>(simulation->last_step().limiting_id));
  EXPECT_EQ(frame.velocity[k][0], 1.0);
}

// Returns the error that ends a run; empty if it continues.
std::string refusal(Simulation& simulation, int steps) {
  try {
    take_steps(simulation, steps);
  } catch (const UserError& error) {
    EXPECT_EQ(error.exit_code(), exit_run_failed);
    return error.what();
  }
  return "";
}

// A run with `value` in one entry of a saved field, and the id of the particle of that entry.
struct Damage {
  std::string field;
  std::size_t particle, component;
  double value;
};
std::string refusal(const Case& c, const Damage& damage) {
  const auto simulation = make_simulation(c);
  take_steps(*simulation, 3);
  Archive archive = saved(*simulation);
  auto& entries = std::get<std::vector<double>>(archive.arrays.at("particles/" + damage.field));
  const auto& ids = std::get<std::vector<std::uint32_t>>(archive.arrays.at("particles/id"));
  const std::size_t place =
      static_cast<std::size_t>(std::find(ids.begin(), ids.end(), damage.particle) - ids.begin());
  entries.at(place * (entries.size() / ids.size()) + damage.component) = damage.value;
  const auto broken = make_simulation(c);
  broken->restore(archive);
  return refusal(*broken, 5);
}

void expect_in(const std::string& text, std::initializer_list<const char*> parts) {
  for (const char* part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(RunFailure, NotANumberStopsTheRun) {
  for (Role role : {Role::water, Role::elastic})
    for (const Damage& damage :
         {Damage{"velocity", 12, 0, nan}, Damage{"velocity", 12, 1, infinity},
          Damage{"compression", 12, 0, nan}})
      expect_in(refusal(square(role), damage),
                {"t = ", "step 3", "particle ", "body 'square'", "not a number", "time.courant"});
  expect_in(refusal(square(Role::elastic), {"shear", 12, 2, nan}), {"not a number"});
}

// The rates of its neighbours are not numbers either, but the invalid state is that of the
// particle.
TEST(RunFailure, NamesTheParticleThatBroke) {
  for (Role role : {Role::water, Role::elastic}) {
    expect_in(refusal(square(role), {"velocity", 12, 0, nan}), {"particle 12 of"});
    expect_in(refusal(square(role), {"compression", 12, 0, nan}), {"particle 12 of"});
  }
}

TEST(RunFailure, Runaway) {
  // Ten times the largest sound speed is 500 m/s.
  expect_in(refusal(square(Role::water), {"velocity", 15, 0, 600.0}),
            {"ten times", "particle 15 of body 'square'"});
}

// Compressions of -1 and less, in water and in solid, are named as the cause, not their
// consequences.
TEST(RunFailure, NegativeDensity) {
  for (Role role : {Role::water, Role::elastic})
    for (double compression : {-1.5, -1.0})
      expect_in(refusal(square(role), {"compression", 12, 0, compression}),
                {"density of zero or less", "particle 12 of"});
}

// A particle with an invalid position has not left the domain and must not be removed without an
// error.
TEST(RunFailure, NotANumberInAPosition) {
  expect_in(refusal(square(Role::water), {"position", 12, 1, nan}), {"not a number"});
}

// A user can cause this by a prescribed motion that is defined for a part of the run, of an elastic
// body and of a rigid body.
TEST(RunFailure, PrescribedMotionThatIsNotANumber) {
  Case c = square(Role::elastic);
  c.bodies[0].displacement = {"t < 0.00005 ? 0 : sqrt(-1)", "0", "0"};
  const auto simulation = make_simulation(c);
  expect_in(refusal(*simulation, 20), {"body 'square'", "not a number"});
  EXPECT_EQ(simulation->balance().mass_out, 0.0);
}
TEST(RunFailure, PrescribedMotionOfAPlateThatIsNotANumber) {
  Case c = square(Role::elastic);
  c.bodies.push_back(body("plate", Role::rigid, box({0.0, -0.004, 0.0}, {0.01, 0.0, 0.0}), 2e-3));
  c.bodies[1].displacement = {"0", "t < 0.00005 ? 0 : sqrt(-1)", "0"};
  const auto simulation = make_simulation(c);
  expect_in(refusal(*simulation, 20), {"body 'plate'", "not a number"});
}

TEST(RunFailure, ZeroTimeStep) {
  Case c = square(Role::water);
  c.gravity = {0.0, -1e20, 0.0};
  const auto simulation = make_simulation(c);
  try {
    simulation->advance();
    FAIL() << "not refused";
  } catch (const UserError& error) {
    EXPECT_EQ(error.exit_code(), exit_run_failed);
    expect_in(error.what(), {"needs a time step of", "acceleration"});
  }
}

// The scheme is of second order in time: half the step gives a quarter of the error, against a run
// of much finer steps.
TEST(Midpoint, IsOfSecondOrder) {
  const auto positions = [](double dt) {
    Case c = square(Role::elastic);
    c.materials[0].artificial_linear = c.materials[0].artificial_quadratic = 0.0;
    c.materials[0].failure_strain = 0.0;
    c.bodies[0].velocity = {"0.05*sin(300*y)", "0.05*sin(300*x)", "0"};
    c.time.maximum_step = dt;
    c.time.end = 64 * 1.6e-5;
    const auto simulation = make_simulation(c);
    take_steps(*simulation, 1000000);
    const Frame frame = simulation->frame();
    std::vector<double> values(2 * frame.id.size());
    for (std::size_t k = 0; k < frame.id.size(); ++k) {
      values[2 * frame.id[k]] = frame.position[k][0];
      values[2 * frame.id[k] + 1] = frame.position[k][1];
    }
    return values;
  };
  const auto error = [](const std::vector<double>& a, const std::vector<double>& b) {
    double square_sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) square_sum += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(square_sum);
  };
  const auto exact = positions(0.5e-6);
  const double coarse = error(positions(1.6e-5), exact), fine = error(positions(8e-6), exact);
  EXPECT_GT(coarse, 1e-10);  // otherwise the errors are rounding
  EXPECT_GT(coarse / fine, 3.6);
  EXPECT_LT(coarse / fine, 4.4);
}

}  // namespace
}  // namespace kerf::test
