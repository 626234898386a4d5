// SPDX-License-Identifier: Apache-2.0
// NearestPoint finds the distance from the nearest of a set of points, with the tree of
// Boost.Geometry.
#pragma once

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "core/vector.hpp"

namespace kerf {

template <int D>
class NearestPoint {
 public:
  using Position = Vector<D, double>;

  explicit NearestPoint(const std::vector<Position>& points) {
    std::vector<Entry> entries;
    entries.reserve(points.size());
    for (const Position& x : points) entries.push_back(entry_of(x));
    tree_ = Tree(entries.begin(), entries.end());
  }

  // Returns the distance from the nearest point, m; infinity where there is none.
  double distance(const Position& x) const {
    const Entry from = entry_of(x);
    const auto nearest = tree_.qbegin(boost::geometry::index::nearest(from, 1));
    if (nearest == tree_.qend()) return std::numeric_limits<double>::infinity();
    return boost::geometry::distance(from, *nearest);
  }

 private:
  using Entry = boost::geometry::model::point<double, D, boost::geometry::cs::cartesian>;
  using Tree = boost::geometry::index::rtree<Entry, boost::geometry::index::quadratic<16>>;

  static Entry entry_of(const Position& x) {
    Entry entry;
    boost::geometry::set<0>(entry, x[0]);
    boost::geometry::set<1>(entry, x[1]);
    if constexpr (D == 3) boost::geometry::set<2>(entry, x[2]);
    return entry;
  }

  Tree tree_;
};

}  // namespace kerf
