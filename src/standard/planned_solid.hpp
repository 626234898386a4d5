// SPDX-License-Identifier: Apache-2.0
// Adds what ranks would have to compute of a solid and to send in a step, where its bonds are
// divided among them (solid/bond_holders.hpp, standard/solid_exchange.hpp).
#pragma once

#include "distributed/planned_messages.hpp"
#include "solid/total_lagrangian.hpp"
#include "standard/solid_link.hpp"

namespace kerf {

// `rank`: that of each particle, by its position.
template <int D, class P>
void plan_solid(TotalLagrangian<D, P>& solid, const SolidIndexView& link,
                const std::vector<int>& rank, std::vector<RankLoad>& loads,
                PlannedMessages& messages) {
  BondHolders<D> holders;
  const BondTable<D> bonds = solid.view().bonds;
  holders.find(bonds, solid.size(), static_cast<int>(loads.size()));
  const auto motion = static_cast<double>(sizeof(typename MotionOfParticles<D, P>::Motion)),
             deformation = static_cast<double>(solid.bytes_to_ghost()),
             acceleration = static_cast<double>(solid.bytes_of_acceleration());
  for (Index s = 0; s < solid.size(); ++s) {
    const int owner = holders.owner(s);
    RankLoad& own = loads[static_cast<std::size_t>(owner)];
    ++own.solid;
    own.bonds += double(bonds.count[s]);
    const Index i = link.particle_of[s];
    const int at = i == no_index ? owner : rank[i];
    holders.for_each(s, [&](int holder) {
      messages.add(at, holder, motion);
      if (holder == owner) return;
      ++loads[static_cast<std::size_t>(holder)].solid_ghosts;
      messages.add(owner, holder, deformation);
    });
    messages.add(owner, at, acceleration);
  }
}

}  // namespace kerf
