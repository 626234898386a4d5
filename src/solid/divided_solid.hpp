// SPDX-License-Identifier: Apache-2.0
// DividedSolid holds the fields of a solid that several ranks may share (docs/mpi.md). Every rank
// has the whole layout with all bonds; it computes the particles of its share, and has what it
// needs of others as ghosts. What breaks is told to all ranks at once, so that the state of every
// bond is known everywhere.
#pragma once

#include "distributed/rank_load.hpp"
#include "solid/solid_records.hpp"

namespace kerf {

template <int D, class P>
class DividedSolid {
 public:
  using Numbers = typename BondHalo<D>::Numbers;

  // Divides the work among all ranks from now on, which have the same solid.
  void divide() {
    if constexpr (ranks::exist) {
      halo_.set_up(fields_.view().bonds, fields_.size());
      fields_.share = halo_.share();
      entries_ = 0;
      for (const Index s : halo_.own()) entries_ += fields_.bond_count[s];
      const HasUnlikeWaves at_joint{pointer(fields_.unlike_media)};
      has_joints_ = reduce_unordered(fields_.size(), at_joint, false, Either{});
    }
  }
  const IndexShare& share() const { return fields_.share; }
  const BondHalo<D>& halo() const { return halo_; }

  // Sends all that is known of the particles to[r], which are of this share, to rank r.
  void send(const std::vector<Numbers>& to) {
    if constexpr (ranks::exist) SolidRecords<D, P>{fields_, break_records_}.exchange(to);
  }
  // Gives rank 0 all that is known of all particles.
  void gather() {
    if constexpr (ranks::exist) {
      if (!share().is_part) return;
      std::vector<Numbers> to(static_cast<std::size_t>(ranks::count()));
      to.front() = halo_.own();
      send(to);
    }
  }

  // The same to all ranks.
  void gather_at_all_ranks() {
    if constexpr (ranks::exist)
      if (share().is_part) publish(halo_.own());
  }

  // Sends the accelerations of the particles to[r] to rank r, and takes those that it sends.
  void exchange_accelerations(const std::vector<Numbers>& to, const std::vector<Numbers>& awaited) {
    if constexpr (ranks::exist)
      exchange_entries(to, awaited, fields_.acceleration, fields_.mirror_acceleration);
  }

  std::uint64_t entries() const { return entries_; }  // bonds of the share, from both ends

  // What a plan of ranks (standard/planned_solid.hpp) needs: the bytes that a ghost gets in a step,
  // and those of the acceleration of a particle; how often ranks wait for others.
  std::size_t bytes_to_ghost() {
    std::size_t bytes = bytes_of_entries(fields_.ends);
    if (can_break())
      with_fields_of_test([&](auto&... field) {
        bytes += sizeof(typename P::Real) + sizeof(std::uint8_t) + bytes_of_entries(field...);
      });
    if (fields_.any_flows)
      bytes += bytes_of_entries(fields_.rate_traction, fields_.hourglass_viscosity);
    return bytes;
  }
  std::size_t bytes_of_acceleration() const {
    return bytes_of_entries(fields_.acceleration, fields_.mirror_acceleration);
  }
  StepWaits waits() const {
    StepWaits waits = StepWaits::of_solid();
    if (can_break()) waits = waits + StepWaits::of_breaking() + StepWaits::of_changes();
    if (fields_.any_flows) waits = waits + StepWaits::of_flow();
    if (fields_.any_softens) waits = waits + StepWaits::of_loss();
    if (fields_.any_flaws) waits = waits + StepWaits::of_loss();
    return waits;
  }

 protected:
  // Sets fields of the ghosts to those of their owners.
  template <class... T>
  void update_ghosts([[maybe_unused]] Array<T>&... field) {
    if constexpr (ranks::exist)
      if (share().is_part) halo_.to_ghosts(field...);
  }
  // At the end of a step the hourglass moduli may have fallen, which the limit at joints reads.
  void update_ghosts_of_joints() {
    if (has_joints_) update_ghosts(fields_.ends);
  }
  // Sets a flag where it is set of a ghost.
  void flags_to_owners([[maybe_unused]] Array<std::uint8_t>& flags) {
    if constexpr (ranks::exist)
      if (share().is_part) halo_.to_owners(flags);
  }
  // Gives the ghosts what a test of the bonds reads of them, with the norms of their gradients,
  // once a bond of any rank may break; returns whether one may.
  bool prepare_break_test([[maybe_unused]] Array<typename P::Real>& gradient_norm) {
    if constexpr (ranks::exist) {
      if (!share().is_part) return true;
      const IsSet strained{pointer(fields_.strained)};
      if (!ranks::any(reduce_unordered(share(), strained, false, Either{}))) return false;
      with_fields_of_test([&](auto&... field) { halo_.to_ghosts(gradient_norm, field...); });
    }
    return true;
  }
  // The particles of the share that the current break concerns.
  Numbers recorded() {
    Numbers numbers;
    if constexpr (ranks::exist)
      for (Index s = share().first; share().is_part && s < share().last; ++s)
        if (pointer(break_records_)[s].is_recorded) numbers.push_back(s);
    return numbers;
  }
  // Tells all ranks what has become of particles of this share.
  void publish([[maybe_unused]] const Numbers& numbers) {
    if constexpr (ranks::exist)
      if (share().is_part)
        send(std::vector<Numbers>(static_cast<std::size_t>(ranks::count()), numbers));
  }

  SolidFields<D, P> fields_;
  BondHalo<D> halo_;
  Array<BondBreakRecord> break_records_;
  std::uint64_t entries_ = 0;

 private:
  bool can_break() const { return !break_records_.empty(); }
  // Calls use(field...) with what a test of the bonds reads of their other ends, but for the norms.
  template <class Use>
  void with_fields_of_test(const Use& use) {
    use(fields_.gradient, fields_.criterion, fields_.current_strain, fields_.loading_now,
        fields_.current_flow, fields_.flaws);
  }

  bool has_joints_ = false;
};

}  // namespace kerf
