// SPDX-License-Identifier: Apache-2.0
// A bar of a brittle and a softer half is pulled at its ends: the stress is the same everywhere,
// and the joint bears most of the strength, whatever the contrast, the angle of the lattice and the
// criterion. By the stretch of its bonds alone it would bear 2 / (1 + contrast) of it: 0.33 at a
// contrast of 5, 0.095 at 20. A solid that softens does so where the stress of the row beside the
// joint is too large (docs/bodies.md).
#include <gtest/gtest.h>

#include <cstdio>

#include "support/solid_blocks.hpp"

namespace kerf::test::joint_break_test {
namespace {

constexpr double spacing = 1e-3, height = 20e-3, width = 8e-3, youngs_modulus = 1e7,
                 strength = 1e5;  // Pa, of the upper half

struct Bar {
  BondCriterion criterion;
  double contrast, angle = 0.0;
  bool brittle_first = false;  // in the list of media
};

Medium<double> half(double modulus) {
  auto medium = soft_solid(spacing, 2);
  medium.bulk_modulus = modulus / 3.0;  // nu = 0
  medium.shear_modulus = modulus / 2.0;
  medium.artificial_linear = 1.0;
  return medium;
}

Medium<double> brittle_half(BondCriterion criterion) {
  auto medium = half(youngs_modulus);
  medium.criterion = criterion;
  if (criterion == BondCriterion::principal_stress)
    medium.principal_stress.tensile_strength = strength;
  else
    medium.failure_strain = strength / youngs_modulus;
  if (criterion == BondCriterion::crack_band) {
    medium.softening_strain = strength / youngs_modulus;
    medium.failure_strain = 4.0 * medium.softening_strain;
  }
  return medium;
}

// The lattice of the bar is turned with it by the angle.
SolidLayout<2> layout_of(const Bar& bar) {
  auto layout = block<2>({.cells = {8, 20, 1}, .spacing = spacing});
  const auto brittle = brittle_half(bar.criterion), soft = half(youngs_modulus / bar.contrast);
  layout.media = bar.brittle_first ? std::vector{brittle, soft} : std::vector{soft, brittle};
  const auto turn = rotation<2>(bar.angle);
  for (std::size_t i = 0; i < layout.reference.size(); ++i) {
    const bool is_upper = layout.reference[i][1] > 0.5 * height;
    layout.medium_index[i] = is_upper == bar.brittle_first ? 0 : 1;
    const Eigen::Vector2d turned = turn * as_column<2>(layout.reference[i]);
    layout.reference[i] = {turned[0], turned[1]};
  }
  return layout;
}

// A bar whose lower end is held and whose upper end moves away.
struct PulledBar {
  Bar bar;
  SolidLayout<2> layout = layout_of(bar);
  SolidOnTrial<2, Double> trial{layout};
  Eigen::Vector2d axis = rotation<2>(bar.angle) * Eigen::Vector2d(0.0, 1.0);

  double along(std::size_t i) const { return axis.dot(as_column<2>(layout.reference[i])); }
  // Returns the force on the upper end, N/m.
  double hold_ends(double speed) {
    double force = 0.0;
    for (std::size_t i = 0; i < trial.size(); ++i) {
      const bool is_upper = along(i) > height - 2e-3;
      if (is_upper) force -= axis.dot(as_column<2>(trial.force(i)));
      if (is_upper || along(i) < 2e-3)
        trial.velocity[i] = {is_upper ? speed * axis[0] : 0.0, is_upper ? speed * axis[1] : 0.0};
      else
        trial.velocity[i] = 0.99 * trial.velocity[i];
    }
    return force;
  }
  void move(double dt) {
    for (std::size_t i = 0; i < trial.size(); ++i)
      trial.position[i] += dt * Vector<2, double>::from(trial.velocity[i]);
  }
};

// Pulls the bar slowly until a bond breaks. Returns the stress of it then over the strength, by the
// force on its upper end.
double breaks_at(const Bar& bar) {
  PulledBar pulled{bar};
  auto& trial = pulled.trial;
  const double dt = 0.2 * spacing / brittle_half(bar.criterion).bond_wave_speed();
  const double stretch = 1.3 * strength / youngs_modulus * 0.5 * height * (1.0 + bar.contrast);
  const double time = 15.0 * height / std::sqrt(youngs_modulus / bar.contrast / 1000.0);
  trial.evaluate();
  double mean = 0.0;
  for (double t = 0.0; t < time; t += dt) {
    trial.kick(0.5 * dt);
    mean += 0.02 * (pulled.hold_ends(stretch / time) / width - mean);
    pulled.move(dt);
    trial.deform();
    if (trial.solid.fracture().bonds > 0) break;
    trial.solid.keep_softening();
    trial.evaluate();
    trial.kick(0.5 * dt);
  }
  return mean / strength;
}

TEST(JointBreak, ABarOfTwoStiffnessesBearsItsStrength) {
  for (const BondCriterion criterion : {BondCriterion::principal_stress,
                                        BondCriterion::principal_strain, BondCriterion::crack_band})
    for (const Bar& bar :
         {Bar{criterion, 5.0}, Bar{criterion, 5.0, 0.6, true}, Bar{criterion, 20.0}}) {
      const double share = breaks_at(bar);
      std::printf("%s, contrast %g, angle %g: breaks at %.3f of its strength\n",
                  std::string(word_of(criterion, bond_criterion_words)).c_str(), bar.contrast,
                  bar.angle, share);
      EXPECT_GT(share, criterion == BondCriterion::crack_band ? 0.65 : 0.75);
      EXPECT_LT(share, 1.15);
    }
}

}  // namespace
}  // namespace kerf::test::joint_break_test
