// SPDX-License-Identifier: Apache-2.0
// The strain that frames show, against a closed form. A block whose velocity is A X deforms as
// F = 1 + A t until waves from its surface arrive, because its stress is uniform.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

constexpr double half_width = 0.015, spacing = 1e-3, until = 5e-4;

Case stretched_block(int dimension, const Eigen::Matrix3d& rate) {
  Case c = empty_case(dimension, PrecisionKind::mixed);
  c.formulation = Formulation::standard;
  c.smoothing_ratio = 1.3;
  c.materials[0].failure_strain = 0.0;
  const double depth = dimension == 3 ? half_width : 0.0;
  c.bodies = {body("block", Role::elastic,
                   box({-half_width, -half_width, -depth}, {half_width, half_width, depth}),
                   spacing)};
  for (int a = 0; a < 3; ++a)
    c.bodies[0].velocity[a] = fmt::format("{}*x + {}*y + {}*z", rate(a, 0), rate(a, 1), rate(a, 2));
  return c;
}

// Hencky's strain, by an eigenvalue decomposition.
Eigen::Matrix3d log_strain(const Eigen::Matrix3d& gradient) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> b(gradient * gradient.transpose());
  const Eigen::Vector3d logarithm = 0.5 * b.eigenvalues().array().log();
  return b.eigenvectors() * logarithm.asDiagonal() * b.eigenvectors().transpose();
}

void expect_strain(const Frame& frame, const Eigen::Matrix3d& due) {
  const Column* strain = find_column(frame, "strain");
  const Column* equivalent = find_column(frame, "equivalent_strain");
  ASSERT_TRUE(strain != nullptr && equivalent != nullptr);
  ASSERT_EQ(strain->components, 6);
  const Eigen::Matrix3d deviator = due - due.trace() / 3.0 * Eigen::Matrix3d::Identity();
  const double due_equivalent = std::sqrt(2.0 / 3.0) * deviator.norm();
  const double tolerance = 5e-3 * due_equivalent;
  const std::array<double, 6> tensor{due(0, 0), due(1, 1), due(2, 2),
                                     due(0, 1), due(1, 2), due(0, 2)};
  int inner = 0;
  for (std::size_t i = 0; i < frame.id.size(); ++i) {
    const auto& x = frame.position[i];
    if (std::hypot(x[0], x[1], x[2]) > 3.0 * spacing) continue;
    ++inner;
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_NEAR(strain->values[6 * i + k], tensor[k], tolerance) << "component " << k;
    EXPECT_NEAR(equivalent->values[i], due_equivalent, tolerance);
  }
  EXPECT_GE(inner, 10);
}

TEST(FrameStrain, IsHenckysInTheCurrentConfiguration) {
  Eigen::Matrix3d rate;
  rate << 300.0, 250.0, 0.0, -100.0, -150.0, 0.0, 0.0, 0.0, 0.0;
  for (const int dimension : {2, 3}) {
    SCOPED_TRACE(dimension);
    if (dimension == 3) rate.row(2) << 80.0, -120.0, 60.0;
    const auto simulation = make_simulation(stretched_block(dimension, rate));
    while (simulation->time() < until) simulation->advance();
    expect_strain(simulation->frame(),
                  log_strain(Eigen::Matrix3d::Identity() + simulation->time() * rate));
  }
}

}  // namespace
}  // namespace kerf::test
