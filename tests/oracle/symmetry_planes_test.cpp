// SPDX-License-Identifier: Apache-2.0
// Pair sums of a part between symmetry planes against plain double loops over the part and explicit
// mirror images, without planes.
#include <gtest/gtest.h>

#include "support/gap.hpp"
#include "support/mirrored.hpp"
#include "support/standard_mixture.hpp"

namespace kerf::test {
namespace {

template <class K>
class SymmetryPlanes : public testing::Test {
 protected:
  static constexpr int D = K::D;
  using P = typename K::P;
  using Real = typename P::Real;
  // As in standard_rates_test.cpp: rounding of sums in another order, or of single precision.
  static constexpr double tolerance = std::is_same_v<P, Double> ? 1e-12 : 1e-4;

  // `splits`: SIMD kernels sum the pairs of fluids, else the general pair loop sums all.
  static LoadedStandard<D, P> evaluated(const ReferenceState& part, const MirrorPlanes<D>& planes,
                                        bool splits) {
    LoadedStandard<D, P> loaded(part, {.minimum = 0.0, .maximum = 0.03, .splits = splits});
    loaded.particles.mirrors = planes;
    loaded.rebuild();
    evaluate_standard(part, loaded);
    evaluate_standard(part, loaded);  // with normals of walls
    return loaded;
  }

  // The planes are in some faces of [0, per_side mm]^D. The first of the solids is one piece with
  // its images, the other is not.
  static void compare(const std::string& faces, int per_side, unsigned seed) {
    auto part = standard_mixture(D, seed, per_side);
    const auto planes = planes_of<D>(faces, per_side * mixture_spacing);
    stiffen_volume(part);
    part.media[2].joined_mirrors = part.media[3].joined_mirrors = planes.faces;
    if (faces == "x-") part.gravity = {0.0, -9810.0, D == 3 ? 700.0 : 0.0};
    const auto whole = whole_of(part, planes);
    const std::size_t n = part.particles.size();
    const ReferenceStandard oracle(
        whole,
        [&](std::size_t i, std::size_t j) {
          return whole.medium(i).piece == whole.medium(j).piece && mixture_bonded(i % n, j % n);
        },
        ReferenceStandard::Normals::known);
    for (const bool splits : {false, true}) compare(part, evaluated(part, planes, splits), oracle);
  }

  // Water with shocks: the SIMD kernels against the general pair loop.
  static void compare_loops(const std::string& faces, int per_side, unsigned seed) {
    auto part = standard_mixture(D, seed, per_side);
    const auto planes = planes_of<D>(faces, per_side * mixture_spacing);
    for (auto& medium : part.media) {
      if (medium.phase != Phase::water) continue;
      medium.equation_of_state = EquationOfState::shock_hugoniot;
      medium.shock_hugoniot.slope = 2.0;
    }
    const auto by_kernels = evaluated(part, planes, true), by_loop = evaluated(part, planes, false);
    const auto here = by_kernels.places(), there = by_loop.places();
    Gap total, continuity, by_images;
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (part.medium(i).phase == Phase::rigid) continue;
      const auto &a = by_kernels.particles, &b = by_loop.particles;
      const std::size_t k = here[i], n = there[i];
      total.add(of(a.acceleration[k]), of(b.acceleration[n]));
      by_images.add(of(a.mirror_acceleration[k]), of(b.mirror_acceleration[n]));
      continuity.add(a.compression_rate[k], b.compression_rate[n]);
    }
    for (const Gap& gap : {total, continuity, by_images}) {
      EXPECT_GT(gap.scale, 0.0);
      EXPECT_LE(gap.error, tolerance * gap.scale);
    }
  }

  static void compare(const ReferenceState& part, const LoadedStandard<D, P>& loaded,
                      const ReferenceStandard& oracle) {
    const auto place = loaded.places();
    const auto& p = loaded.particles;
    Gap pressure, continuity, energy, pressure_force, damping, total, from_rigid;
    Vector3 sum = Vector3::Zero(), booked = Vector3::Zero();
    double scale = 0.0;
    for (std::size_t i = 0; i < place.size(); ++i) {
      if (part.medium(i).phase == Phase::rigid) continue;
      const StandardRate& due = oracle.rates()[i];
      const std::size_t k = place[i];
      const double m = part.medium(i).mass;
      pressure.add(p.pressure[k], due.pressure);
      continuity.add(p.compression_rate[k], due.compression_rate);
      energy.add(p.repulsion_potential[k], due.contact_energy / m);
      pressure_force.add(of(p.pressure_acceleration[k]), due.pressure_force / m);
      damping.add(of(p.damping_acceleration[k]), due.damping / m);
      from_rigid.add(of(p.repulsion[k]), due.from_rigid / m);
      total.add(of(p.acceleration[k]), oracle.force(i) / m + part.gravity);
      sum += m * (of(p.acceleration[k]) - part.gravity);
      booked += m * (of(p.repulsion[k]) + of(p.mirror_acceleration[k]));
      scale += m * of(p.mirror_acceleration[k]).norm();
    }
    for (const Gap& gap :
         {pressure, continuity, energy, pressure_force, damping, total, from_rigid}) {
      EXPECT_GT(gap.scale, 0.0);
      EXPECT_LE(gap.error, tolerance * gap.scale);
    }
    // All external forces on the part are recorded: those of rigid bodies and of images.
    EXPECT_GT(scale, 0.0);
    EXPECT_LE((sum - booked).norm(), tolerance * (scale + sum.norm()));
  }

 private:
  static Vector3 of(const Vector<D, Real>& v) { return as_eigen(v); }
};
TYPED_TEST_SUITE(SymmetryPlanes, OtherTwoKinds);

TYPED_TEST(SymmetryPlanes, One) {
  for (unsigned seed : {1u, 2u}) TestFixture::compare("x-", TypeParam::D == 2 ? 14 : 7, seed);
  TestFixture::compare("y+", TypeParam::D == 2 ? 14 : 7, 3);
}

TYPED_TEST(SymmetryPlanes, TwoThatCross) {
  TestFixture::compare("x- y+", TypeParam::D == 2 ? 14 : 7, 4);
}

TYPED_TEST(SymmetryPlanes, ThreeThatCross) {
  if (TypeParam::D == 3) TestFixture::compare("x+ y- z-", 6, 5);
}

TYPED_TEST(SymmetryPlanes, WaterWithShocks) {
  TestFixture::compare_loops("x- y+", TypeParam::D == 2 ? 14 : 7, 7);
}

// The planes are so far apart that no image of an image is within reach, also in contact.
TYPED_TEST(SymmetryPlanes, TwoAcross) {
  if (TypeParam::D == 2) TestFixture::compare("y- y+", 22, 6);
}

}  // namespace
}  // namespace kerf::test
