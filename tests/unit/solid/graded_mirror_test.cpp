// SPDX-License-Identifier: Apache-2.0
// A graded solid at symmetry planes has the gradient correction of the whole with explicit mirror
// images.
#include <algorithm>
#include <map>

#include "support/graded_blocks.hpp"
#include "support/mirrored.hpp"

namespace kerf::test {
namespace {

template <class K>
class GradedMirror : public testing::Test {
 protected:
  static constexpr int D = K::D;
  static constexpr double width = 8e-3;  // m, of the part: four coarse cells

  // The fine region touches the planes in some places, and coarse particles do in others.
  static SolidLayout<D> part(const MirrorPlanes<D>& planes) {
    auto layout = graded_block<D>({.cells = {4, 4, 4}}, soft_solid(1e-3, D),
                                  [](const Vector<D, double>& middle) {
                                    double sum = 0.0;
                                    for (int a = 0; a < D; ++a) sum += middle[a];
                                    return sum > 0.9 * width;
                                  });
    layout.mirrors = planes;
    for (Medium<double>& medium : layout.media) medium.joined_mirrors = planes.faces;
    return layout;
  }
  // Copy c of particle i is particle c n + i.
  static SolidLayout<D> whole(const SolidLayout<D>& part) {
    SolidLayout<D> all = part;
    all.mirrors = {};
    for (Medium<double>& medium : all.media) medium.joined_mirrors = 0;
    all.reference.clear();
    all.medium_index.clear();
    for (const MirrorCode code : images_of(part.mirrors))
      for (std::size_t i = 0; i < part.reference.size(); ++i) {
        Vector3 x = Vector3::Zero();
        for (int a = 0; a < D; ++a) x[a] = part.reference[i][a];
        all.reference.push_back(Vector<D, double>::from(mirrored_place(part.mirrors, code, x)));
        all.medium_index.push_back(part.medium_index[i]);
      }
    return all;
  }
  struct FactorGap {
    double error = 0.0, of_images = 0.0;  // largest difference of a factor; from 1, of images
  };
  static FactorGap compare(const SolidLayout<D>& part, const SolidLayout<D>& whole) {
    constexpr double accuracy = 1e-11;
    const BondLists own = BondFinder<D>(part).find(), full = BondFinder<D>(whole).find();
    const BondFit fit = LevelFit<D>(part, own, accuracy).solve(),
                  due = LevelFit<D>(whole, full, accuracy).solve();
    const auto codes = images_of(part.mirrors);
    const auto n = static_cast<Index>(part.reference.size());
    FactorGap gap;
    for (Index i = 0; i < n; ++i) {
      EXPECT_EQ(fit.fitted[i], due.fitted[i]);
      std::map<Index, std::pair<double, double>> factors;  // of the whole
      for (Index k = full.begin[i]; k < full.begin[i + 1]; ++k)
        factors[full.neighbour[k]] = {due.of_bond[k], due.of_pair[k]};
      EXPECT_EQ(factors.size(), own.begin[i + 1] - own.begin[i]);
      for (Index k = own.begin[i]; k < own.begin[i + 1]; ++k) {
        const Index end = own.neighbour[k];
        const auto copy = std::find(codes.begin(), codes.end(), part.mirrors.code(end));
        const auto [bond, pair] =
            factors.at(static_cast<Index>(copy - codes.begin()) * n + part.mirrors.particle(end));
        gap.error =
            std::max({gap.error, std::abs(fit.of_bond[k] - bond), std::abs(fit.of_pair[k] - pair)});
        if (copy != codes.begin()) gap.of_images = std::max(gap.of_images, std::abs(bond - 1.0));
      }
    }
    return gap;
  }
};
TYPED_TEST_SUITE(GradedMirror, DoubleOnly);

TYPED_TEST(GradedMirror, FactorsAreThoseOfTheWhole) {
  constexpr int dimension = TypeParam::D;
  for (const char* faces : {"x-", "y+", "x- y-", "x+ y-"}) {
    const auto planes = planes_of<dimension>(faces, TestFixture::width);
    const auto part = TestFixture::part(planes);
    const auto gap = TestFixture::compare(part, TestFixture::whole(part));
    // The systems are the same, and solved by as many steps but for rounding.
    EXPECT_LE(gap.error, 1e-8) << faces;
    EXPECT_GT(gap.of_images, 0.05) << faces;
  }
}

}  // namespace
}  // namespace kerf::test
