// SPDX-License-Identifier: Apache-2.0
// The members of the solid of a run: its particles in the order of their layout, on the host.
#pragma once

#include <algorithm>
#include <boost/container_hash/hash.hpp>
#include <unordered_map>
#include <vector>

#include "particles/fields.hpp"
#include "particles/new_particle.hpp"
#include "solid/find_bonds.hpp"
#include "standard/solid_link.hpp"

namespace kerf {

template <int D>
struct SolidMembers {
  std::vector<Vector<D, double>> reference;  // X, m
  std::vector<std::uint16_t> medium_index;
  std::vector<std::uint32_t> id;  // of the particle, also of one that has left

  Index size() const { return static_cast<Index>(id.size()); }
  std::size_t bytes() const {
    return reference.capacity() * sizeof(Vector<D, double>) +
           medium_index.capacity() * sizeof(std::uint16_t) + id.capacity() * sizeof(std::uint32_t);
  }

  void add(const Vector<D, double>& x, std::uint16_t medium, std::uint32_t particle_id) {
    reference.push_back(x);
    medium_index.push_back(medium);
    id.push_back(particle_id);
  }

  // Those of the particles of the start, which are in the order of their ids.
  static SolidMembers at_start(const std::vector<Vector<D, double>>& position,
                               const std::vector<std::uint16_t>& source,
                               const std::vector<Medium<double>>& media) {
    SolidMembers members;
    for (std::size_t i = 0; i < source.size(); ++i)
      if (media[source[i]].phase == Phase::solid)
        members.add(position[i], source[i], static_cast<std::uint32_t>(i));
    return members;
  }
  // Those of a layout; `id` of each.
  static SolidMembers of(const std::vector<NewParticle>& layout, std::vector<std::uint32_t> id) {
    SolidMembers members;
    for (const NewParticle& particle : layout) {
      members.reference.push_back(Vector<D, double>::from(particle.position));
      members.medium_index.push_back(particle.source);
    }
    members.id = std::move(id);
    return members;
  }

  // Returns the number of each id, or no_index.
  std::vector<Index> number_of_id() const {
    std::vector<Index> number;
    for (Index s = 0; s < size(); ++s) {
      if (id[s] >= number.size()) number.resize(id[s] + std::size_t(1), no_index);
      number[id[s]] = s;
    }
    return number;
  }

  // Returns the number of each position in these members, or no_index: positions of one lattice
  // have the same bits.
  std::vector<Index> numbers_of(const std::vector<Vector<D, double>>& positions) const {
    std::unordered_map<std::array<double, D>, Index, boost::hash<std::array<double, D>>> found;
    const auto key = [](const Vector<D, double>& x) {
      std::array<double, D> numbers;
      for (int a = 0; a < D; ++a) numbers[static_cast<std::size_t>(a)] = x[a];
      return numbers;
    };
    for (Index s = 0; s < size(); ++s) found[key(reference[s])] = s;
    std::vector<Index> numbers;
    for (const auto& x : positions) {
      const auto place = found.find(key(x));
      numbers.push_back(place == found.end() ? no_index : place->second);
    }
    return numbers;
  }
};

}  // namespace kerf
