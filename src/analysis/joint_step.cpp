// SPDX-License-Identifier: Apache-2.0
#include "analysis/joint_step.hpp"

#include <algorithm>
#include <cmath>

#include "materials/elastic_moduli.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

// What bonds between two media depend on.
struct Side {
  double density, stiffness, impedance, damping;  // kg/m^3, Pa, kg/(m^2 s), A

  static Side of(const Material& material, int dimension) {
    const auto moduli = ElasticModuli<double>::of(material.youngs_modulus, material.poisson_ratio);
    const double shear = moduli.shear_modulus;
    const double bulk = bond_bulk_modulus(moduli.bulk_modulus, shear);
    const double volume = dimension == 3 ? 3.0 * bulk : 2.0 * (bulk + shear / 3.0);
    return {material.density, std::max(volume, 2.0 * shear),
            std::sqrt(material.density * (bulk + 4.0 / 3.0 * shear)), material.artificial_linear};
  }
};

// The sum of the weights of all bonds of a particle of volume V is 3.5 V / h^2, from the moments of
// Wendland's kernel in 2D and 3D alike.
double step_beside(const Side& own, const Side& other, double h) {
  constexpr double weights = 3.5;
  const double between = 2.0 * own.impedance * other.impedance / (own.impedance + other.impedance);
  const double springs = weights / (h * h) * (1.5 * own.stiffness + 0.5 * other.stiffness);
  const double dampers =
      weights / h * 0.5 *
      (own.damping * own.impedance + std::sqrt(own.damping * other.damping) * between);
  return 2.0 * own.density / (dampers + std::sqrt(dampers * dampers + 2.0 * own.density * springs));
}

}  // namespace

double joint_step(const Case& description, const Body& body, const Body& other) {
  const auto side = [&](const Body& of) {
    return Side::of(description.materials.at(static_cast<std::size_t>(of.material)),
                    description.dimension);
  };
  const Side a = side(body), b = side(other);
  const double h = description.smoothing_ratio * std::min(body.spacing, other.spacing);
  return std::min(step_beside(a, b, h), step_beside(b, a, h));
}

}  // namespace kerf
