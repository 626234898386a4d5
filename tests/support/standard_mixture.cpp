// SPDX-License-Identifier: Apache-2.0
#include "support/standard_mixture.hpp"

namespace kerf::test {

template <int D, class P>
void evaluate_standard(const ReferenceState& state, LoadedStandard<D, P>& loaded) {
  const StandardRates<D, P> rates(Vector<D, double>::from(state.gravity), state.media);
  auto& particles = loaded.particles;
  thrust::fill(particles.solid_initial_overlap.begin(), particles.solid_initial_overlap.end(), 1);
  thrust::fill(particles.rigid_initial_overlap.begin(), particles.rigid_initial_overlap.end(), 1);
  Array<ConcentrationGradient<D, typename P::Real>> concentration_gradient(particles.size());
  rates.find_contacts(particles.view(), particles.size(), loaded.list.view());
  rates.evaluate(particles.view(), particles.size(), loaded.list.view(), MixtureBonds<D, P>{},
                 pointer(concentration_gradient));
  complete_at_walls(rates, loaded);
  particles.wall_normal = particles.next_wall_normal;
}

template void evaluate_standard(const ReferenceState&, LoadedStandard<2, Double>&);
template void evaluate_standard(const ReferenceState&, LoadedStandard<2, Mixed>&);
template void evaluate_standard(const ReferenceState&, LoadedStandard<3, Double>&);
template void evaluate_standard(const ReferenceState&, LoadedStandard<3, Mixed>&);

}  // namespace kerf::test
