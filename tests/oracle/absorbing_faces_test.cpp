// SPDX-License-Identifier: Apache-2.0
// Absorbing faces: the force on a rigidly moving block, and waves that reach the faces.
#include <cmath>
#include <numbers>

#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

Case block_case(int dimension, PrecisionKind precision) {
  Case c = empty_case(dimension, precision);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  c.materials[0].failure_strain = 0.0;
  c.materials[0].artificial_linear = c.materials[0].artificial_quadratic = 0.0;
  return c;
}

struct Speeds {
  double pressure, shear;  // m/s
};
Speeds speeds_of(const Material& m) {
  const double nu = m.poisson_ratio;
  return {std::sqrt(m.youngs_modulus * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu) * m.density)),
          std::sqrt(m.youngs_modulus / (2.0 * (1.0 + nu) * m.density))};
}

// A block in rigid motion gets the force rho c_p v per area of the face along its normal and rho
// c_s v along it, on lattices of every kind, whose particles share the area of the face.
TEST(AbsorbingFaces, HaveTheImpedanceOfTheFace) {
  struct Choice {
    int dimension;
    Lattice lattice;
    std::size_t axis;
    bool upper;
  };
  const double d = 1e-3, row = d * std::numbers::sqrt3 / 2.0, layer = d * std::sqrt(2.0 / 3.0);
  const Choice choices[] = {{2, Lattice::square, 0, false},    {2, Lattice::square, 1, true},
                            {3, Lattice::square, 2, false},    {2, Lattice::hexagonal, 0, true},
                            {2, Lattice::hexagonal, 1, false}, {3, Lattice::hexagonal, 0, false},
                            {3, Lattice::hexagonal, 1, true},  {3, Lattice::hexagonal, 2, true}};
  for (const Choice& choice : choices) {
    Case c = block_case(choice.dimension, PrecisionKind::double_precision);
    const bool hexagonal = choice.lattice == Lattice::hexagonal;
    const Point size{12.0 * d, 10.0 * (hexagonal ? row : d),
                     choice.dimension == 3 ? 8.0 * (hexagonal ? layer : d) : 0.0};
    c.bodies = {body("block", Role::elastic, box({0.0, 0.0, 0.0}, size), d)};
    c.bodies[0].lattice = choice.lattice;
    auto& faces = c.bodies[0].absorbing;
    (choice.upper ? faces.maximum : faces.minimum)[choice.axis] = true;
    const Point v{0.3, -0.2, choice.dimension == 3 ? 0.1 : 0.0};
    for (std::size_t a = 0; a < 3; ++a) c.bodies[0].velocity[a] = std::to_string(v[a]);
    const auto simulation = make_simulation(c);
    simulation->advance();
    const Balance balance = simulation->balance();
    const double dt = simulation->last_step().dt;
    const auto speeds = speeds_of(c.materials[0]);
    double area = 1.0;
    for (std::size_t a = 0; a < static_cast<std::size_t>(choice.dimension); ++a)
      if (a != choice.axis) area *= size[a];
    for (std::size_t a = 0; a < static_cast<std::size_t>(choice.dimension); ++a) {
      const double c_a = a == choice.axis ? speeds.pressure : speeds.shear;
      const double due = -c.materials[0].density * c_a * area * v[a] * dt;
      EXPECT_NEAR(balance.impulse_constraint[a], due, 1e-9 * std::abs(due))
          << choice.dimension << "D axis " << choice.axis << " component " << a;
    }
    EXPECT_LT(balance.momentum_error(), 1e-12);
  }
}

// The face of a graded body is fine in the middle of its length and coarse at its ends; each
// particle has the area of its own layer.
TEST(AbsorbingFaces, HaveTheImpedanceOfAGradedFace) {
  for (const std::size_t axis : {0, 1}) {
    Case c = block_case(2, PrecisionKind::double_precision);
    const double d = 1e-3;
    c.bodies = {body("block", Role::elastic, box({-0.016, 0.0, 0.0}, {0.016, 0.016, 0.0}), d)};
    c.bodies[0].grading = {1, 2e-3, box({-0.004, -1.0, 0.0}, {0.004, 1.0, 0.0}), {}};
    c.bodies[0].absorbing.maximum[axis] = true;
    c.bodies[0].velocity = {"0.3", "-0.2", "0"};
    const auto simulation = make_simulation(c);
    const auto spacings = simulation->frame().spacing;
    ASSERT_LT(std::ranges::min(spacings), 0.6 * std::ranges::max(spacings));
    simulation->advance();
    const Balance balance = simulation->balance();
    const auto speeds = speeds_of(c.materials[0]);
    const double area = axis == 0 ? 0.016 : 0.032, v[2] = {0.3, -0.2};
    for (std::size_t a = 0; a < 2; ++a) {
      const double c_a = a == axis ? speeds.pressure : speeds.shear;
      const double due = -c.materials[0].density * c_a * area * v[a] * simulation->last_step().dt;
      EXPECT_NEAR(balance.impulse_constraint[a], due, 1e-9 * std::abs(due)) << axis << " " << a;
    }
    EXPECT_LT(balance.momentum_error(), 1e-12);
  }
}

// A lattice at an angle (rad) to the faces of its body, or with a jitter (of a spacing).
struct Turned {
  int dimension;
  double angle, jitter;
};

// Returns the force per velocity along an axis of a block that absorbs on all sides, kg/s.
double impedance_along(std::size_t along, const Point& size, const Material& m, std::size_t axes) {
  const Speeds speeds = speeds_of(m);
  double sum = 0.0;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    double area = 2.0;
    for (std::size_t b = 0; b < axes; ++b) area *= b == axis ? 1.0 : size[b];
    sum += m.density * (axis == along ? speeds.pressure : speeds.shear) * area;
  }
  return sum;
}

// Under a body force a block with absorbing faces all around comes to drift at the speed at which
// they bear that force: M g = (2 rho c_p A_x + 2 rho c_s (A_y + A_z)) v along x, and so on.
TEST(AbsorbingFaces, BearABodyForceHoweverTheLatticeLies) {
  const double degree = std::numbers::pi / 180.0;
  for (const Turned& turned :
       {Turned{2, 0.0, 0.0}, Turned{2, 10.0 * degree, 0.0}, Turned{2, 30.0 * degree, 0.0},
        Turned{2, 45.0 * degree, 0.0}, Turned{2, 0.0, 0.1}, Turned{2, 0.0, 0.3},
        Turned{3, 30.0 * degree, 0.0}, Turned{3, 0.0, 0.3}}) {
    Case c = block_case(turned.dimension, PrecisionKind::double_precision);
    const auto axes = static_cast<std::size_t>(turned.dimension);
    c.materials[0].poisson_ratio = 0.25;
    const Point size{0.02, 0.01, turned.dimension == 3 ? 0.008 : 0.0};
    c.bodies = {body("block", Role::elastic, box({0.0, 0.0, 0.0}, size), 1e-3)};
    c.bodies[0].lattice_angle = turned.angle;
    c.bodies[0].jitter = turned.jitter;
    for (std::size_t a = 0; a < axes; ++a)
      c.bodies[0].absorbing.minimum[a] = c.bodies[0].absorbing.maximum[a] = true;
    const auto speeds = speeds_of(c.materials[0]);
    Load load;
    load.kind = LoadKind::body_force;
    load.body = "block";
    load.acceleration = {5.0, 10.0, 0.0};  // the strain is of the order of rho g L / E = 0.001
    c.loads = {load};
    c.time.end = 10.0 * size[0] / speeds.pressure;
    const auto simulation = make_simulation(c);
    while (!simulation->finished()) simulation->advance();
    const Balance balance = simulation->balance();
    for (std::size_t a = 0; a < 2; ++a) {
      const double due =
          balance.mass_now * load.acceleration[a] / impedance_along(a, size, c.materials[0], axes);
      EXPECT_NEAR(balance.momentum_now[a] / balance.mass_now, due, 0.02 * due)
          << turned.dimension << "D " << turned.angle << " rad, jitter " << turned.jitter << ", "
          << a;
    }
  }
}

// A pulse travels along a strip with symmetry planes on its long sides, as a plane wave, to
// absorbing ends. Returns the remaining energy over the initial one, all of it and the kinetic one.
struct LeftOver {
  double all, kinetic;
};
LeftOver left_over(double spacing, double poisson_ratio = 0.3) {
  Case c = block_case(2, PrecisionKind::double_precision);
  c.materials[0].poisson_ratio = poisson_ratio;
  const double length = 0.1, width = 4e-3;
  c.domain = {{-0.2, 0.0, 0.0}, {0.2, width, 0.0}};
  c.symmetry.minimum[1] = c.symmetry.maximum[1] = true;
  c.bodies = {
      body("strip", Role::elastic, box({-length, 0.0, 0.0}, {length, width, 0.0}), spacing)};
  c.bodies[0].absorbing.minimum[0] = c.bodies[0].absorbing.maximum[0] = true;
  // The amplitude is small, so that the wave is linear; the pulse is 20 mm wide.
  c.bodies[0].velocity[0] = "1e-3 * exp(-(x / 0.02)^2)";
  c.time.end = 1.8 * length / speeds_of(c.materials[0]).pressure;
  const auto simulation = make_simulation(c);
  const double before = simulation->balance().kinetic;
  while (!simulation->finished()) simulation->advance();
  const Balance balance = simulation->balance();
  // Position Verlet conserves an energy that differs by (omega dt)^2, with omega = c / 10 mm and dt
  // = 0.3 d / c.
  EXPECT_LT(std::abs(balance.energy_drift()), std::pow(0.3 * spacing / 0.01, 2));
  EXPECT_LT(balance.momentum_error(), 1e-9);
  return {(balance.kinetic + balance.elastic_strain + balance.hourglass) / before,
          balance.kinetic / before};
}

// The reflected amplitude is of the order of (spacing / length of the wave) of that of the wave.
TEST(AbsorbingFaces, AbsorbAPlaneWave) {
  const double coarse = std::sqrt(left_over(2e-3).all);
  const double fine = std::sqrt(left_over(1e-3).all);
  EXPECT_LT(coarse, 0.04);
  EXPECT_LT(fine, 0.6 * coarse);
}

// Faces at an angle to the lattice, which are stairs, absorb likewise. Without a Poisson's ratio a
// strip with free sides carries a plane wave. Dashpots that are stronger by the factor z reflect
// (z - 1) / (z + 1) of its amplitude. The pulse is so wide that the half row outside the particles,
// which reflects k d / 4, adds less than 1%.
TEST(AbsorbingFaces, AbsorbAPlaneWaveAtAnAngleToTheLattice) {
  for (const double degrees : {30.0, 45.0}) {
    Case c = block_case(2, PrecisionKind::double_precision);
    c.materials[0].poisson_ratio = 0.0;
    c.bodies = {body("strip", Role::elastic, box({-0.08, 0.0, 0.0}, {0.08, 0.012, 0.0}), 1e-3)};
    c.bodies[0].lattice_angle = degrees * std::numbers::pi / 180.0;
    c.bodies[0].absorbing.minimum[0] = c.bodies[0].absorbing.maximum[0] = true;
    c.bodies[0].velocity[0] = "1e-3 * exp(-(x / 0.03)^2)";
    c.time.end = 2.0 * 0.08 / speeds_of(c.materials[0]).pressure;
    const auto simulation = make_simulation(c);
    const double before = simulation->balance().kinetic;
    while (!simulation->finished()) simulation->advance();
    const Balance balance = simulation->balance();
    const double left = balance.kinetic + balance.elastic_strain + balance.hourglass;
    EXPECT_LT(std::sqrt(left / before), 0.03) << degrees;
  }
}

// So is that of a nearly incompressible solid, whose particles have a density: a face that damps
// their extrapolated velocity is too stiff, and sends back a third of the wave.
TEST(AbsorbingFaces, AbsorbAWaveOfANearlyIncompressibleSolid) {
  EXPECT_LT(std::sqrt(2.0 * left_over(1e-3, 0.42).kinetic), 0.04);
}

TEST(AbsorbingFaces, SameBitsAfterRestart) {
  Case c = standard_jet_on_block(2, PrecisionKind::mixed);
  c.bodies[0].absorbing = {{true, false, false}, {true, false, false}};
  EXPECT_NE(expect_same_bits_after_restart(c).impulse_constraint[0], 0.0);
}

}  // namespace
}  // namespace kerf::test
