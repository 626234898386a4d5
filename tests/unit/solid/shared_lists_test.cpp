// SPDX-License-Identifier: Apache-2.0
// Particles of a regular layout share their lists of bonds (solid/share_lists.hpp). The same body
// with randomly numbered particles shares none, and must give the same results.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

// A regular body and the same body in another order; `place`: index of each particle in that order.
template <class Chosen>
class SharedLists : public testing::Test {
 protected:
  static constexpr int D = Chosen::D;
  using Trial = SolidOnTrial<D, typename Chosen::P>;

  struct Both {
    std::vector<std::size_t> place;
    Trial in_rows, mixed_up;

    explicit Both(const SolidLayout<D>& layout)
        : in_rows(layout), mixed_up(shuffled(layout, place)) {}

    // Both bodies are moved to f(X) with the velocity v(X).
    template <class Map, class Flow>
    void move(const Map& f, const Flow& v) {
      for (Trial* trial : {&in_rows, &mixed_up}) {
        for (std::size_t i = 0; i < trial->size(); ++i) {
          trial->position[i] = f(trial->layout.reference[i]);
          trial->velocity[i] =
              Vector<D, typename Chosen::Real>::from(v(trial->layout.reference[i]));
        }
        trial->evaluate();
      }
    }
    // Compares the values of all particles.
    void expect_same_forces() {
      double scale = 0.0, power = 0.0;
      for (std::size_t i = 0; i < in_rows.size(); ++i) {
        scale = std::max(scale, norm(in_rows.force(i)));
        power = std::max<double>(power, in_rows.solid.fields().viscous_power[i]);
      }
      for (std::size_t i = 0; i < in_rows.size(); ++i) {
        const std::size_t j = place[i];
        ASSERT_LE(norm(in_rows.force(i) - mixed_up.force(j)), 2.0 * Chosen::rounding * scale);
        ASSERT_NEAR(in_rows.solid.fields().viscous_power[i],
                    mixed_up.solid.fields().viscous_power[j], 2.0 * Chosen::rounding * power);
        for (int k = 0; k < D * D; ++k)
          ASSERT_NEAR(in_rows.gradient(i).component[k], mixed_up.gradient(j).component[k],
                      Chosen::rounding);
      }
    }
  };

  static SolidLayout<D> shuffled(SolidLayout<D> layout, std::vector<std::size_t>& place) {
    place.resize(layout.reference.size());
    std::iota(place.begin(), place.end(), std::size_t(0));
    std::shuffle(place.begin(), place.end(), std::mt19937(11));
    const auto rows = layout;
    for (std::size_t i = 0; i < place.size(); ++i) {
      layout.reference[place[i]] = rows.reference[i];
      layout.medium_index[place[i]] = rows.medium_index[i];
    }
    return layout;
  }
  static SolidLayout<D> body(double failure_strain = 0.0) {
    auto medium = soft_solid(1e-3, D);
    medium.artificial_linear = medium.artificial_quadratic = 1.0;
    medium.failure_strain = failure_strain;
    return block<D>({.cells = {18, 15, D == 2 ? 1 : 12}}, medium);
  }
  // The deformation is uneven, up to a tenth; the velocity shortens some bonds and stretches
  // others.
  static Vector<D, double> bend(const Vector<D, double>& x) {
    auto y = x;
    for (int a = 0; a < D; ++a) y[a] += 2e-4 * std::sin(400.0 * x[(a + 1) % D] + a);
    return y;
  }
  static Vector<D, double> flow(const Vector<D, double>& x) {
    auto v = Vector<D, double>::zero();
    for (int a = 0; a < D; ++a) v[a] = 2.0 * std::cos(300.0 * x[a] + a);
    return v;
  }
};
TYPED_TEST_SUITE(SharedLists, TwoKinds);

// The inner particles share one list, so there are far fewer entries than bonds.
TYPED_TEST(SharedLists, AreOnePerRow) {
  typename TestFixture::Both both(this->body());
  const auto stored = [](auto& trial) { return trial.solid.fields().bond_entry.size(); };
  EXPECT_EQ(stored(both.mixed_up), both.mixed_up.solid.entries());
  EXPECT_LT(stored(both.in_rows), both.in_rows.solid.entries() / 2);
  EXPECT_EQ(both.in_rows.solid.entries(), both.mixed_up.solid.entries());
}

TYPED_TEST(SharedLists, GiveTheSameForces) {
  typename TestFixture::Both both(this->body());
  both.move(this->bend, this->flow);
  both.expect_same_forces();
}

template <int D>
struct AcrossSlit {
  KERF_FUNCTION bool operator()(const Vector<D, double>& a, const Vector<D, double>& b) const {
    return a[0] < 6e-3 && b[0] < 6e-3 && (a[1] < 7e-3) != (b[1] < 7e-3);
  }
};

// The body has an initial slit and broken bonds.
TYPED_TEST(SharedLists, GiveTheSameBreaks) {
  constexpr int dimension = TypeParam::D;
  typename TestFixture::Both both(this->body(0.12));
  const auto pull = [](const auto& x) {
    auto y = x;
    y[0] *= x[0] > 12e-3 ? 1.05 : 1.0;
    return y;
  };
  both.in_rows.solid.cut(AcrossSlit<dimension>{});
  both.mixed_up.solid.cut(AcrossSlit<dimension>{});
  both.move(pull, this->flow);
  const auto rows = both.in_rows.solid.fracture(), multi_material = both.mixed_up.solid.fracture();
  EXPECT_GT(rows.bonds, 100u);
  EXPECT_EQ(rows.bonds, multi_material.bonds);
  EXPECT_NEAR(rows.released, multi_material.released, 10.0 * TypeParam::rounding * rows.released);
  both.move(this->bend, this->flow);
  both.expect_same_forces();
}

// There is no total force or torque, although the rounding is equal for all inner particles here
// and accumulates.
TYPED_TEST(SharedLists, GiveZeroTotalForce) {
  constexpr int dimension = TypeParam::D;
  using Position = Vector<dimension, double>;
  typename TestFixture::Both both(this->body());
  const auto stretch = [](Position x) {
    for (int a = 0; a < dimension; ++a) x[a] *= 1.05 + 0.05 * a;
    return x;
  };
  const auto at_rest = [](const Position&) { return Position::zero(); };
  for (const bool even : {true, false}) {
    if (even)
      both.move(stretch, at_rest);
    else
      both.move(this->bend, this->flow);
    auto sum = Position::zero();
    double torque = 0.0, scale = 0.0, arm = 0.0;
    for (std::size_t i = 0; i < both.in_rows.size(); ++i) {
      const auto f = both.in_rows.force(i);
      const auto& x = both.in_rows.position[i];
      sum += f;
      scale += norm(f);
      torque += x[0] * f[1] - x[1] * f[0];
      arm += norm(x) * norm(f);
    }
    EXPECT_LE(norm(sum), TypeParam::rounding * scale);
    EXPECT_LE(std::abs(torque), TypeParam::rounding * arm);
  }
}

}  // namespace
}  // namespace kerf::test
