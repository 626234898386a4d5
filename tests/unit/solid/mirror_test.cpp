// SPDX-License-Identifier: Apache-2.0
// A solid at symmetry planes against the solid with explicit mirror images.
#include <gtest/gtest.h>

#include <map>

#include "support/mirrored.hpp"
#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

template <int D>
Vector<D, double> as_vector(const Vector3& v) {
  return Vector<D, double>::from(v);
}
template <int D>
Vector3 as_point(const Vector<D, double>& x) {
  Vector3 p = Vector3::Zero();
  for (int a = 0; a < D; ++a) p[a] = x[a];
  return p;
}

constexpr double part_spacing = 1e-3;  // m
constexpr int part_cells = 6;          // along each axis of the part, [0, 6 mm]^D

template <class K>
class MirroredSolid : public testing::Test {
 protected:
  static constexpr int D = K::D;
  using P = typename K::P;
  using Real = typename P::Real;
  using Trial = SolidOnTrial<D, P>;
  // The tolerance is that of sums over the same bonds in another order.
  static constexpr double tolerance = std::is_same_v<Real, float> ? 2e-5 : 1e-12;

  struct Pair {
    MirrorPlanes<D> planes;
    std::vector<MirrorCode> codes;
    Trial part, full;
  };

  // Two media of one piece are at the planes; a third one is at none of them.
  static SolidLayout<D> layout_of_part(const MirrorPlanes<D>& planes, bool viscous, bool flows) {
    auto layout =
        block<D>({.cells = {part_cells, part_cells, part_cells}, .jitter = 0.2, .seed = 5});
    layout.mirrors = planes;
    layout.media[0].joined_mirrors = planes.faces;
    if (viscous) layout.media[0].artificial_linear = layout.media[0].artificial_quadratic = 0.8;
    layout.media[0].failure_strain = 0.16;
    auto stiff = layout.media[0];
    stiff.density = 2000.0;
    stiff.bulk_modulus *= 3.0;
    stiff.smoothing_length = 1.4e-3;
    auto apart = stiff;
    apart.piece = 1;
    apart.joined_mirrors = 0;
    layout.media.insert(layout.media.end(), {stiff, apart});
    for (std::size_t i = 0; i < layout.reference.size(); ++i)
      layout.medium_index[i] = static_cast<std::uint16_t>(i % 7 == 0 ? 2 : i % 3 == 0 ? 1 : 0);
    if (flows)
      for (Medium<double>& medium : layout.media) {
        medium.plastic.law = PlasticLaw::von_mises;
        medium.plastic.von_mises = {4e3, 1e4, 0.0, 1.0};
      }
    return layout;
  }

  static SolidLayout<D> layout_of_whole(const SolidLayout<D>& part,
                                        const std::vector<MirrorCode>& codes) {
    SolidLayout<D> full;
    for (std::size_t c = 0; c < codes.size(); ++c) {
      for (Medium<double> medium : part.media) {
        if (medium.joined_mirrors == 0) medium.piece = static_cast<std::uint16_t>(10 + c);
        medium.joined_mirrors = 0;
        full.media.push_back(medium);
      }
      for (std::size_t i = 0; i < part.reference.size(); ++i) {
        full.reference.push_back(
            as_vector<D>(mirrored_place(part.mirrors, codes[c], as_point(part.reference[i]))));
        full.medium_index.push_back(
            static_cast<std::uint16_t>(part.medium_index[i] + c * part.media.size()));
      }
    }
    return full;
  }

  static Pair pair(const std::string& faces, bool viscous = false, bool flows = false) {
    const auto planes = planes_of<D>(faces, part_cells * part_spacing);
    const auto layout = layout_of_part(planes, viscous, flows);
    const auto codes = images_of(planes);
    return {planes, codes, Trial(layout), Trial(layout_of_whole(layout, codes))};
  }

  // The mirrored motion of the part is that of each copy. The planes are fixed: only particles
  // between them move.
  static void deform(Pair& both, double stretch, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const std::size_t n = both.part.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (int a = 0; a < D; ++a) {
        both.part.position[i][a] = both.part.layout.reference[i][a] * (1.0 + stretch) +
                                   0.08 * part_spacing * uniform(engine);
        both.part.velocity[i][a] = static_cast<Real>(2.0 * uniform(engine));
      }
      for (std::size_t c = 0; c < both.codes.size(); ++c) {
        const auto x = as_point(both.part.position[i]);
        const auto v = as_point(Vector<D, double>::from(both.part.velocity[i]));
        both.full.position[c * n + i] = as_vector<D>(mirrored_place(both.planes, both.codes[c], x));
        both.full.velocity[c * n + i] =
            Vector<D, Real>::from(as_vector<D>(mirrored_vector(both.planes, both.codes[c], v)));
      }
    }
    both.part.deform();
    both.full.deform();
  }

  static void accelerate(Trial& trial) {
    to_device(trial.velocity, trial.device_velocity);
    trial.solid.accelerate(trial.device_velocity);
  }

  static void expect_same(Pair& both) {
    accelerate(both.part);
    accelerate(both.full);
    double force_scale = 0.0, force_error = 0.0, gradient_error = 0.0, mirrored = 0.0;
    for (std::size_t i = 0; i < both.part.size(); ++i) {
      force_scale = std::max(force_scale, norm(both.full.force(i)));
      force_error = std::max(force_error, norm(both.part.force(i) - both.full.force(i)));
      const auto own = as_square<D>(both.part.gradient(i));
      const auto due = as_square<D>(both.full.gradient(i));
      gradient_error = std::max(gradient_error, (own - due).cwiseAbs().maxCoeff());
      mirrored += norm(Vector<D, Real>(both.part.solid.fields().mirror_acceleration[i]));
      EXPECT_EQ(both.part.solid.fields().detached[i], both.full.solid.fields().detached[i]);
    }
    EXPECT_LE(force_error, tolerance * force_scale);
    EXPECT_LE(gradient_error, tolerance);
    EXPECT_GT(mirrored, 0.0);
    if (both.codes.size() % 3 == 0) return;  // between two planes there are more images
    // The part has its share of the energy of the full solid.
    const double share = 1.0 / static_cast<double>(both.codes.size());
    const auto energy = both.part.solid.energy(), full = both.full.solid.energy();
    EXPECT_NEAR(energy.elastic, share * full.elastic, 10.0 * tolerance * energy.total());
    EXPECT_NEAR(energy.hourglass, share * full.hourglass, 10.0 * tolerance * energy.total());
    EXPECT_NEAR(both.part.solid.viscous_power(), share * both.full.solid.viscous_power(),
                10.0 * tolerance * both.part.solid.viscous_power());
  }

  // The bonds of each particle of the part equal those in the full solid, in any order, and in the
  // same state.
  static void expect_same_bonds(Pair& both) {
    const auto n = static_cast<Index>(both.part.size());
    const auto a = both.part.solid.view(), b = both.full.solid.view();
    std::map<MirrorCode, Index> copy;
    for (std::size_t c = 0; c < both.codes.size(); ++c) copy[both.codes[c]] = static_cast<Index>(c);
    for (Index i = 0; i < n; ++i) {
      std::map<Index, bool> own, due;
      for (Index k = a.bonds.first(i); k < a.bonds.last(i); ++k) {
        const Index entry = a.bonds.end(i, k);
        own[copy.at(both.planes.code(entry)) * n + both.planes.particle(entry)] = a.is_intact(i, k);
      }
      for (Index k = b.bonds.first(i); k < b.bonds.last(i); ++k)
        due[b.bonds.end(i, k)] = b.is_intact(i, k);
      EXPECT_EQ(own, due) << "particle " << i;
    }
  }
};
TYPED_TEST_SUITE(MirroredSolid, TwoKinds);

TYPED_TEST(MirroredSolid, ForcesAndDeformation) {
  for (const char* faces : {"x-", "y+", "x- y-", "x- x+ y+"}) {
    auto both = TestFixture::pair(faces);
    TestFixture::deform(both, 0.0, 3);
    TestFixture::expect_same_bonds(both);
    TestFixture::expect_same(both);
  }
}

TYPED_TEST(MirroredSolid, Viscosity) {
  auto both = TestFixture::pair("x- y-", true);
  TestFixture::deform(both, 0.0, 4);
  TestFixture::expect_same(both);
}

// The test includes the hourglass viscosity of plastic flow, and the plastic work.
TYPED_TEST(MirroredSolid, Flow) {
  auto both = TestFixture::pair("x- y-", true, true);
  for (unsigned seed : {5u, 6u}) {
    TestFixture::deform(both, 0.0, seed);
    const double share = 1.0 / static_cast<double>(both.codes.size());
    const double work = both.part.solid.keep_flow();
    EXPECT_GT(work, 0.0);
    EXPECT_NEAR(work, share * both.full.solid.keep_flow(), 10.0 * TestFixture::tolerance * work);
    TestFixture::deform(both, 0.0, seed);
    TestFixture::expect_same(both);
  }
}

// Both ends of a bond reach the same decision, as in the full solid. The solid is stretched from
// the planes.
TYPED_TEST(MirroredSolid, Breaks) {
  if (!std::is_same_v<typename TypeParam::Real, double>)
    return;  // the state of a bond at its limit depends on rounding
  auto both = TestFixture::pair("x- y-");
  TestFixture::deform(both, 0.12, 7);
  const auto part = both.part.solid.fracture();
  const auto full = both.full.solid.fracture();
  EXPECT_GT(full.bonds, 0u);
  EXPECT_EQ(full.detached, part.detached * both.codes.size());
  const double share = 1.0 / static_cast<double>(both.codes.size());
  EXPECT_NEAR(part.released, share * full.released, 1e-10 * std::abs(part.released));
  TestFixture::expect_same_bonds(both);
  TestFixture::expect_same(both);
}

// The force of the images is the part that does not cancel in the sum of all forces, and is normal
// to the plane.
TYPED_TEST(MirroredSolid, ForceOfImagesIsRecorded) {
  constexpr int dimension = TypeParam::D;
  auto both = TestFixture::pair("x-", true);
  TestFixture::deform(both, 0.0, 8);
  TestFixture::accelerate(both.part);
  auto sum = Vector<dimension, double>::zero(), recorded = sum;
  double scale = 0.0;
  for (std::size_t i = 0; i < both.part.size(); ++i) {
    const double m = both.part.layout.media[both.part.layout.medium_index[i]].mass;
    const Vector<dimension, typename TypeParam::Real> by_images =
        both.part.solid.fields().mirror_acceleration[i];
    sum += both.part.force(i);
    recorded += m * Vector<dimension, double>::from(by_images);
    scale += norm(both.part.force(i));
  }
  EXPECT_LE(norm(sum - recorded), TypeParam::rounding * scale);
  for (int a = 1; a < dimension; ++a) EXPECT_LE(std::abs(recorded[a]), TypeParam::rounding * scale);
  EXPECT_GT(std::abs(recorded[0]), 1e-3 * scale);
}

}  // namespace
}  // namespace kerf::test
