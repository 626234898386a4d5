// SPDX-License-Identifier: Apache-2.0
// Two materials in one piece: the forces of bonds across the interface agree with theory.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

// A square of 40 mm x 40 mm about the origin with an inner disc of a second material of the given
// relative stiffness; `cells`: particles per radius of the disc.
struct Composite {
  static constexpr double radius = 10e-3, clamped = 16e-3;  // m
  double d;                                                 // m, spacing
  SolidLayout<2> layout;

  Composite(double stiffer, int cells) : d(radius / cells) {
    layout = block<2>({.cells = {4 * cells, 4 * cells, 1}, .spacing = d});
    layout.media.push_back(layout.media.front());
    layout.media[1].bulk_modulus *= stiffer;
    layout.media[1].shear_modulus *= stiffer;
    for (std::size_t i = 0; i < layout.reference.size(); ++i) {
      auto& x = layout.reference[i];
      for (int a = 0; a < 2; ++a) x[a] -= 2.0 * radius;
      layout.medium_index[i] = norm(x) < radius ? 1 : 0;
    }
  }
};

// With two equal materials the interface has no effect: strains and forces of a randomly displaced
// and sheared block are those of one material, up to rounding.
TEST(Inclusion, OfTheSameMaterialHasNoEffect) {
  Composite two(1.0, 10), one(1.0, 10);
  one.layout.medium_index.assign(one.layout.reference.size(), 0);
  SolidOnTrial<2, Double> a(two.layout), b(one.layout);
  for (auto* trial : {&a, &b}) {
    trial->map(some_map<2>());
    trial->displace_randomly(0.1 * two.d, 4);
    trial->evaluate();
  }
  double largest = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_LT((as_square(a.gradient(i)) - as_square(b.gradient(i))).cwiseAbs().maxCoeff(), 1e-14);
    largest = std::max(largest, norm(b.force(i)));
    worst = std::max(worst, norm(a.force(i) - b.force(i)));
  }
  EXPECT_LT(worst, 1e-13 * largest);
}

// A disc in an infinite plane that is stretched by e on all sides (plane strain): inside, the
// strain is e (K' + G) / (K'_i + G) everywhere, K' = K + G/3 and K'_i that of the disc; outside,
// the displacement is e r + (A - e) R^2 / r. The outermost particles are fixed at these
// displacements.
struct Theory {
  double far, inside;
  double displacement(double r) const {
    const double R = Composite::radius;
    return r < R ? inside * r : far * r + (inside - far) * R * R / r;
  }
};

Theory theory_of(const Composite& composite, double far) {
  const auto plane = [](const Medium<double>& m) { return m.bulk_modulus + m.shear_modulus / 3.0; };
  const auto& matrix = composite.layout.media[0];
  return {far, far * (plane(matrix) + matrix.shear_modulus) /
                   (plane(composite.layout.media[1]) + matrix.shear_modulus)};
}

// The layout is relaxed by damped steps for several transits of waves across the square.
void relax(SolidOnTrial<2, Double>& trial, const Composite& composite, const Theory& theory) {
  const auto hold = [&] {
    for (std::size_t i = 0; i < trial.size(); ++i) {
      const auto& x = trial.layout.reference[i];
      const double r = norm(x);
      if (r < Composite::clamped) continue;
      trial.position[i] = x + theory.displacement(r) / r * x;
      trial.velocity[i] = Vector<2, double>::zero();
    }
  };
  hold();
  trial.evaluate();
  const auto& matrix = composite.layout.media[0];
  const auto& disc = composite.layout.media[1];
  const double stiffest = std::max(matrix.bulk_modulus, disc.bulk_modulus);
  const double step = 0.25 * composite.d / std::sqrt(2.0 * stiffest / matrix.density);
  const int cells = static_cast<int>(std::lround(Composite::radius / composite.d));
  const double slower = std::sqrt(stiffest / matrix.bulk_modulus);
  for (int n = 0; n < static_cast<int>(150 * slower) * cells; ++n) {
    trial.step(step);
    for (auto& v : trial.velocity) v = (1.0 - 0.3 / cells / slower) * v;
    hold();
  }
}

// Returns the mean of a quantity of the particles between two radii, m.
template <class Quantity>
double mean_between(const SolidOnTrial<2, Double>& trial, double low, double high,
                    const Quantity& quantity) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < trial.size(); ++i) {
    const double r = norm(trial.layout.reference[i]);
    if (r < low || r >= high) continue;
    sum += quantity(i, r);
    count += 1.0;
  }
  return sum / count;
}

struct Errors {
  double strain = 0.0;  // of the mean strain in the disc
  double spread = 0.0;  // deviation of the strains from that
  double stress = 0.0;  // of the radial stress outside over that inside
};

Errors errors_of(double stiffer, int cells) {
  const double far = 1e-5;  // small compared with 1, so that theory is linear
  const Composite composite(stiffer, cells);
  const Theory theory = theory_of(composite, far);
  SolidOnTrial<2, Double> trial(composite.layout);
  relax(trial, composite, theory);
  // The radii are further from the interface than the range of bonds, 2.6 spacings of at most a
  // tenth of R.
  const double R = Composite::radius, core = 0.7 * R;
  const auto strain = [&](std::size_t i, double) {
    return as_square(trial.gradient(i)).trace() / 2.0;
  };
  const double inside = mean_between(trial, 0.0, core, strain);
  const auto straying = [&](std::size_t i, double) {
    return (as_square(trial.gradient(i)) - inside * Square<2>::Identity()).cwiseAbs().maxCoeff();
  };
  const auto radial_stress = [&](std::size_t i, double r) {
    const auto& medium = trial.layout.media[trial.layout.medium_index[i]];
    const Square<2> e = as_square(trial.gradient(i));
    const Eigen::Vector2d n = as_column<2>(trial.layout.reference[i]) / r;
    const double lambda = medium.bulk_modulus - 2.0 / 3.0 * medium.shear_modulus;
    return lambda * e.trace() + 2.0 * medium.shear_modulus * n.dot(e * n);
  };
  // Outside the stress is 2 K' e - 2 G (A - e) R^2 / r^2, which at r = R is that of the inside.
  const double g = composite.layout.media[0].shear_modulus;
  const double plane = composite.layout.media[0].bulk_modulus + g / 3.0;
  const auto theoretical = [&](std::size_t, double r) {
    return 2.0 * plane * far - 2.0 * g * (theory.inside - far) * R * R / (r * r);
  };
  const double step = mean_between(trial, 1.3 * R, 1.5 * R, radial_stress) /
                      mean_between(trial, 0.0, core, radial_stress);
  const double expected = mean_between(trial, 1.3 * R, 1.5 * R, theoretical) / theoretical(0, R);
  return {std::abs(inside / theory.inside - 1.0), mean_between(trial, 0.0, core, straying) / inside,
          std::abs(step / expected - 1.0)};
}

TEST(Inclusion, WithoutContrastTheStrainIsUniform) {
  const Errors errors = errors_of(1.0, 10);
  EXPECT_LT(errors.strain, 1e-4);
  EXPECT_LT(errors.spread, 1e-4);
  EXPECT_LT(errors.stress, 1e-4);
}

// The width of the interface is the length of bonds, a quarter of the radius at ten spacings: its
// effect halves with the spacing.
TEST(Inclusion, StiffOrSoftHasTheStrainOfTheory) {
  const Errors soft = errors_of(0.2, 10), stiff = errors_of(10.0, 10), fine = errors_of(10.0, 20);
  for (const Errors& errors : {soft, stiff, fine})
    fmt::print("strain off by {:.4f}, spread by {:.4f}, stress off by {:.4f}\n", errors.strain,
               errors.spread, errors.stress);
  for (const Errors& errors : {soft, stiff}) {
    EXPECT_LT(errors.strain, 0.1);
    EXPECT_LT(errors.spread, 0.02);
    EXPECT_LT(errors.stress, 0.04);
  }
  EXPECT_LT(fine.strain, 0.6 * stiff.strain);
  EXPECT_LT(fine.spread, 0.01);
  EXPECT_LT(fine.stress, 0.6 * stiff.stress);
}

}  // namespace
}  // namespace kerf::test
