// SPDX-License-Identifier: Apache-2.0
// A window of the workpiece that travels with the nozzle (docs/theory/travelling_frame.md). Between
// two steps of the solid the window moves on by a shift: the solid behind it leaves, and solid
// ahead of it joins, at rest and bonded. What is in both windows keeps its state.
#pragma once

#include "standard/standard.hpp"

namespace kerf {

// Marks the particles of these ids for removal.
template <int D, class P>
void mark_outside(Particles<D, P>& particles, const std::vector<std::uint8_t>& leaves) {
  auto flags = to_host(particles.flags);
  const auto id = to_host(particles.id);
  for (std::size_t i = 0; i < id.size(); ++i)
    if (id[i] < leaves.size() && leaves[id[i]] != 0) flags[i] |= flag::outside;
  to_device(flags, particles.flags);
}

template <int D, class P>
void Standard<D, P>::follow_nozzle() {
  if (!settings_.window || !solid_.is_first_substep()) return;
  const std::uint64_t due = settings_.window->frame.shifts_due(time_);
  while (Run::shifts() < due) shift_window(Run::shifts() + 1);
}

template <int D, class P>
void Standard<D, P>::shift_window(std::uint64_t shifts) {
  const auto timer = timers_.stage("window");
  Run::renew_list();  // the balance needs the forces of the particles that are left
  const Balance before = balance();
  Run::drop_ghosts();
  const std::vector<NewParticle> layout = settings_.window->solid(shifts);
  const SolidMembers<D>& old = solid_.members();
  std::vector<std::uint32_t> id;
  auto members = SolidMembers<D>::of(layout, {});
  const std::vector<Index> earlier = old.numbers_of(members.reference);
  std::vector<std::uint8_t> leaves(Run::next_id(), 0);
  for (const std::uint32_t member : old.id) leaves[member] = 1;
  std::vector<NewParticle> newcomers;
  double fed = 0.0;
  for (std::size_t s = 0; s < layout.size(); ++s) {
    if (earlier[s] != no_index) {
      id.push_back(old.id[earlier[s]]);
      leaves[id.back()] = 0;
      continue;
    }
    id.push_back(Run::next_id() + static_cast<std::uint32_t>(newcomers.size()));
    newcomers.push_back(layout[s]);
    fed += Run::media_[layout[s].source].mass;
  }
  members.id = std::move(id);
  mark_outside(particles_, leaves);
  remove_outflow(particles_);
  Run::append(std::move(newcomers));
  settings_.absorbing = settings_.window->absorbing_after(shifts);
  const SolidLosses held = solid_.exchange(settings_, Run::media_, particles_, std::move(members));
  rates_.set_pair_correction(solid_.pair_correction());
  Run::move_domain(shifts);
  Run::renew_list();
  solid_.settle(particles_, held);
  Run::balance_.accumulate_exchange(before, balance(), fed);
}

template <int D, class P>
void Standard<D, P>::restore_window(const Archive& archive) {
  const std::uint64_t shifts = find_array<std::uint64_t>(archive, "shifts").at(0);
  if (shifts == 0) return;
  settings_.absorbing = settings_.window->absorbing_after(shifts);
  solid_.build(settings_, Run::media_, particles_,
               SolidMembers<D>::of(settings_.window->solid(shifts),
                                   find_array<std::uint32_t>(archive, "solid/ids")));
  solid_.divide();
  solid_.move_boundaries(settings_, Run::media_);
  rates_.set_pair_correction(solid_.pair_correction());
}

}  // namespace kerf
