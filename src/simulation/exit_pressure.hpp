// SPDX-License-Identifier: Apache-2.0
// The pressure at the exit of a nozzle, column by column: the force of all other matter on the
// water of the column inside the nozzle, against the direction of the jet, over the section of the
// column. Forces within that water cancel. With the pressure that the water inside has this is the
// momentum that crosses the exit per time and area, less that of the flow itself. Where the columns
// differ in speed the dissipative forces are left out: the free water would drag at them by its
// numerical shear, which is no pressure, and hold a jet in the open back.
#pragma once

#include <algorithm>
#include <compare>
#include <span>
#include <vector>

#include "geometry/nozzle.hpp"
#include "parallel/loops.hpp"
#include "parallel/ranks.hpp"
#include "particles/fields.hpp"

namespace kerf {

template <int D, class P>
struct IsUpstream {
  ParticleView<D, P> particles;
  KERF_FUNCTION bool operator()(Index i) const { return particles.has(i, flag::upstream); }
};

// The forces on particles of water inside a nozzle, - m (dv/dt - g) . direction, with or without
// the dissipative ones, N (2D: N/m); 0 where one has left since the list was made.
template <int D, class P>
struct ExitForce {
  ParticleView<D, P> particles;
  const Index* inside;  // particles
  Vector<D, double> direction, gravity;
  bool with_dissipation;
  double* force;

  KERF_FUNCTION void operator()(Index n) const {
    const Index i = inside[n];
    auto acceleration = Vector<D, double>::from(particles.acceleration[i]) - gravity;
    if (!with_dissipation)
      acceleration -= Vector<D, double>::from(particles.damping_acceleration[i]);
    force[n] = particles.has(i, flag::upstream)
                   ? -double(particles.medium(i).mass) * dot(acceleration, direction)
                   : 0.0;
  }
};

template <int D, class P>
class ExitPressure {
 public:
  // Lists the water inside the nozzles whose pumps hold their pressure, by column and there by id;
  // to be called when the particles have been put into another order. `first_jet`: medium of the
  // first nozzle.
  void find_columns(Particles<D, P>& particles, const std::vector<Nozzle>& nozzles,
                    std::size_t first_jet) {
    if (!any_holds_pressure(nozzles)) return;
    const std::vector<Index> found = upstream(particles);
    const auto sources = values_at(particles.source, found);
    const auto columns = values_at(particles.inlet_column, found);
    const auto ids = values_at(particles.id, found);
    std::vector<std::vector<Member>> of_nozzle(nozzles.size());
    for (std::size_t n = 0; n < found.size(); ++n)
      of_nozzle[sources[n] - first_jet].push_back({columns[n], ids[n], found[n]});
    first_.assign(1, 0);
    members_.clear();
    for (auto& members : of_nozzle) {
      std::sort(members.begin(), members.end());
      members_.insert(members_.end(), members.begin(), members.end());
      first_.push_back(static_cast<Index>(members_.size()));
    }
    std::vector<Index> inside;
    for (const Member& member : members_) inside.push_back(member.particle);
    to_device(inside, inside_);
    force_.resize(inside.size());
  }

  // Returns the pressure at the exit of each column of nozzle j, Pa, until the next call.
  std::span<const double> of(std::size_t j, Particles<D, P>& particles, const Nozzle& nozzle,
                             const Vector<D, double>& gravity) {
    const auto direction = Vector<D, double>::from(nozzle.direction());
    const Index first = first_[j], count = first_[j + 1] - first;
    for_each_index(count, ExitForce<D, P>{particles.view(), pointer(inside_) + first, direction,
                                          gravity, nozzle.is_uniform(), pointer(force_) + first});
    force_on_host_.resize(count);
    thrust::copy(force_.begin() + first, force_.begin() + first_[j + 1], force_on_host_.begin());
    terms_.clear();
    for (Index n = 0; n < count; ++n)
      terms_.push_back({members_[first + n].column, members_[first + n].id, force_on_host_[n]});
    if (ranks::are_several()) {
      terms_ = ranks::collected(terms_);
      std::sort(terms_.begin(), terms_.end());
    }
    pressure_.assign(nozzle.columns(), 0.0);
    for (const Term& term : terms_) pressure_[term.column] += term.force;
    for (double& p : pressure_) p /= nozzle.column_area();
    return pressure_;
  }

 private:
  struct Member {
    std::uint32_t column, id;
    Index particle;
    auto operator<=>(const Member&) const = default;
  };
  // The force on a particle, N (2D: N/m).
  struct Term {
    std::uint32_t column, id;
    double force;
    auto operator<=>(const Term&) const = default;
  };
  static bool any_holds_pressure(const std::vector<Nozzle>& nozzles) {
    for (const Nozzle& nozzle : nozzles)
      if (nozzle.holds_pressure()) return true;
    return false;
  }

  static std::vector<Index> upstream(Particles<D, P>& particles) {
    Array<Index> found(particles.owned());
    const auto last = thrust::copy_if(loop_policy(), thrust::counting_iterator<Index>(0),
                                      thrust::counting_iterator<Index>(particles.owned()),
                                      found.begin(), IsUpstream<D, P>{particles.view()});
    found.resize(static_cast<std::size_t>(last - found.begin()));
    return to_host(found);
  }

  template <class T>
  static std::vector<T> values_at(const Array<T>& field, const std::vector<Index>& indices) {
    Array<Index> at;
    to_device(indices, at);
    Array<T> values(indices.size());
    thrust::gather(loop_policy(), at.begin(), at.end(), field.begin(), values.begin());
    return to_host(values);
  }

  std::vector<Index> first_;     // member of each nozzle, and their number
  std::vector<Member> members_;  // by nozzle, column and id
  Array<Index> inside_;          // which particles they are
  Array<double> force_;          // N (2D: N/m), on each of them
  // Of the nozzle that is asked for.
  std::vector<double> force_on_host_, pressure_;  // N (2D: N/m), of members; Pa, of columns
  std::vector<Term> terms_;
};

}  // namespace kerf
