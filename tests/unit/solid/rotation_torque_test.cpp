// SPDX-License-Identifier: Apache-2.0
// A lattice that turns as a whole has the same rounding errors at every particle, so that their
// couples do not cancel. What is left over the angle must have no sign that stays.
#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace rotation_torque_test {
namespace {

// A square or cube about its middle, its lattice turned by an angle.
template <int D>
SolidLayout<D> turned_block(double angle) {
  BlockChoice choice;
  choice.cells = {12, 12, 12};
  choice.spacing = 2e-3;
  SolidLayout<D> layout = block<D>(choice);
  const Square<D> turn = rotation<D>(angle);
  for (auto& x : layout.reference) {
    Eigen::Matrix<double, D, 1> centred = as_column<D>(x);
    for (int a = 0; a < D; ++a) centred[a] -= 0.5 * choice.cells[0] * choice.spacing;
    const Eigen::Matrix<double, D, 1> turned = turn * centred;
    for (int a = 0; a < D; ++a) x[a] = turned[a];
  }
  return layout;
}

// Returns the couple about the axis of rotation(), N m (2D: N).
template <int D, class P>
double couple(const SolidOnTrial<D, P>& trial) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < trial.size(); ++i) {
    Eigen::Vector3d x = Eigen::Vector3d::Zero(), force = x;
    x.head<D>() = as_column<D>(trial.position[i]);
    force.head<D>() = as_column<D>(trial.force(i));
    sum += x.cross(force);
  }
  return D == 2 ? sum[2] : sum.dot(Eigen::Vector3d(1, 2, 3).normalized());
}

// Returns the mean of the couple over angles, divided by each, in E V.
template <int D, class P>
double mean_couple(double angle_of_lattice) {
  SolidOnTrial<D, P> trial(turned_block<D>(angle_of_lattice));
  const Medium<double>& medium = trial.layout.media[0];
  const double modulus = 9.0 * medium.bulk_modulus * medium.shear_modulus /
                         (3.0 * medium.bulk_modulus + medium.shear_modulus);
  const double scale = modulus * medium.mass / medium.density * double(trial.size());
  constexpr int angles = 200;
  double sum = 0.0;
  for (int n = 1; n <= angles; ++n) {
    const double angle = 0.2 + 0.00151 * n;
    trial.map(rotation<D>(angle));
    trial.evaluate();
    sum += couple(trial) / (angle * scale);
  }
  return sum / angles;
}

TEST(RotationTorque, OfASinglePrecisionLatticeHasNoSign) {
  for (const double angle : {0.0, 0.35}) {
    EXPECT_LT(std::abs((mean_couple<2, Mixed>(angle))), 1e-8) << angle;
    EXPECT_LT(std::abs((mean_couple<3, Mixed>(angle))), 1e-8) << angle;
    EXPECT_LT(std::abs((mean_couple<2, Double>(angle))), 1e-15) << angle;
  }
}

}  // namespace
}  // namespace rotation_torque_test
}  // namespace kerf::test
