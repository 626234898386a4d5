// SPDX-License-Identifier: Apache-2.0
// SolidExchange passes what several ranks know of a solid between those that have its particles,
// by their current positions, and those that compute its bonds (solid/bond_halo.hpp): motion one
// way, accelerations the other. What goes where is found whenever particles are listed.
#pragma once

#include "solid/total_lagrangian.hpp"
#include "standard/solid_link.hpp"

namespace kerf {

template <int D, class P>
class SolidExchange {
 public:
  using Real = typename P::Real;
  using Numbers = typename BondHalo<D>::Numbers;

  // Finds to whom the motion of each particle of this rank goes.
  void relink(const SolidIndexView& link, const TotalLagrangian<D, P>& solid) {
    if constexpr (ranks::exist) find_lists(link, solid);
  }

  // Sets the motion of the particles of the share and of its ghosts.
  void send(const MotionOfParticles<D, P>& motion, TotalLagrangian<D, P>& solid) {
    if constexpr (ranks::exist) exchange_motion(motion, solid);
  }

  // The positions that were last sent for no later time, by number, m: of the particles of the
  // share and of its ghosts.
  Array<Vector<D, double>>& positions() { return position_; }

  // Gives the ranks that have the particles the accelerations by bonds.
  void send_back(TotalLagrangian<D, P>& solid) const {
    solid.exchange_accelerations(returned_, awaited_);
  }
  // Gives them a field, with one entry for each particle of the solid.
  template <class T>
  void send_back([[maybe_unused]] Array<T>& field) const {
    if constexpr (ranks::exist) exchange_entries(returned_, awaited_, field);
  }

 private:
  using Message = typename MotionOfParticles<D, P>::Motion;

  void find_lists(const SolidIndexView& link, const TotalLagrangian<D, P>& solid) {
    const auto all = static_cast<std::size_t>(ranks::count());
    for (auto* lists : {&sent_, &awaited_, &received_, &returned_}) lists->assign(all, {});
    const BondHalo<D>& halo = solid.halo();
    for (Index s = 0; s < solid.size(); ++s) {
      if (link.particle_of[s] == no_index) continue;
      halo.for_each_holder(s,
                           [&](int rank) { sent_[static_cast<std::size_t>(rank)].push_back(s); });
      awaited_[static_cast<std::size_t>(halo.owner(s))].push_back(s);
    }
    std::vector<ranks::Bytes> to(all);
    for (std::size_t r = 0; r < all; ++r) to[r] = ranks::to_bytes(sent_[r]);
    const auto from = ranks::exchange(to);
    for (std::size_t r = 0; r < all; ++r) {
      ranks::append_entries(from[r], received_[r]);
      for (const Index s : received_[r])
        if (solid.share().has(s)) returned_[r].push_back(s);
    }
  }

  void exchange_motion(const MotionOfParticles<D, P>& motion, TotalLagrangian<D, P>& solid) {
    std::vector<ranks::Bytes> to, from;
    for (std::size_t r = 0; r < sent_.size(); ++r) {
      to.emplace_back(sent_[r].size() * sizeof(Message));
      from.emplace_back(received_[r].size() * sizeof(Message));
      for_each_index(static_cast<Index>(sent_[r].size()),
                     Put{motion, sent_[r].data(), to.back().data()});
    }
    ranks::exchange_known(to, from);
    position_.resize(solid.size());
    Vector<D, double>* const position = motion.prediction_time > 0.0 ? nullptr : pointer(position_);
    for (std::size_t r = 0; r < sent_.size(); ++r)
      for_each_index(static_cast<Index>(received_[r].size()),
                     Take{solid.view(), received_[r].data(), from[r].data(), position});
  }

  struct Put {
    const MotionOfParticles<D, P>& motion;
    const Index* number;
    std::byte* to;
    void operator()(Index n) const {
      const Message message = motion.of(motion.link.particle_of[number[n]]);
      std::memcpy(to + n * sizeof(Message), &message, sizeof(Message));
    }
  };
  struct Take {
    SolidView<D, P> solid;
    const Index* number;
    const std::byte* from;
    Vector<D, double>* position;  // or null
    void operator()(Index n) const {
      Message message;
      std::memcpy(static_cast<void*>(&message), from + n * sizeof(Message), sizeof(Message));
      message.set(solid, number[n]);
      if (position != nullptr) position[number[n]] = message.position;
    }
  };

  Array<Vector<D, double>> position_;
  std::vector<Numbers> sent_, received_;     // of each rank: whose motion goes there, and comes
  std::vector<Numbers> awaited_, returned_;  // and whose acceleration comes, and goes there
};

}  // namespace kerf
