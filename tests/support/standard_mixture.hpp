// SPDX-License-Identifier: Apache-2.0
// The random mixture of mixture.hpp for the `standard` formulation, with its bonds and rates.
#pragma once

#include <type_traits>

#include "standard/pair_forces.hpp"
#include "support/kinds.hpp"
#include "support/loaded.hpp"
#include "support/mixture.hpp"
#include "support/reference_standard.hpp"

namespace kerf::test {

using MixtureDimensions =
    testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;

// Sets two waters of different viscosity and sound speed, and walls with a volume.
inline ReferenceState standard_mixture(int dimension, unsigned seed, int per_side = 0) {
  MixtureChoice choice;
  choice.dimension = dimension;
  choice.seed = seed;
  choice.per_side = per_side > 0 ? per_side : dimension == 2 ? 14 : 7;
  ReferenceState state = random_mixture(choice);
  for (auto& medium : state.media) {
    medium.smoothing_length = 1.3 * medium.spacing;
    medium.volume = std::pow(medium.spacing, dimension);
    medium.cavitates = medium.phase != Phase::rigid;
    if (medium.phase == Phase::solid) {
      medium.tait.exponent = 7.0;
      medium.tait.coefficient = medium.total_bulk_modulus / 7.0;
    }
    medium.longitudinal_speed = std::max(medium.longitudinal_speed, medium.sound_speed);
  }
  for (auto& medium : state.media) medium.friction = medium.phase == Phase::rigid ? 0.4 : 0.3;
  state.media[1].viscosity = 0.2;
  state.media[1].sound_speed = 35.0;
  state.media[1].tait.coefficient = 35.0 * 35.0 * 1000.0 / 7.0;
  return state;
}

// Makes the material of one of the two bodies nearly incompressible, which gives two media in one
// piece; the other body is unchanged.
inline void stiffen_volume(ReferenceState& state) {
  state.media[2].excess_bulk_modulus = 0.7 * state.media[2].total_bulk_modulus;
  state.media[3].excess_bulk_modulus = 0.4 * state.media[3].total_bulk_modulus;
  state.media[3].tensile_excess = 0.25 * state.media[3].total_bulk_modulus;  // the other opens
}

// An arbitrary choice of intact bonds between particles of one piece, the same from both ends.
inline bool mixture_bonded(std::size_t i, std::size_t j) {
  return (7 * (i + j) + 3 * (i * j)) % 5 < 3;
}
template <int D, class P>
struct MixtureBonds {
  KERF_FUNCTION bool is_intact(const ParticleView<D, P>& particles, const Pair<D, P>& pair) const {
    return pair.is_one_piece() && pair.medium_j->phase == Phase::solid &&
           mixture_bonded(particles.id[pair.i], particles.id[pair.j]);
  }
  // The initial distance exceeds their spacings.
  KERF_FUNCTION typename P::Real initial_distance(const ParticleView<D, P>&,
                                                  const Pair<D, P>&) const {
    return typename P::Real(1);
  }
};

inline ReferenceStandard::Bonded bonds_of(const ReferenceState& state) {
  return [&state](std::size_t i, std::size_t j) {
    return state.medium(i).piece == state.medium(j).piece && mixture_bonded(i, j);
  };
}

template <int D, class P>
using LoadedStandard = Loaded<D, P, ContactPairs>;

// What a step of one rank adds after the sums over pairs.
template <int D, class P>
void complete_at_walls(const StandardRates<D, P>& rates, LoadedStandard<D, P>& loaded) {
  const auto view = loaded.particles.view();
  if (rates.complete_at_walls(view, loaded.particles.size(), loaded.list.view(),
                              WallCompletion::of_all_rates))
    rates.react_at_walls(view, loaded.particles.size(), loaded.list.view());
}

// Sums the pairs. tests/support/standard_mixture.cpp compiles it once for all tests.
template <int D, class P>
void evaluate_standard(const ReferenceState& state, LoadedStandard<D, P>& loaded);
extern template void evaluate_standard(const ReferenceState&, LoadedStandard<2, Double>&);
extern template void evaluate_standard(const ReferenceState&, LoadedStandard<2, Mixed>&);
extern template void evaluate_standard(const ReferenceState&, LoadedStandard<3, Double>&);
extern template void evaluate_standard(const ReferenceState&, LoadedStandard<3, Mixed>&);

template <int D, class P>
LoadedStandard<D, P> evaluated_standard(const ReferenceState& state, bool splits = true) {
  LoadedStandard<D, P> loaded(state, {.splits = splits});
  evaluate_standard(state, loaded);
  return loaded;
}

}  // namespace kerf::test
