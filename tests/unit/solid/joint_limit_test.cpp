// SPDX-License-Identifier: Apache-2.0
// The stable step of pieces of unlike media against the eigenvalues of their stiffness, and runs at
// that step.
#include <gtest/gtest.h>

#include "support/graded_blocks.hpp"

namespace kerf::test {
namespace {

constexpr double courant = 0.25;

struct Joint {
  double density = 1.0, stiffness = 1.0;  // of the lower half over those of the upper one
  bool lower_first = true;                // which medium the list names first
  double angle = 0.0, jitter = 0.0, viscosity = 0.0;
};

// A block whose lower half differs from the upper one, turned by an angle.
template <int D>
SolidLayout<D> joined(const Joint& joint, const std::array<int, 3>& cells) {
  const double d = 1e-3;
  auto layout = block<D>({.cells = cells, .spacing = d, .jitter = joint.jitter});
  const double middle = 0.5 * d * cells[1];
  auto upper = layout.media[0], lower = upper;
  lower.density *= joint.density;
  lower.mass *= joint.density;
  lower.bulk_modulus *= joint.stiffness;
  lower.shear_modulus *= joint.stiffness;
  layout.media = {joint.lower_first ? lower : upper, joint.lower_first ? upper : lower};
  for (auto& medium : layout.media) medium.artificial_linear = joint.viscosity;
  const auto turn = rotation<D>(joint.angle);
  for (std::size_t i = 0; i < layout.reference.size(); ++i) {
    auto& x = layout.reference[i];
    layout.medium_index[i] = (x[1] < middle) == joint.lower_first ? 0 : 1;
    const Eigen::Matrix<double, D, 1> turned = turn * as_column<D>(x);
    for (int a = 0; a < D; ++a) x[a] = turned(a);
  }
  return layout;
}

// The accelerations times the roots of the masses, in one column.
template <int D>
Eigen::VectorXd weighted_accelerations(SolidOnTrial<D, Double>& trial) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(D * trial.size()));
  trial.evaluate();
  for (std::size_t i = 0; i < trial.size(); ++i)
    for (int a = 0; a < D; ++a)
      result(static_cast<Eigen::Index>(D * i) + a) =
          trial.force(i)[a] / std::sqrt(trial.layout.media[trial.layout.medium_index[i]].mass);
  return result;
}

// The largest angular frequency of small vibrations, 1/s: of the matrix of the differences of
// accelerations, made symmetric by the roots of the masses.
template <int D>
double highest_frequency(SolidOnTrial<D, Double>& trial) {
  const auto n = static_cast<Eigen::Index>(D * trial.size());
  Eigen::MatrixXd stiffness(n, n);
  const double step = 1e-9;
  for (Eigen::Index column = 0; column < n; ++column) {
    const auto j = static_cast<std::size_t>(column) / D;
    const int b = static_cast<int>(column % D);
    const double root = std::sqrt(trial.layout.media[trial.layout.medium_index[j]].mass);
    trial.position = trial.layout.reference;
    trial.position[j][b] += step;
    const Eigen::VectorXd ahead = weighted_accelerations(trial);
    trial.position[j][b] -= 2.0 * step;
    stiffness.col(column) = (weighted_accelerations(trial) - ahead) / (2.0 * step * root);
  }
  trial.position = trial.layout.reference;
  trial.evaluate();
  return std::sqrt(
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(0.5 * (stiffness + stiffness.transpose()))
          .eigenvalues()
          .maxCoeff());
}

constexpr double contrasts[] = {1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5};

// The step is stable (omega dt < 2), and no shorter than four times what would do. Half the bound
// of Gershgorin's kind is lost where all neighbours move against a particle, more where stress and
// hourglass control do not act on one motion.
template <int D>
void expect_stable(const Joint& joint, const std::array<int, 3>& cells) {
  SolidOnTrial<D, Double> trial(joined<D>(joint, cells));
  trial.evaluate();
  const double frequency = highest_frequency(trial);
  const double phase = frequency * courant * trial.solid.wave_time(courant).time;
  EXPECT_LT(phase, 2.0) << joint.density << " " << joint.stiffness << " " << joint.lower_first;
  EXPECT_GT(phase, 0.5) << joint.density << " " << joint.stiffness << " " << joint.lower_first;
  // A greater factor of the acoustic limit makes no longer step beside unlike media.
  const WaveTime longer = trial.solid.wave_time(0.8);
  EXPECT_LT(longer.of_joint ? frequency * 0.8 * longer.time : 0.0, 2.0);
}
TEST(JointLimit, IsStableAtEveryContrastIn2D) {
  for (const double density : contrasts)
    for (const double stiffness : contrasts)
      for (const bool first : {true, false})
        expect_stable<2>({density, stiffness, first, 0.4, 0.1}, {6, 6, 1});
}
TEST(JointLimit, IsStableAtEveryContrastIn3D) {
  for (const double density : {1.0, 1e-2, 1e-5})
    for (const double stiffness : {1.0, 1e-2, 1e-5})
      expect_stable<3>({density, stiffness, true, 0.4, 0.1}, {4, 4, 4});
}

// Media of two names and one nature take the step of the waves.
TEST(JointLimit, DoesNotActBetweenLikeMedia) {
  SolidOnTrial<2, Double> like(joined<2>({}, {8, 8, 1}));
  like.evaluate();
  const auto& medium = like.layout.media[0];
  const double wave = medium.smoothing_length / medium.bond_wave_speed();
  EXPECT_NEAR(like.solid.wave_time(courant).time, wave, 1e-12 * wave);
  EXPECT_FALSE(like.solid.wave_time(courant).of_joint);
  SolidOnTrial<2, Double> nearly(joined<2>({.density = 0.9, .stiffness = 0.9}, {8, 8, 1}));
  nearly.evaluate();
  EXPECT_NEAR(nearly.solid.wave_time(courant).time, wave, 1e-12 * wave);
  EXPECT_FALSE(nearly.solid.wave_time(courant).of_joint);
}

// Levels of one body are like media, whatever other media the case has, such as its water.
TEST(JointLimit, DoesNotActBetweenLevelsOfOneBody) {
  auto layout = graded_block<2>({.cells = {8, 8, 1}, .spacing = 1e-3});
  auto water = layout.media[0];
  water.phase = Phase::water;
  water.density *= 20.0;
  layout.media.push_back(water);
  SolidOnTrial<2, Double> graded(layout);
  graded.evaluate();
  const auto& fine = layout.media[0];
  const double wave =
      fine.smoothing_length / (fine.bond_wave_speed() * (1.0 + 1.2 * fine.artificial_linear));
  for (const double factor : {courant, 0.8}) {
    EXPECT_NEAR(graded.solid.wave_time(factor).time, wave, 1e-12 * wave);
    EXPECT_FALSE(graded.solid.wave_time(factor).of_joint);
  }
}

// The upper half moves sideways. Without viscosity position Verlet conserves an energy that differs
// from the energy by (omega dt)^2 / 4 of the part of each mode; with it the energy only falls.
template <class P>
void expect_energy(const Joint& joint) {
  SolidOnTrial<2, P> trial(joined<2>(joint, {10, 10, 1}));
  const std::size_t upper = joint.lower_first ? 1 : 0;
  for (std::size_t i = 0; i < trial.size(); ++i)
    if (trial.layout.medium_index[i] == upper) trial.velocity[i][0] = 0.01;
  trial.evaluate();
  const double start = trial.kinetic_energy() + trial.solid.energy().total();
  const double dt = courant * trial.solid.wave_time(courant).time;
  double least = start, most = start;
  for (int n = 0; n < 1500; ++n) {
    trial.step(dt);
    const double energy = trial.kinetic_energy() + trial.solid.energy().total();
    least = std::min(least, energy);
    most = std::max(most, energy);
  }
  EXPECT_LT(most, 1.02 * start) << joint.density << " " << joint.stiffness;
  if (joint.viscosity > 0.0) return;
  EXPECT_GT(least, 0.98 * start) << joint.density << " " << joint.stiffness;
}
TEST(JointLimit, RunsConserveEnergy) {
  for (const double contrast : {1.0, 1e-1, 3e-4, 1e-5})
    for (const double viscosity : {0.0, 2.5})
      for (const bool first : {true, false}) {
        expect_energy<Mixed>({contrast, 1.0, first, 0.4, 0.0, viscosity});
        expect_energy<Mixed>({1.0, contrast, first, 0.4, 0.0, viscosity});
        expect_energy<Mixed>({contrast, contrast, first, 0.4, 0.0, viscosity});
      }
}

}  // namespace
}  // namespace kerf::test
