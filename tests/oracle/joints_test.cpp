// SPDX-License-Identifier: Apache-2.0
// Runs of bodies of unlike density and stiffness that are joined: their energy is that which they
// start with, whichever of them the case names first, along the lattice or turned to it.
#include <cmath>

#include "analysis/derived.hpp"
#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

struct Joint {
  double density, stiffness;  // of the layer over those of the plate
  bool layer_first = false;
  double angle = 0.0;
};

Shape turned_box(double x0, double y0, double x1, double y1, double angle) {
  Shape shape;
  shape.kind = Shape::Kind::polygon;
  for (const auto& [x, y] : {std::pair{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}})
    shape.vertices.push_back(
        {x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)});
  return shape;
}

// A layer that moves towards a plate, to which it is joined, and along it.
Case layer_on_plate(const Joint& joint) {
  Case c = empty_case(2, PrecisionKind::mixed);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  Material plate = tofu();
  plate.density = 7800.0;
  plate.youngs_modulus = 3e9;
  plate.failure_strain = 0.0;
  Material layer = plate;
  layer.name = "soft";
  layer.density *= joint.density;
  layer.youngs_modulus *= joint.stiffness;
  c.materials = {plate, layer};
  c.bodies = {
      body("plate", Role::elastic, turned_box(-0.008, -0.005, 0.008, 0.0, joint.angle), 1e-3),
      body("layer", Role::elastic, turned_box(-0.008, 0.0, 0.008, 0.005, joint.angle), 1e-3)};
  c.bodies[1].material = 1;
  // 1/2000 of the slower of the two speeds of sound of the layer and the plate, so that strains are
  // small.
  const double wave =
      std::sqrt(3e9 / 7800.0 * std::min(1.0, joint.stiffness / joint.density)) / 2000.0;
  c.bodies[1].velocity = {std::to_string(wave), std::to_string(-wave), "0"};
  if (joint.layer_first) std::swap(c.bodies[0], c.bodies[1]);
  c.bodies[1].joined_to = c.bodies[0].name;
  return c;
}

void expect_sound(const Joint& joint, double viscosity) {
  Case c = layer_on_plate(joint);
  for (Material& material : c.materials)
    material.artificial_linear = material.artificial_quadratic = viscosity;
  const auto simulation = make_simulation(c);
  double largest = 0.0;
  for (int n = 0; n < 400; n += 10) {
    take_steps(*simulation, 10);
    largest = std::max(largest, std::abs(simulation->balance().energy_drift()));
  }
  // Position Verlet conserves an energy that differs by (omega dt)^2 / 4 in each mode: at the start
  // all modes move, those with omega dt near 1 too.
  EXPECT_LT(largest, 0.05) << joint.density << " " << joint.stiffness << " " << viscosity;
}

TEST(Joints, KeepTheirEnergyAtEveryContrast) {
  for (const double contrast : {1.0, 1e-2, 3e-4, 1e-5})
    for (const double viscosity : {0.0, 2.5}) {
      expect_sound({contrast, 1.0}, viscosity);
      expect_sound({1.0, contrast}, viscosity);
      expect_sound({contrast, contrast}, viscosity);
      expect_sound({contrast, contrast, true, 0.5}, viscosity);
    }
}

TEST(Joints, NameTheirLimit) {
  const auto simulation = make_simulation(layer_on_plate({3e-4, 3e-4}));
  simulation->advance();
  EXPECT_EQ(simulation->last_step().limit, "joint (solid)");
  const auto alike = make_simulation(layer_on_plate({1.0, 1.0}));
  alike->advance();
  EXPECT_EQ(alike->last_step().limit, "acoustic (solid)");
}

// `kerf check` knows the step before the run: the estimate is that of a full plane lattice.
TEST(Joints, StepIsEstimated) {
  for (const double density : {1.0, 1e-2, 1e-4})
    for (const double stiffness : {1.0, 1e-2, 1e-4})
      for (const bool first : {false, true}) {
        const Case c = layer_on_plate({density, stiffness, first});
        const auto simulation = make_simulation(c);
        simulation->advance();
        const double ratio = derive(c).time_step / simulation->last_step().dt;
        EXPECT_GT(ratio, 0.7) << density << " " << stiffness;
        EXPECT_LT(ratio, 1.4) << density << " " << stiffness;
      }
}

TEST(Joints, SameBitsAfterRestart) {
  expect_same_bits_after_restart(layer_on_plate({3e-4, 3e-4, true, 0.5}));
}

}  // namespace
}  // namespace kerf::test
