// SPDX-License-Identifier: Apache-2.0
// What a checkpoint holds of a run: the state of the particles (rows STATE of
// particles/fields.hpp), clock, counters, the shifts of a travelling frame, balance, the emission
// of the nozzles and their pumps. output/checkpoint.hpp lists what the other parts of the program
// add.
#pragma once

#include <cstring>
#include <type_traits>

#include "simulation/particle_run.hpp"
#include "simulation/state_io.hpp"

namespace kerf {

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::save(Archive& archive) const {
  static_assert(std::is_trivially_copyable_v<Balance> && sizeof(Balance) % sizeof(double) == 0);
  with_all_particles([&](const auto& all) { save_fields(all, archive); });
  archive.arrays["clock"] = std::vector<double>{time_, last_step_.dt};
  archive.arrays["counters"] =
      std::vector<std::uint64_t>{step_, next_id_, list_is_due_ ? 1u : 0u, last_step_.limiting_id};
  if (settings_.window) archive.arrays["shifts"] = std::vector<std::uint64_t>{shifts_};
  archive.texts["limit"] = last_step_.limit;
  std::vector<double> balance(sizeof(Balance) / sizeof(double));
  std::memcpy(balance.data(), &balance_.totals(), sizeof(Balance));
  archive.arrays["balance"] = balance;
  archive.arrays["pair_interactions"] = std::vector<double>{pair_interactions()};
  for (std::size_t j = 0; j < nozzles_.size(); ++j) {
    archive.arrays["nozzle/" + std::to_string(j)] = nozzles_[j].emitted();
    archive.arrays["pump/" + std::to_string(j)] = nozzles_[j].pump_state();
  }
}

// Of several ranks the first one has the particles of the archive.
template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::restore_particles(const Archive& archive) {
  drop_ghosts();
  if (ranks::number() == 0)
    restore_fields(archive, particles_);
  else
    particles_.resize(0);
  if (!ranks::are_several()) return;
  distribute();
  sort_particles(particles_, Array<Index>(particles_.sorted_cell));
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::restore(const Archive& archive) {
  if (settings_.window) move_domain(find_array<std::uint64_t>(archive, "shifts").at(0));
  restore_particles(archive);
  const auto& clock = find_array<double>(archive, "clock");
  const auto& counters = find_array<std::uint64_t>(archive, "counters");
  time_ = clock.at(0);
  step_ = counters.at(0);
  next_id_ = static_cast<std::uint32_t>(counters.at(1));
  list_is_due_ = counters.at(2) != 0;
  last_step_ = {clock.at(1), archive.texts.at("limit"), counters.at(3)};
  const auto& numbers = find_array<double>(archive, "balance");
  Balance balance;
  require(numbers.size() * sizeof(double) == sizeof(Balance), "balance length in checkpoint");
  std::memcpy(static_cast<void*>(&balance), numbers.data(), sizeof(Balance));
  balance_.restore(balance);
  pair_interactions_ =
      ranks::number() == 0 ? find_array<double>(archive, "pair_interactions").at(0) : 0.0;
  for (std::size_t j = 0; j < nozzles_.size(); ++j) {
    nozzles_[j].restore(find_array<std::uint64_t>(archive, "nozzle/" + std::to_string(j)));
    nozzles_[j].restore_pump(find_array<double>(archive, "pump/" + std::to_string(j)));
  }
  // The particles are in the order in which they were listed: the same list results.
  list_particles();
  note_order(nullptr);
  fresh_ = false;
}

}  // namespace kerf
