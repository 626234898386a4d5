// SPDX-License-Identifier: Apache-2.0
// Copies the particles to the host as a Frame.
#pragma once

#include "fracture/equivalent_strain.hpp"
#include "particles/fields.hpp"
#include "simulation/frame.hpp"
#include "simulation/levels.hpp"

namespace kerf {

inline Category category_of(Phase phase, bool fractured) {
  if (phase == Phase::water) return Category::water;
  if (phase == Phase::rigid) return Category::rigid;
  return fractured ? Category::fractured : Category::solid;
}

// Rows of the symmetric tensor in the order xx yy zz xy yz xz that ParaView expects.
template <int D, class T>
void append_tensor(const SymmetricTensor<D, T>& s, std::vector<float>& values) {
  for (int a = 0; a < 3; ++a) values.push_back(static_cast<float>(s(a, a)));
  values.push_back(static_cast<float>(s(0, 1)));
  values.push_back(D == 3 ? static_cast<float>(s(D - 2, D - 1)) : 0.0f);
  values.push_back(D == 3 ? static_cast<float>(s(0, D - 1)) : 0.0f);
}

template <int D, class P>
Frame make_frame(const Particles<D, P>& particles, const std::vector<Medium<double>>& media,
                 const std::vector<MediumOrigin>& origins) {
  Frame frame;
  frame.dimension = D;
  const auto position = to_host(particles.position);
  const auto velocity = to_host(particles.velocity);
  const auto source = to_host(particles.source);
  const auto fractured = to_host(particles.fractured);
  const auto flags = to_host(particles.flags);
  const auto compression = to_host(particles.compression);
  const auto pressure = to_host(particles.pressure);
  auto shear = to_host(particles.shear);
  shear.resize(position.size(), SymmetricTensor<D, typename P::Real>::zero());
  frame.id = to_host(particles.id);
  for (const std::uint16_t medium : source) frame.source.push_back(origins[medium].source);
  Column stress{"deviatoric_stress", "Pa", 6, {}};
  Column strain{"equivalent_strain", "1", 1, {}};
  for (std::size_t i = 0; i < position.size(); ++i) {
    const Medium<double>& medium = media[source[i]];
    std::array<double, 3> x{}, v{};
    for (int a = 0; a < D; ++a) {
      x[static_cast<std::size_t>(a)] = position[i][a];
      v[static_cast<std::size_t>(a)] = velocity[i][a];
    }
    frame.position.push_back(x);
    frame.velocity.push_back(v);
    frame.category.push_back(category_of(medium.phase, fractured[i] != 0));
    frame.spacing.push_back(static_cast<float>(medium.spacing));
    frame.mass.push_back(static_cast<float>(medium.mass));
    frame.density.push_back(
        static_cast<float>(medium.density * (1.0 + static_cast<double>(compression[i]))));
    frame.pressure.push_back(static_cast<float>(pressure[i]));
    frame.upstream.push_back((flags[i] & flag::upstream) != 0 ? 1 : 0);
    append_tensor(shear[i], stress.values);
    const bool solid = medium.phase == Phase::solid;
    strain.values.push_back(
        solid ? static_cast<float>(equivalent_strain(
                    shear[i], static_cast<typename P::Real>(medium.shear_modulus)))
              : 0.0f);
  }
  frame.columns = {std::move(stress), std::move(strain)};
  return frame;
}

}  // namespace kerf
