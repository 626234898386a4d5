// SPDX-License-Identifier: Apache-2.0
// Breaks, detachments and compressive failures never raise the energy that a solid stores: random
// states, and the total over all particles by sums of this test.
#include <gtest/gtest.h>

#include "support/plastic_paths.hpp"
#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

template <int D>
using Column = Eigen::Matrix<double, D, 1>;

struct Material {
  double poisson_ratio;
  BondCriterion criterion;
  ElasticLaw law = ElasticLaw::neo_hookean;
  double rate_exponent = 0.0;  // of its strength
};
template <int D>
Medium<double> medium_of(const Material& material) {
  auto medium = soft_solid(1e-3, D);
  const auto moduli = ElasticModuli<double>::of(1e5, material.poisson_ratio);
  medium.bulk_modulus = bond_bulk_modulus(moduli.bulk_modulus, moduli.shear_modulus);
  medium.shear_modulus = moduli.shear_modulus;
  medium.elasticity = material.law;
  medium.criterion = material.criterion;
  medium.failure_strain = 0.1;
  if (material.criterion == BondCriterion::crack_band) medium.softening_strain = 0.03;
  if (material.criterion == BondCriterion::principal_stress)
    medium.principal_stress.tensile_strength = 1e4;
  medium.strength_rate = {material.rate_exponent, 1.0};
  return medium;
}

// The share of the hourglass control that softening left at the start of the step.
template <int D, class P>
double undamaged_at_start(SolidOnTrial<D, P>& trial, Index i) {
  const auto& medium = trial.layout.media[0];
  return medium.softens()
             ? undamaged_share(medium, double(trial.solid.view().softening_strain_at_start(i)))
             : 1.0;
}

// The stored energy of all particles: fits and misfits over the intact bonds from the positions,
// and the share that the solid keeps as a state. The law is evaluated in double.
template <int D, class P>
double stored_energy(SolidOnTrial<D, P>& trial) {
  const auto solid = trial.solid.view();
  double sum = 0.0;
  for (Index i = 0; i < trial.size(); ++i) {
    if (solid.detached[i]) continue;
    const auto& medium = trial.layout.media[0];
    Square<D> moment = Square<D>::Zero(), shape = Square<D>::Zero();
    std::vector<std::array<Column<D>, 2>> bonds;
    std::vector<double> weights;
    for (Index k = solid.bonds.first(i); k < solid.bonds.last(i); ++k) {
      if (!solid.is_intact(i, k)) continue;
      const Index j = solid.bonds.end(i, k);
      const Column<D> reference = as_column(trial.layout.reference[j] - trial.layout.reference[i]);
      const Column<D> current = as_column(trial.position[j] - trial.position[i]);
      const double weight = intact_weight<D>(medium, medium, reference.norm());
      moment += weight * reference * reference.transpose();
      shape += weight * current * reference.transpose();
      bonds.push_back({reference, current});
      weights.push_back(weight);
    }
    const Square<D> f = shape * moment.inverse();
    double misfit = 0.0;
    for (std::size_t k = 0; k < bonds.size(); ++k)
      misfit += weights[k] * (f * bonds[k][0] - bonds[k][1]).squaredNorm();
    auto h = Matrix<D, double>::zero();
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) h(a, b) = f(a, b) - (a == b ? 1.0 : 0.0);
    const auto green = green_strain(h);
    const double undamaged =
        medium.softens() ? undamaged_share(medium, double(solid.softening_strain(i))) : 1.0;
    const double density = energy_density(softened(medium, green, undamaged), green);
    const double share = solid.elastic_share[i], control = undamaged_at_start(trial, i);
    sum += share * (medium.reference_volume() * density +
                    0.5 * control * control * medium.hourglass_modulus() * misfit);
  }
  return sum;
}
// A random smooth map, squeezed as a whole, with a band that opens and noise.
template <int D, class P>
void deform(SolidOnTrial<D, P>& trial, double squeeze, double opening, double noise,
            unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Square<D> map = squeeze * Square<D>::Identity();
  for (int a = 0; a < D; ++a)
    for (int b = 0; b < D; ++b) map(a, b) += 0.05 * uniform(engine);
  map = rotation<D>(uniform(engine)) * map;
  Column<D> normal = Column<D>::Zero();
  for (int a = 0; a < D; ++a) normal[a] = uniform(engine);
  normal.normalize();
  const Column<D> centre = Column<D>::Constant(4.2e-3);
  for (std::size_t i = 0; i < trial.size(); ++i) {
    const Column<D> x = as_column(trial.layout.reference[i]);
    const double across = normal.dot(x - centre) / 1e-3;
    const Column<D> y = map * x + opening * 1e-3 * std::clamp(across, -0.5, 0.5) * normal;
    for (int a = 0; a < D; ++a) trial.position[i][a] = y[a] + noise * 1e-3 * uniform(engine);
  }
  trial.deform(1e-2);  // s, where strength depends on the rate
}

template <class Chosen>
class BreakEnergySign : public testing::Test {
 protected:
  static constexpr int dimension = Chosen::D;
  using Trial = SolidOnTrial<dimension, typename Chosen::P>;
  static constexpr bool is_single = std::is_same_v<typename Chosen::Real, float>;
  // Of the gradients that the solid itself uses.
  static constexpr double rounding = is_single ? 1e-5 : 1e-12;

  std::uint64_t broken_ = 0;
  Index detached_ = 0;
  int limited_ = 0;  // particles whose elastic share fell
  unsigned seed_ = 0;

  // Breaks what breaks at once, four times. total(trial): J
  template <class Total>
  void break_bonds(Trial& trial, const Total& total) {
    for (int again = 0; again < 4; ++again) {
      const double before = total(trial);
      const FractureResult result = trial.solid.fracture();
      const double after = total(trial);
      EXPECT_LE(after, before * (1.0 + rounding));
      EXPECT_GE(result.released, 0.0);
      EXPECT_NEAR(result.released, before - after, rounding * before);
      broken_ += result.bonds;
      detached_ += result.detached;
    }
  }
  // Deforms a block again and again, while its broken bonds accumulate.
  template <class Total>
  void deform_and_break(Trial& trial, double squeeze, const Total& total) {
    for (const double opening : {0.1, 0.3, 0.6, -0.3, 1.0}) {
      deform(trial, squeeze, opening, 0.1, ++seed_);
      break_bonds(trial, total);
      if (opening == 0.3) {
        trial.solid.keep_loading();
        trial.solid.keep_softening();
        trial.solid.keep_flow();
        trial.solid.keep_damage(1e-3);
      }
    }
    for (const auto share : to_host(trial.solid.fields().elastic_share)) {
      EXPECT_GE(share, 0.0);
      EXPECT_LE(share, 1.0);
      limited_ += share < 0.99;
    }
  }
  template <class Total>
  void try_all(const Medium<double>& medium, const Total& total) {
    for (const double jitter : {0.0, 0.2})
      for (const double squeeze : {0.6, 0.9, 1.0, 1.06}) {
        Trial trial(
            block<dimension>({.cells = {9, 8, 5}, .jitter = jitter, .seed = ++seed_}, medium));
        deform_and_break(trial, squeeze, total);
      }
  }
};
TYPED_TEST_SUITE(BreakEnergySign, TwoKinds);

TYPED_TEST(BreakEnergySign, NoBreakRaisesTheStoredEnergy) {
  const auto total = [](auto& trial) {
    return stored_energy(trial) + trial.solid.softening_work();
  };
  for (const Material& material :
       {Material{0.3, BondCriterion::principal_strain},
        Material{0.499, BondCriterion::principal_strain},
        Material{0.0, BondCriterion::equivalent_strain, ElasticLaw::st_venant_kirchhoff},
        Material{0.499, BondCriterion::equivalent_strain},
        Material{0.3, BondCriterion::strain_energy}, Material{0.3, BondCriterion::principal_stress},
        Material{0.499, BondCriterion::crack_band}, Material{0.2, BondCriterion::crack_band},
        Material{0.3, BondCriterion::crack_band, ElasticLaw::neo_hookean, 0.2},
        Material{0.3, BondCriterion::principal_stress, ElasticLaw::neo_hookean, 0.2}})
    this->try_all(medium_of<TypeParam::D>(material), total);
  EXPECT_GT(this->broken_, 10000u);
  EXPECT_GT(this->detached_, 500u);
  EXPECT_GT(this->limited_, 300);
}

// With the energy that the solid itself reports, and what flow has dissipated in the step.
TYPED_TEST(BreakEnergySign, NorWhereSolidsFlowOrHaveFlaws) {
  const auto total = [](auto& trial) {
    return trial.solid.energy().total() + trial.solid.flow_work();
  };
  auto metal = medium_of<TypeParam::D>({0.3, BondCriterion::principal_strain});
  metal.plastic = linear_hardening(2e3, 2e4);
  this->try_all(metal, total);
  auto rock = medium_of<TypeParam::D>({0.2, BondCriterion::grady_kipp});
  rock.grady_kipp.exponent = 6.0;
  rock.grady_kipp.unit_strain = 0.01;
  rock.grady_kipp.growth = 10.0;
  rock.grady_kipp.seed = 9;
  this->try_all(rock, total);
  EXPECT_GT(this->broken_, 2000u);
  EXPECT_GT(this->detached_, 100u);
  EXPECT_GT(this->limited_, 50);
}

}  // namespace
}  // namespace kerf::test
