// SPDX-License-Identifier: Apache-2.0
// Fracture in a run: the broken particles, their state, and the released energy, against a run with
// a material that cannot break.
#include <algorithm>
#include <cmath>
#include <set>

#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

Case stretched(int dimension, double failure_strain) {
  Case c = empty_case(dimension, PrecisionKind::double_precision);
  c.materials[0].failure_strain = failure_strain;
  const double z = dimension == 3 ? 0.007 : 0.0;
  c.bodies = {body("block", Role::elastic, box({-0.013, -0.007, -z}, {0.013, 0.007, z}), 2e-3)};
  c.bodies[0].velocity = {"150*x", "-60*y", "20*x"};
  return c;
}

const std::vector<float>& column(const Frame& frame, const std::string& name) {
  return std::find_if(frame.columns.begin(), frame.columns.end(),
                      [&](const Column& c) { return c.name == name; })
      ->values;
}

std::set<std::uint32_t> fractured(const Frame& frame) {
  std::set<std::uint32_t> ids;
  for (std::size_t k = 0; k < frame.id.size(); ++k)
    if (frame.category[k] == Category::fractured) ids.insert(frame.id[k]);
  return ids;
}

// sqrt(2/3 e':e') with e' = s/2G, and s:s / (4 G rho) m, of row k: xx yy zz xy yz xz.
double square_of_stress(const Frame& frame, std::size_t k) {
  const auto& s = column(frame, "deviatoric_stress");
  double sum = 0.0;
  for (std::size_t c = 0; c < 6; ++c)
    sum += (c < 3 ? 1.0 : 2.0) * std::pow(static_cast<double>(s[6 * k + c]), 2);
  return sum;
}

void expect_first_fracture(int dimension) {
  const double shear_modulus = 1e5 / 2.6;
  const auto breaking = make_simulation(stretched(dimension, 0.1));
  const auto twin = make_simulation(stretched(dimension, 0.0));
  while (breaking->balance().mass_fractured == 0.0) {
    breaking->advance();
    twin->advance();
    ASSERT_LT(breaking->time(), 5e-3) << "nothing breaks";
  }
  ASSERT_EQ(breaking->time(), twin->time());
  const Frame broken = breaking->frame(), whole = twin->frame();
  EXPECT_TRUE(fractured(whole).empty());
  std::set<std::uint32_t> due;
  double energy = 0.0;
  for (std::size_t k = 0; k < whole.id.size(); ++k) {
    const double square = square_of_stress(whole, k);
    if (std::sqrt(2.0 / 3.0 * square) / (2.0 * shear_modulus) <= 0.1) continue;
    due.insert(whole.id[k]);
    energy += static_cast<double>(whole.mass[k]) * square /
              (4.0 * shear_modulus * static_cast<double>(whole.density[k]));
  }
  EXPECT_EQ(fractured(broken), due);
  EXPECT_LT(due.size(), whole.id.size());  // the criterion must not break all particles at once
  EXPECT_NEAR(breaking->balance().dissipated_fracture, energy, 1e-5 * energy);
}
TEST(Fracture, ParticlesBreakAboveTheFailureStrain2D) {
  expect_first_fracture(2);
}
TEST(Fracture, ParticlesBreakAboveTheFailureStrain3D) {
  expect_first_fracture(3);
}

void expect_no_tension_in_what_broke(const Frame& frame) {
  const auto& strain = column(frame, "equivalent_strain");
  for (std::size_t k = 0; k < frame.id.size(); ++k) {
    if (frame.category[k] == Category::fractured) {
      EXPECT_GE(frame.pressure[k], 0.0f);
      EXPECT_EQ(square_of_stress(frame, k), 0.0);
    } else {
      EXPECT_LE(strain[k], 0.1f);
    }
  }
}

void expect_broken_stays_broken(int dimension) {
  const auto simulation = make_simulation(stretched(dimension, 0.1));
  std::set<std::uint32_t> before;
  for (int n = 0; n < 150; ++n) {
    simulation->advance();
    const Frame frame = simulation->frame();
    const auto now = fractured(frame);
    ASSERT_TRUE(std::includes(now.begin(), now.end(), before.begin(), before.end()));
    expect_no_tension_in_what_broke(frame);
    before = now;
  }
  EXPECT_FALSE(before.empty());
  // Sums of the same numbers, in other groups (parallel/group_sum.hpp): four roundings.
  EXPECT_DOUBLE_EQ(simulation->balance().mass_now, simulation->balance().mass_initial);
}
TEST(Fracture, FracturedParticlesCarryCompressionOnly2D) {
  expect_broken_stays_broken(2);
}
TEST(Fracture, FracturedParticlesCarryCompressionOnly3D) {
  expect_broken_stays_broken(3);
}

}  // namespace
}  // namespace kerf::test
