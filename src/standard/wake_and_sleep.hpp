// SPDX-License-Identifier: Apache-2.0
// The stages of a step by which solid wakes and falls asleep (standard/sleep.hpp). Between them the
// ghosts of several ranks have the state of their owners.
#pragma once

#include "standard/standard.hpp"

namespace kerf {

// Marks as moving, from the start, what a prescription moves now or later.
template <int D, class P>
void Standard<D, P>::mark_driven() {
  if (!particles_.groups.sleep) return;
  std::vector<std::uint8_t> is_driven;
  for (std::size_t medium = 0; medium < Run::media_.size(); ++medium)
    is_driven.push_back(settings_.motion.moves(medium));
  Array<std::uint8_t> driven;
  to_device(is_driven, driven);
  for_each_index(particles_.owned(), MarkDriven<D, P>{particles_.view(), pointer(driven)});
}

template <int D, class P>
void Standard<D, P>::wake_and_sleep() {
  if (!particles_.groups.sleep) return;
  const auto timer = timers_.stage("integrate");
  constexpr std::uint64_t interval = 64;  // steps
  const auto view = particles_.view();
  const MarkNewlyMoving<D, P> mark{view, waking_speed_};
  if (ranks::any(reduce_unordered(particles_.owned(), mark, false, Either{}))) {
    spread(MarkReached<D, P>{view}, particles_.reached);
    wake_beside_newly_reached();
  }
  if (Run::step() % interval != 0) return;
  solid_.fall_asleep(particles_, list_.view());
  Run::update_ghosts(particles_.asleep);
}

// Wakes what has a moving or reached neighbour in a new list; null: all lists are new.
template <int D, class P>
void Standard<D, P>::wake_listed_anew(const std::uint8_t* listed_anew) {
  if (!particles_.groups.sleep) return;
  const Index n = particles_.owned();
  const auto view = particles_.view();
  const ReachListedAnew<D, P> reach{view, list_.view(), listed_anew};
  if (ranks::any(reduce_unordered(n, reach, false, Either{}))) wake_beside_newly_reached();
  for_each_index(n, WakeListedAnew<D, P>{view, list_.view(), listed_anew});
  Run::update_ghosts(particles_.asleep);
}

template <int D, class P>
void Standard<D, P>::wake_beside_newly_reached() {
  spread(WakeParticle<D, P>{particles_.view()}, particles_.asleep);
  for_each_index(particles_.owned(), KeepActivity<D, P>{particles_.view()});
  for (auto* field : {&particles_.moving, &particles_.reached, &particles_.asleep})
    Run::update_ghosts(*field);
}

// Applies an action that spreads from particles to those with which they interact, and sets `marks`
// of them.
template <int D, class P>
template <template <int, class> class Action>
void Standard<D, P>::spread(const Action<D, P>& action, Array<std::uint8_t>& marks) {
  for_each_index(particles_.owned(), SpreadToNeighbours<D, P, Action>{action, list_.view()});
  Run::merge_ghosts(marks, Action<D, P>::merged);
  solid_.spread_to_bond_ends(action);
}

}  // namespace kerf
