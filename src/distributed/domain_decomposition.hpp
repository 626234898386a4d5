// SPDX-License-Identifier: Apache-2.0
// DomainDecomposition gives each rank of a run its part of the particles, and its ghosts: copies of
// the particles of other ranks that are near enough to act on its own (docs/mpi.md). What a rank
// computes for a particle has the same bits whichever rank computes it:
// - A rank has all particles of the patches (neighbours/patch_grids.hpp) around those of its own
//   particles, so that the neighbours of a particle are found in the same order everywhere.
// - The groups in which sums over particles are formed (particles/particle_groups.hpp) are never
//   divided between ranks.
#pragma once

#include <algorithm>
#include <numeric>

#include "distributed/listed_ghosts.hpp"
#include "distributed/messages.hpp"
#include "distributed/patches_around.hpp"
#include "distributed/pieces_of_rows.hpp"
#include "parallel/entry_messages.hpp"
#include "particles/reorder.hpp"

namespace kerf {

template <int D, class P>
class DomainDecomposition {
 public:
  // Whether a particle that joins at a position belongs to this rank; before the first distribution
  // all belong to rank 0.
  bool owns(const LevelGrids<D>& grids, const Vector<D, double>& position) const {
    return owner(grids, grids.number(0, position)) == ranks::number();
  }

  // Gives every rank the particles of its part, without ghosts, in any order. The parts are made
  // anew where the work is divided too unevenly.
  void distribute(Particles<D, P>& particles, const LevelGrids<D>& grids) {
    const PiecesOfRows<D, P> pieces(particles, grids);
    divide(pieces.points());
    const std::vector<int> rank = pieces.owners(partition_.get());
    std::vector<std::vector<Index>> to(size());
    for (Index i = 0; i < particles.size(); ++i) to[static_cast<std::size_t>(rank[i])].push_back(i);
    move(particles, to);
  }

  // Fetches the ghosts of the particles, which have none.
  void fetch_ghosts(Particles<D, P>& particles, const LevelGrids<D>& grids) {
    const auto patches = PatchGrids<D>::of(grids);
    const std::vector<Index> patch = patches_of_particles(particles, grids, patches);
    find_receivers(patch, grids, patches);
    std::vector<ranks::Bytes> messages(size());
    for (std::size_t r = 0; r < size(); ++r) pack<StateFields>(particles, send_[r], messages[r]);
    const auto from = ranks::exchange(messages);
    const Index own = particles.size();
    const std::size_t bytes = bytes_in_message<StateFields>(particles);
    const std::size_t paired = bytes_in_message<PairedFields>(particles);
    std::size_t ghosts = 0;
    for (std::size_t r = 0; r < size(); ++r) {
      ghosts += from[r].size() / bytes;
      received_[r].resize(from[r].size() / bytes * paired);
    }
    particles.resize(own + static_cast<Index>(ghosts));
    Index first = own;
    for (const ranks::Bytes& message : from) first = unpack<StateFields>(message, particles, first);
    particles.ghosts = {own, static_cast<Index>(ghosts)};
  }

  // Must be called for new lists of neighbours.
  void take_lists(const Particles<D, P>& particles, const NeighbourView& list) {
    std::vector<std::size_t> ghosts;
    for (std::size_t r = 0; r < size(); ++r) ghosts.push_back(ghosts_of(particles, r));
    listed_.find(particles, list, send_, ghosts);
  }
  // Sets the fields that pair loops read of the ghosts in lists to those at their owners.
  void update_listed_ghosts(Particles<D, P>& particles) { listed_.update(particles); }

  // The same of all ghosts.
  void update_ghosts(Particles<D, P>& particles) {
    for (std::size_t r = 0; r < size(); ++r) pack<PairedFields>(particles, send_[r], sent_[r]);
    ranks::exchange_known(sent_, received_);
    Index first = particles.ghosts.first;
    for (const ranks::Bytes& message : received_)
      first = unpack<PairedFields>(message, particles, first);
  }

  // Sets one field of the ghosts to that at their owners.
  template <class T>
  void update_ghosts(const Particles<D, P>& particles, Array<T>& field) const {
    std::vector<ranks::Bytes> to(size()), from(size());
    for (std::size_t r = 0; r < size(); ++r) {
      put_entries(field, send_[r], to[r]);
      from[r].resize(ghosts_of(particles, r) * sizeof(T));
    }
    ranks::exchange_known(to, from);
    Index first = particles.ghosts.first;
    for (const ranks::Bytes& message : from) {
      if (!message.empty())
        std::memcpy(static_cast<void*>(&field[first]), message.data(), message.size());
      first += static_cast<Index>(message.size() / sizeof(T));
    }
  }
  // Sets a field of particles to merge(own, ghost) for each of their ghosts.
  template <class T, class Merge>
  void merge_ghosts(const Particles<D, P>& particles, Array<T>& field, const Merge& merge) const {
    std::vector<ranks::Bytes> to(size()), from(size());
    Index first = particles.ghosts.first;
    for (std::size_t r = 0; r < size(); ++r) {
      const std::size_t ghosts = ghosts_of(particles, r);
      to[r].resize(ghosts * sizeof(T));
      if (ghosts > 0) std::memcpy(to[r].data(), &field[first], to[r].size());
      first += static_cast<Index>(ghosts);
      from[r].resize(send_[r].size() * sizeof(T));
    }
    ranks::exchange_known(to, from);
    for (std::size_t r = 0; r < size(); ++r)
      for (std::size_t n = 0; n < send_[r].size(); ++n) {
        T ghost;
        std::memcpy(&ghost, from[r].data() + n * sizeof(T), sizeof(T));
        field[send_[r][n]] = merge(field[send_[r][n]], ghost);
      }
  }

  static void drop_ghosts(Particles<D, P>& particles) {
    const Ghosts ghosts = std::exchange(particles.ghosts, {});
    if (ghosts.count == 0) return;
    Array<Index> order(particles.size() - ghosts.count);
    std::iota(order.begin(), order.begin() + ghosts.first, Index(0));
    std::iota(order.begin() + ghosts.first, order.end(), ghosts.first + ghosts.count);
    gather_particles(particles, order);
  }

  // Returns at rank 0 the particles of all ranks in the order of a run of one rank, with all
  // fields; none at the others.
  Particles<D, P> gathered(const Particles<D, P>& particles) const {
    std::vector<Index> own(particles.owned());
    std::iota(own.begin(), own.end(), Index(0));
    std::vector<ranks::Bytes> messages(size());
    pack<AllFields>(particles, own, messages.front());
    const auto from = ranks::exchange(messages);
    Particles<D, P> whole;
    whole.groups = particles.groups;
    whole.media = particles.media;
    whole.mirrors = particles.mirrors;
    std::size_t bytes = 0;
    for (const ranks::Bytes& message : from) bytes += message.size();
    whole.resize(static_cast<Index>(bytes / bytes_in_message<AllFields>(particles)));
    Index first = 0;
    for (const ranks::Bytes& message : from) first = unpack<AllFields>(message, whole, first);
    Array<Index> order(whole.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::sort(order.begin(), order.end(),
              ComesBefore{pointer(whole.sorted_cell), pointer(whole.id)});
    for_each_chosen<AllFields>(whole, [&](auto& field) { gather_in_place(order, field); });
    return whole;
  }

 private:
  // How many of the ghosts are those of particles of a rank.
  std::size_t ghosts_of(const Particles<D, P>& particles, std::size_t rank) const {
    return received_[rank].size() / bytes_in_message<PairedFields>(particles);
  }

  static std::size_t size() { return static_cast<std::size_t>(ranks::count()); }

  int owner(const LevelGrids<D>& grids, Index cell) const {
    return partition_ ? partition_->owner(PiecesOfRows<D, P>::centre(grids, cell)) : 0;
  }

  // Makes the parts anew if the work is divided more unevenly than by the last ones.
  void divide(const std::vector<PointOfWork>& points) {
    constexpr double tolerance = 1.1, drift = 1.05;
    const double now = imbalance(points, [](const PointOfWork&) { return ranks::number(); });
    if (partition_ && now <= std::max(tolerance, drift * reached_)) return;
    partition_ = make_partition(points, D, ranks::count());
    reached_ = imbalance(
        points, [this](const PointOfWork& point) { return partition_->owner(point.position); });
  }
  // The largest work of a rank over the mean, where `of(point)` has the work of a point.
  template <class RankOf>
  static double imbalance(const std::vector<PointOfWork>& points, const RankOf& of) {
    std::vector<double> work(size(), 0.0);
    for (const PointOfWork& point : points)
      work[static_cast<std::size_t>(of(point))] += double(point.work);
    const std::vector<double> parts = ranks::collected(work);
    for (std::size_t r = 0; r < size(); ++r) {
      work[r] = 0.0;
      for (std::size_t k = r; k < parts.size(); k += size()) work[r] += parts[k];
    }
    const double all = std::accumulate(work.begin(), work.end(), 0.0);
    return all > 0.0 ? *std::max_element(work.begin(), work.end()) * double(size()) / all : 1.0;
  }

  // Sends particles to[r] to rank r.
  static void move(Particles<D, P>& particles, const std::vector<std::vector<Index>>& to) {
    const auto own = static_cast<std::size_t>(ranks::number());
    std::vector<ranks::Bytes> messages(size());
    for (std::size_t r = 0; r < size(); ++r)
      if (r != own) pack<StateFields>(particles, to[r], messages[r]);
    const auto from = ranks::exchange(messages);
    gather_particles(particles, Array<Index>(to[own].begin(), to[own].end()));
    std::size_t bytes = 0;
    for (const ranks::Bytes& message : from) bytes += message.size();
    Index first = particles.size();
    particles.resize(first + static_cast<Index>(bytes / bytes_in_message<StateFields>(particles)));
    for (const ranks::Bytes& message : from) first = unpack<StateFields>(message, particles, first);
    particles.regroup();
  }

  // Marks the patches around each patch of the list.
  static void mark_around(const std::vector<Index>& list, const LevelGrids<D>& grids,
                          const PatchGrids<D>& patches, std::vector<std::uint8_t>& marks) {
    for (const Index number : list)
      for_each_row_around(number, grids, patches, [&](Index first, Index last) {
        std::fill(marks.begin() + first, marks.begin() + last + 1, std::uint8_t(1));
      });
  }
  // Finds which particles every other rank needs: those of the patches around its own particles.
  // `patch`: of each particle.
  void find_receivers(const std::vector<Index>& patch, const LevelGrids<D>& grids,
                      const PatchGrids<D>& patches) {
    std::vector<Index> occupied = patch;
    std::sort(occupied.begin(), occupied.end());
    occupied.erase(std::unique(occupied.begin(), occupied.end()), occupied.end());
    const auto from = ranks::exchange(std::vector<ranks::Bytes>(size(), ranks::to_bytes(occupied)));
    for (auto* each : {&sent_, &received_}) each->assign(size(), {});
    send_.assign(size(), {});
    std::vector<std::uint8_t> needed(patches.count());
    for (std::size_t r = 0; r < size(); ++r) {
      if (r == static_cast<std::size_t>(ranks::number())) continue;
      std::vector<Index> of_rank;
      ranks::append_entries(from[r], of_rank);
      std::fill(needed.begin(), needed.end(), std::uint8_t(0));
      mark_around(of_rank, grids, patches, needed);
      for (Index i = 0; i < patch.size(); ++i)
        if (needed[patch[i]] != 0) send_[r].push_back(i);
    }
  }

  std::shared_ptr<const Partition> partition_;
  double reached_ = 1.0;                       // imbalance of the work by this partition
  std::vector<std::vector<Index>> send_;       // particles that are ghosts of each rank
  std::vector<ranks::Bytes> sent_, received_;  // messages of an update
  ListedGhosts<D, P> listed_;
};

}  // namespace kerf
