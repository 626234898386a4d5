// SPDX-License-Identifier: Apache-2.0
// Solids with jumps of the spacing have the properties of uniform ones.
#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "support/graded_blocks.hpp"

namespace kerf::test {
namespace {

template <class Chosen>
class GradedSolid : public testing::Test {};
TYPED_TEST_SUITE(GradedSolid, TwoKinds);
template <class Chosen>
class GradedForce : public testing::Test {};
TYPED_TEST_SUITE(GradedForce, DoubleOnly);

template <int D>
BlockChoice some_block() {
  return {.cells = D == 2 ? std::array{14, 8, 1} : std::array{8, 5, 5}};
}

// Every deformation gradient is that of the map, on both sides of the jump.
TYPED_TEST(GradedSolid, LinearMapsAreExact) {
  constexpr int D = TypeParam::D;
  SolidOnTrial<D, typename TypeParam::P> trial(graded_block<D>(some_block<D>()));
  const Square<D> map = some_map<D>();
  trial.map(map);
  trial.deform();
  double worst = 0.0;
  for (std::size_t i = 0; i < trial.size(); ++i)
    worst = std::max(
        worst, (as_square(trial.gradient(i)) + Square<D>::Identity() - map).cwiseAbs().maxCoeff());
  EXPECT_LE(worst, 30.0 * TypeParam::rounding);
}

// A rotation has no energy and no force.
TYPED_TEST(GradedSolid, RotationStoresNoEnergy) {
  constexpr int D = TypeParam::D;
  SolidOnTrial<D, typename TypeParam::P> trial(graded_block<D>(some_block<D>()));
  const auto strained = [&](const Square<D>& map) {
    trial.map(map);
    trial.evaluate();
    double largest = 0.0;
    for (std::size_t i = 0; i < trial.size(); ++i)
      largest = std::max(largest, norm(trial.force(i)));
    return largest;
  };
  const double scale = strained(1.1 * Square<D>::Identity());
  EXPECT_LE(strained(rotation<D>(1.0)), 1e3 * TypeParam::rounding * scale);
}

// Pairs cancel to the last bit, and there is no torque, for any motion.
TYPED_TEST(GradedSolid, SumsAndTorquesVanish) {
  constexpr int D = TypeParam::D;
  SolidOnTrial<D, typename TypeParam::P> trial(graded_block<D>(some_block<D>()));
  trial.map(some_map<D>());
  trial.displace_randomly(0.1e-3, 8);
  trial.evaluate();
  auto sum = Vector<D, double>::zero();
  Square<D> torque = Square<D>::Zero();
  double scale = 0.0, arm = 0.0;
  for (std::size_t i = 0; i < trial.size(); ++i) {
    const auto f = trial.force(i);
    const auto& x = trial.position[i];
    sum += f;
    scale += norm(f);
    arm += norm(f) * norm(x);
    torque += as_column(x) * as_column(f).transpose() - as_column(f) * as_column(x).transpose();
  }
  EXPECT_LE(norm(sum), TypeParam::rounding * scale);
  EXPECT_LE(torque.cwiseAbs().maxCoeff(), 10.0 * TypeParam::rounding * arm);
}

// The force is the gradient of the stored energy beside the jump too: no other force acts.
TYPED_TEST(GradedForce, ForceIsTheGradientOfTheStoredEnergy) {
  constexpr int D = TypeParam::D;
  SolidOnTrial<D, Double> trial(graded_block<D>(some_block<D>()));
  trial.map(some_map<D>());
  trial.displace_randomly(0.1e-3, 8);
  trial.evaluate();
  std::vector<Vector<D, double>> force;
  double largest = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < trial.size(); ++i) {
    force.push_back(trial.force(i));
    largest = std::max(largest, norm(force[i]));
  }
  const auto energy_at = [&](std::size_t i, double shift) {
    trial.position[i][0] += shift;
    trial.deform();
    trial.position[i][0] -= shift;
    return trial.solid.energy().total();
  };
  const double step = 1e-8;  // m, as in force_test.cpp
  for (std::size_t i = 0; i < trial.size(); i += 11) {
    const double slope = (energy_at(i, step) - energy_at(i, -step)) / (2.0 * step);
    worst = std::max(worst, std::abs(force[i][0] + slope));
  }
  EXPECT_LE(worst, 1e-7 * largest);
}

// The particle is further from every face than the kernel of the coarse particles.
template <int D>
bool is_far_from_faces(const SolidLayout<D>& layout, std::size_t i, const BlockChoice& choice) {
  for (int a = 0; a < D; ++a) {
    const double x = layout.reference[i][a] / choice.spacing;
    if (x < 5.2 || x > 2.0 * choice.cells[static_cast<std::size_t>(a)] - 5.2) return false;
  }
  return true;
}

// Under a uniform stress sigma the face of a particle carries sigma d^(D-1). The residual force at
// the jump is a few hundredths of that; without the gradient correction it is an eighth.
TYPED_TEST(GradedForce, UniformStressHasNoForceAtTheJump) {
  constexpr int D = TypeParam::D;
  const BlockChoice choice{.cells = D == 2 ? std::array{16, 16, 1} : std::array{10, 9, 9}};
  double left[2];
  for (const bool fitted : {false, true}) {
    auto layout = graded_block<D>(choice);
    if (!fitted) layout.body.clear();
    SolidOnTrial<D, Double> trial(layout);
    const double strain = 1e-4;
    trial.map((1.0 + strain) * Square<D>::Identity());
    trial.evaluate();
    const auto& medium = layout.media[0];
    const double stress =
        strain * (D == 2 ? 2.0 * (medium.bulk_modulus + medium.shear_modulus / 3.0)
                         : 3.0 * medium.bulk_modulus);
    double& worst = left[fitted] = 0.0;
    for (std::size_t i = 0; i < trial.size(); ++i)
      if (is_far_from_faces(layout, i, choice))
        worst = std::max(
            worst, norm(trial.force(i)) /
                       (stress * std::pow(layout.media[layout.medium_index[i]].spacing, D - 1)));
  }
  std::printf("%dD: out of balance %.4f without, %.4f with the fit\n", D, left[0], left[1]);
  EXPECT_LE(left[1], 0.04);
  EXPECT_LE(left[1], 0.35 * left[0]);
}

// Pairs without a jump near are unchanged, and no pair changes its sign.
TYPED_TEST(GradedForce, FactorsAreNearOne) {
  constexpr int D = TypeParam::D;
  const auto choice = some_block<D>();
  SolidOnTrial<D, Double> trial(graded_block<D>(choice));
  const auto factors = to_host(trial.solid.fields().bond_correction);
  const auto bonds = trial.solid.view().bonds;
  for (Index i = 0; i < trial.size(); ++i) {
    const double from_jump =
        std::abs(trial.layout.reference[i][0] / choice.spacing - choice.cells[0]);
    for (Index k = bonds.first(i); k < bonds.last(i); ++k) {
      EXPECT_GT(factors[k], 0.4);
      EXPECT_LT(factors[k], 2.0);
      if (from_jump > 11.0) {        // outside the kernels of one coarse particle beside the
        EXPECT_EQ(factors[k], 1.0);  // jump and of its neighbour
      }
    }
  }
}

// The energy of a free vibration that includes the jump is conserved.
TYPED_TEST(GradedSolid, VibrationConservesEnergy) {
  constexpr int D = TypeParam::D;
  SolidOnTrial<D, typename TypeParam::P> trial(graded_block<D>(some_block<D>()));
  const double length = 2e-3 * some_block<D>().cells[0];
  for (std::size_t i = 0; i < trial.size(); ++i)
    trial.velocity[i][0] = static_cast<typename TypeParam::Real>(
        0.3 * std::cos(std::numbers::pi * trial.layout.reference[i][0] / length));
  trial.evaluate();
  const double start = trial.kinetic_energy() + trial.solid.energy().total();
  const double dt = 0.2e-3 / trial.layout.media[0].bond_wave_speed();
  double drift = 0.0, stored = 0.0;
  for (int n = 0; n < (D == 2 ? 1000 : 300); ++n) {
    trial.step(dt);
    const double energy = trial.solid.energy().total();
    stored = std::max(stored, energy / start);
    drift = std::max(drift, std::abs(trial.kinetic_energy() + energy - start) / start);
  }
  EXPECT_GT(stored, 0.5);
  // The error is of second order in the step, as for uniform solids.
  EXPECT_LE(drift, 2e-3);
}

}  // namespace
}  // namespace kerf::test
