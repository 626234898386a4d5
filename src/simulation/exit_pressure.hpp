// SPDX-License-Identifier: Apache-2.0
// The pressure at the exit of a nozzle, column by column: the force of all other matter on the
// water of the column inside the nozzle, against the direction of the jet, over the section of the
// column. Forces within that water cancel. With the pressure that the water inside has this is the
// momentum that crosses the exit per time and area, less that of the flow itself.
#pragma once

#include "geometry/nozzle.hpp"
#include "parallel/loops.hpp"
#include "particles/fields.hpp"

namespace kerf {

template <int D, class P>
struct IsUpstream {
  ParticleView<D, P> particles;
  KERF_FUNCTION bool operator()(Index i) const { return particles.has(i, flag::upstream); }
};

// The sum over the water of a column inside the nozzle of - m (dv/dt - g) . direction, N (2D: N/m).
template <int D, class P>
struct ColumnForce {
  ParticleView<D, P> particles;
  const Index* begin;   // of each column of the nozzle in `inside`, and the end of the last
  const Index* inside;  // particles
  Vector<D, double> direction, gravity;
  double* force;

  KERF_FUNCTION void operator()(Index column) const {
    double sum = 0.0;
    for (Index n = begin[column]; n < begin[column + 1]; ++n) {
      const Index i = inside[n];
      if (!particles.has(i, flag::upstream)) continue;  // it has left since the list was made
      const auto acceleration = Vector<D, double>::from(particles.acceleration[i]) - gravity;
      sum -= double(particles.medium(i).mass) * dot(acceleration, direction);
    }
    force[column] = sum;
  }
};

template <int D, class P>
class ExitPressure {
 public:
  // Lists the water inside the nozzles whose pumps hold their pressure, by column; to be called
  // when the particles have been put into another order. `first_jet`: medium of the first nozzle.
  void find_columns(Particles<D, P>& particles, const std::vector<Nozzle>& nozzles,
                    std::size_t first_jet) {
    if (!any_holds_pressure(nozzles)) return;
    first_.assign(nozzles.size() + 1, 0);
    for (std::size_t j = 0; j < nozzles.size(); ++j)
      first_[j + 1] = first_[j] + static_cast<Index>(nozzles[j].columns());
    const std::vector<Index> found = upstream(particles);
    const auto sources = values_at(particles.source, found);
    const auto columns = values_at(particles.inlet_column, found);
    std::vector<std::vector<Index>> of_column(first_.back());
    for (std::size_t n = 0; n < found.size(); ++n)
      of_column[first_[sources[n] - first_jet] + columns[n]].push_back(found[n]);
    std::vector<Index> begin{0}, inside;
    for (const auto& members : of_column) {
      inside.insert(inside.end(), members.begin(), members.end());
      begin.push_back(static_cast<Index>(inside.size()));
    }
    to_device(begin, begin_);
    to_device(inside, inside_);
    force_.resize(first_.back());
  }

  // Returns the pressure at the exit of each column of nozzle j, Pa.
  std::vector<double> of(std::size_t j, Particles<D, P>& particles, const Nozzle& nozzle,
                         const Vector<D, double>& gravity) {
    const auto direction = Vector<D, double>::from(nozzle.direction());
    double* force = pointer(force_) + first_[j];
    const auto count = static_cast<Index>(nozzle.columns());
    for_each_index(count, ColumnForce<D, P>{particles.view(), pointer(begin_) + first_[j],
                                            pointer(inside_), direction, gravity, force});
    std::vector<double> pressure(count);
    thrust::copy(force_.begin() + first_[j], force_.begin() + first_[j + 1], pressure.begin());
    for (double& p : pressure) p /= nozzle.column_area();
    return pressure;
  }

 private:
  static bool any_holds_pressure(const std::vector<Nozzle>& nozzles) {
    for (const Nozzle& nozzle : nozzles)
      if (nozzle.holds_pressure()) return true;
    return false;
  }

  static std::vector<Index> upstream(Particles<D, P>& particles) {
    Array<Index> found(particles.size());
    const auto last = thrust::copy_if(loop_policy(), thrust::counting_iterator<Index>(0),
                                      thrust::counting_iterator<Index>(particles.size()),
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

  std::vector<Index> first_;     // column of each nozzle among those of all, and their number
  Array<Index> begin_, inside_;  // ColumnForce, of all columns
  Array<double> force_;          // N (2D: N/m), on each column
};

}  // namespace kerf
