// SPDX-License-Identifier: Apache-2.0
// Short runs of the `standard` formulation against conserved quantities: mass, momentum, and energy
// in runs without dissipation.
#include <algorithm>
#include <cmath>

#include "analysis/cut.hpp"
#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

// Returns the rounding error of sums over some hundred steps: forces are equal and opposite to the
// last digits.
double momentum_rounding(PrecisionKind precision) {
  return precision == PrecisionKind::mixed ? 1e-6 : 1e-10;
}

void expect_conserved(const Balance& now, PrecisionKind precision) {
  EXPECT_LE(std::abs(now.mass_error()), 1e-12);
  EXPECT_LE(now.momentum_error(), momentum_rounding(precision));
}

void print(const char* what, const Balance& now) {
  std::printf("%s: mass %.1e, momentum %.1e, energy %.2e\n", what, now.mass_error(),
              now.momentum_error(), now.energy_drift());
}

// A jet breaks a block on a plate, with gravity, back_flow_removal, a body with prescribed motion
// at the side and a drop that leaves the domain.
void run_everything(int dimension, PrecisionKind precision, int steps) {
  Case c = standard_jet_on_block(dimension, precision);
  c.back_flow_removal = BackFlowRemoval{};
  const double z = dimension == 3 ? 0.004 : 0.0;
  c.bodies.push_back(body("pusher", Role::elastic, box({-0.0118, 0.002, -z}, {-0.0098, 0.006, z}),
                          c.jets[0].spacing));
  c.bodies.back().displacement = {"0.5*t", "0", "0"};
  c.bodies.push_back(
      body("drop", Role::water, box({0.006, 0.02, -0.5 * z}, {0.01, 0.024, 0.5 * z}), 1e-3));
  c.bodies.back().velocity = {"4", "1", "0"};
  const auto simulation = make_simulation(c);
  Balance before = simulation->balance();
  for (int n = 0; n < steps; ++n) {
    simulation->advance();
    if (n % 10 != 0) continue;
    const Balance now = simulation->balance();
    ASSERT_GE(now.dissipated_artificial, before.dissipated_artificial);
    expect_conserved(now, precision);
    before = now;
  }
  const Balance now = simulation->balance();
  print("jet on block", now);
  EXPECT_GT(now.mass_in, 0.0);
  EXPECT_GT(now.mass_out, 0.0);
  EXPECT_GT(now.dissipated_fracture, 0.0);  // bonds broke
  EXPECT_NE(now.work_constraint, 0.0);
  EXPECT_GT(now.impulse_rigid[1], 0.0);
}
TEST(StandardBalance, AllTermsMixed2D) {
  run_everything(2, PrecisionKind::mixed, 900);
}
TEST(StandardBalance, AllTermsDouble2D) {
  run_everything(2, PrecisionKind::double_precision, 900);
}
TEST(StandardBalance, AllTermsMixed3D) {
  run_everything(3, PrecisionKind::mixed, 500);
}
TEST(StandardBalance, AllTermsDouble3D) {
  run_everything(3, PrecisionKind::double_precision, 500);
}

// Two joined jittered blocks, a third on top and one beside them, on a plate: in the initial layout
// no body exerts a force on another, and no bond is strained. Nothing moves, to the last bit.
TEST(StandardBalance, JitteredInitialLayoutIsAtRest) {
  for (const int dimension : {2, 3}) {
    Case c = empty_case(dimension, PrecisionKind::mixed);
    c.formulation = Formulation::standard;
    c.smoothing_ratio = 1.3;
    const double z = dimension == 3 ? 0.005 : 0.0;
    c.bodies = {body("left", Role::elastic, box({-0.01, 0.0, -z}, {0.0, 0.01, z}), 1e-3),
                body("right", Role::elastic, box({0.0, 0.0, -z}, {0.01, 0.01, z}), 1e-3),
                body("top", Role::elastic, box({-0.01, 0.01, -z}, {0.01, 0.015, z}), 1e-3),
                body("beside", Role::elastic, box({0.01, 0.0, -z}, {0.015, 0.01, z}), 1e-3),
                body("plate", Role::rigid, box({-0.02, -0.004, -z}, {0.02, 0.0, z}), 1e-3)};
    c.bodies[1].joined_to = "left";
    for (std::size_t b = 0; b < 4; ++b) {
      c.bodies[b].jitter = 0.3;
      c.bodies[b].seed = b;
    }
    const auto simulation = make_simulation(c);
    take_steps(*simulation, 20);
    const Balance now = simulation->balance();
    EXPECT_EQ(now.kinetic, 0.0) << dimension;
    EXPECT_EQ(now.elastic_strain, 0.0) << dimension;
  }
}

// Momentum, mass and kinetic energy equal independent sums over a frame.
TEST(StandardBalance, AgreesWithTheFrame) {
  const auto simulation =
      make_simulation(standard_jet_on_block(2, PrecisionKind::double_precision));
  take_steps(*simulation, 500);
  const Frame frame = simulation->frame();
  const Balance balance = simulation->balance();
  const std::vector<double> mass{940.0 * 25e-8, 0.0, 1000.0 * 25e-8};
  double total = 0.0, kinetic = 0.0, fractured = 0.0;
  std::array<double, 3> momentum{};
  for (std::size_t k = 0; k < frame.id.size(); ++k) {
    const double m = mass[frame.source[k]];
    total += m;
    if (frame.category[k] == Category::fractured) fractured += m;
    for (std::size_t a = 0; a < 3; ++a) {
      const double v = frame.velocity[k][a];
      kinetic += 0.5 * m * v * v;
      momentum[a] += m * v;
    }
  }
  EXPECT_NEAR(balance.mass_now, total, 1e-12 * total);
  EXPECT_NEAR(balance.mass_fractured, fractured, 1e-12 * total);
  EXPECT_NEAR(balance.kinetic, kinetic, 1e-12 * kinetic);
  for (std::size_t a = 0; a < 3; ++a)
    EXPECT_NEAR(balance.momentum_now[a], momentum[a], 1e-12 * balance.momentum_scale);
}

// A block leaves the domain edge first, row by row; the remaining rows continue to move. At the end
// no particle is left.
void fly_out(int dimension, PrecisionKind precision, double failure_strain) {
  Case c = empty_case(dimension, precision);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  c.materials[0].failure_strain = failure_strain;
  const double z = dimension == 3 ? 0.003 : 0.0;
  c.domain = {{-0.02, -0.02, -0.02}, {0.01, 0.02, 0.02}};
  c.bodies = {body("block", Role::elastic, box({-0.006, 0.0, 0.0}, {0.006, 0.006, z}), 1e-3)};
  c.bodies[0].velocity = {"4+300*y", "100*(x+0.004)", "0"};  // with rotation and shear
  const auto simulation = make_simulation(c);
  const double mass = simulation->balance().mass_now;
  bool half_way = false;
  while (simulation->particles() > 0 && simulation->time() < 0.02) {
    simulation->advance();
    const Balance now = simulation->balance();
    ASSERT_LE(std::abs(now.mass_error()), 1e-12);
    ASSERT_LE(now.momentum_error(), momentum_rounding(precision));
    half_way = half_way || (now.mass_out > 0.3 * mass && now.mass_out < 0.7 * mass);
  }
  const Balance end = simulation->balance();
  print("flown out", end);
  EXPECT_TRUE(half_way);
  EXPECT_EQ(simulation->particles(), 0u);
  EXPECT_NEAR(end.mass_out, mass, 1e-12 * mass);
  EXPECT_LE(std::abs(end.energy_drift()), 0.05);
  EXPECT_EQ(simulation->frame().id.size(), 0u);
}
TEST(StandardBalance, SolidLeavesTheDomain) {
  for (int dimension : {2, 3})
    for (PrecisionKind precision : both_precisions)
      for (double failure_strain : {0.0, 0.05}) fly_out(dimension, precision, failure_strain);
}

// No force acts across a plane through a freely falling block, because gravity is not a force of
// one side of the plane on the other. The block is not supported or loaded.
TEST(StandardProbes, NoForceAcrossAPlaneInFreeFall) {
  for (PrecisionKind precision : both_precisions) {
    Case c = empty_case(2, precision);
    c.formulation = Formulation::standard;
    c.smoothing_ratio = 1.3;
    c.gravity = {0.0, -9.81, 0.0};
    c.bodies = {body("block", Role::elastic, box({0.0, 0.0, 0.0}, {0.01, 0.01, 0.0}), 1e-3),
                body("drop", Role::water, box({-0.02, 0.0, 0.0}, {-0.01, 0.01, 0.0}), 1e-3)};
    Probe plane;
    plane.name = "plane";
    plane.kind = Probe::Kind::plane;
    plane.position = {0.0, 0.005, 0.0};
    c.probes = {plane};
    const auto simulation = make_simulation(c);
    take_steps(*simulation, 50);
    const double weight = 9.81 * (940.0 + 1000.0) * 1e-4;  // N/m
    // The error is the rounding of coordinates of 0.01 m in double over bonds of 1 mm, times moduli
    // of 1e5 Pa.
    const double digits = precision == PrecisionKind::mixed ? 1e-5 : 1e-9;
    for (const double force : simulation->probe_values()) EXPECT_NEAR(force, 0.0, digits * weight);
    EXPECT_LT(simulation->balance().momentum_now[1], 0.0);
  }
}

// A block is compressed uniformly by its initial velocity: the pressure of a probe inside it is
// that of the surrounding particles of the frame.
TEST(StandardProbes, PointInASolidShowsItsPressure) {
  Case c = empty_case(2, PrecisionKind::double_precision);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  c.materials[0].failure_strain = 0.0;
  c.bodies = {body("block", Role::elastic, box({-0.01, -0.01, 0.0}, {0.01, 0.01, 0.0}), 1e-3)};
  c.bodies[0].velocity = {"-50*x", "-50*y", "0"};
  Probe point;
  point.name = "point";
  c.probes = {point};
  const auto simulation = make_simulation(c);
  take_steps(*simulation, 10);
  const double shown = simulation->probe_values()[0];
  const Frame frame = simulation->frame();
  double least = 1e300, greatest = 0.0;
  for (std::size_t k = 0; k < frame.id.size(); ++k) {
    if (std::hypot(frame.position[k][0], frame.position[k][1]) > 2.7e-3) continue;  // 2 h
    least = std::min(least, static_cast<double>(frame.pressure[k]));
    greatest = std::max(greatest, static_cast<double>(frame.pressure[k]));
  }
  EXPECT_GT(least, 100.0);
  EXPECT_GE(shown, (1.0 - 1e-6) * least);
  EXPECT_LE(shown, (1.0 + 1e-6) * greatest);
}

// Two blocks collide without damping: the kinetic energy that they lose is stored as elastic energy
// and recovered.
void collide(int dimension, PrecisionKind precision, double poisson_ratio) {
  Case c = empty_case(dimension, precision);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  c.materials[0].poisson_ratio = poisson_ratio;
  c.materials[0].failure_strain = 0.0;
  c.materials[0].artificial_linear = c.materials[0].artificial_quadratic = 0.0;
  const double z = dimension == 3 ? 0.01 : 0.0;
  c.bodies = {body("left", Role::elastic, box({-0.0205, -0.005, 0.0}, {-0.0005, 0.005, z}), 1e-3),
              body("right", Role::elastic, box({0.0005, -0.007, 0.0}, {0.0205, 0.007, z}), 1e-3)};
  c.bodies[0].velocity = {"0.5", "0", "0"};
  c.bodies[1].velocity = {"-0.5", "0", "0"};
  const auto simulation = make_simulation(c);
  double worst = 0.0, stored = 0.0, touched = 0.0;
  const double start = simulation->balance().energy_initial;
  while (simulation->time() < 0.012) {
    for (int n = 0; n < 5; ++n) simulation->advance();
    const Balance now = simulation->balance();
    worst = std::max(worst, std::abs(now.energy_drift()));
    stored = std::max(stored, now.elastic_strain / start);
    touched = std::max(touched, now.rigid_potential / start);
  }
  const Balance end = simulation->balance();
  std::printf(
      "collision %dD, nu = %g: drift at worst %.2e, at the end %.2e; at most %.2f elastic, %.2f in "
      "contact; momentum %.1e\n",
      dimension, poisson_ratio, worst, end.energy_drift(), stored, touched, end.momentum_error());
  if (poisson_ratio < 0.4) {
    EXPECT_GT(stored, 0.3);
  }
  EXPECT_EQ(end.rigid_potential, 0.0);  // separated
  EXPECT_LE(worst, 0.01);
  expect_conserved(end, precision);
}
TEST(StandardEnergy, IsConservedInACollisionWithoutDamping2D) {
  for (PrecisionKind precision : both_precisions) collide(2, precision, 0.3);
}
TEST(StandardEnergy, IsConservedInACollisionOfNearlyIncompressibleSolids) {
  collide(2, PrecisionKind::mixed, 0.49);
}
TEST(StandardEnergy, IsConservedInACollisionWithoutDamping3D) {
  collide(3, PrecisionKind::mixed, 0.3);
}

// The frame from which the verdict on a cut follows has all that this needs of the whole frame.
TEST(StandardFrames, AFrameOfTheCutGivesTheVerdictOfAWholeFrame) {
  for (const int dimension : {2, 3}) {
    const Case c = standard_jet_on_block(dimension, PrecisionKind::mixed);
    const auto run = make_simulation(c);
    CutMonitor by_whole(c, run->frame()), by_part(c, run->frame());
    take_steps(*run, 400);
    const Frame whole = run->frame(), part = run->frame_of_cut();
    EXPECT_TRUE(same_column(whole.position, part.position));
    EXPECT_TRUE(same_column(whole.piece, part.piece));
    EXPECT_TRUE(same_column(whole.body_piece, part.body_piece));
    ASSERT_NE(find_column(part, "damage"), nullptr);
    EXPECT_TRUE(
        same_column(find_column(whole, "damage")->values, find_column(part, "damage")->values));
    EXPECT_LT(part.columns.size(), whole.columns.size());
    const CutState a = by_whole.observe(whole), b = by_part.observe(part);
    const auto& damage = find_column(whole, "damage")->values;
    EXPECT_GT(*std::max_element(damage.begin(), damage.end()), 0.0f);
    EXPECT_EQ(a.fractured_mass, b.fractured_mass);
    EXPECT_EQ(a.front_depth, b.front_depth);
    EXPECT_EQ(a.fractured_width, b.fractured_width);
    EXPECT_EQ(a.kerf_width, b.kerf_width);
    EXPECT_EQ(a.pieces, b.pieces);
    EXPECT_EQ(a.cut_through, b.cut_through);
  }
}

}  // namespace
}  // namespace kerf::test
