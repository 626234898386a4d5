// SPDX-License-Identifier: Apache-2.0
// ListValidity decides how long a neighbour list is valid: until a pair that is not in it may have
// come within reach. The relative displacement of the two counts, not that of each: the water of a
// jet moves as one. The displacements of the particles of each patch (neighbours/patch_grids.hpp)
// are bounded. The list is valid while the relative displacement
//   - of any two particles of adjacent patches is at most the skin, and
//   - of any two particles, and of any particle and a point at rest, is at most the `slack`, the
//     distance by which a pair of patches that are not adjacent must approach to come within reach.
#pragma once

#include "neighbours/cell_order.hpp"
#include "neighbours/motion_bounds.hpp"
#include "neighbours/patch_grids.hpp"
#include "neighbours/step_motion.hpp"
#include "parallel/lane.hpp"
#include "particles/fields.hpp"

namespace kerf {

// Marks the patches that have particles.
template <int D>
struct MarkOccupied {
  LevelGrids<D> cells;
  PatchGrids<D> patches;
  const Index* cell_begin;
  std::uint8_t* marks;  // out

  struct Count {
    Index* particles;
    KERF_FUNCTION void operator()(Index begin, Index end) const { *particles += end - begin; }
  };
  KERF_FUNCTION void operator()(Index number) const {
    Index particles = 0;
    for_each_run(cells, cell_begin, patches.find(number), Count{&particles});
    marks[number] = particles > 0 ? 1 : 0;
  }
};

// Computes bounds of the displacements of the particles of a patch until the end of the `horizon`.
template <int D, class P>
struct BoundMotion {
  ParticleView<D, P> particles;
  LevelGrids<D> cells;
  PatchGrids<D> patches;
  CellOrder order;
  const Index* occupied;
  double horizon;           // s
  MotionBounds<D>* bounds;  // out, of each patch

  // The bounds of a share of its particles, `farthest` squared.
  KERF_FUNCTION MotionBounds<D> part(Index k, const Lane& lane) const {
    auto sum = MotionBounds<D>::none();
    for_each_run(cells, order.begin, patches.find(occupied[k]), Include{*this, lane, &sum});
    return sum;
  }
  KERF_FUNCTION MotionBounds<D> finish(Index k, MotionBounds<D> sum) const {
    const auto patch = patches.find(occupied[k]);
    sum.farthest = std::sqrt(sum.farthest);
    for (int a = 0; a < D; ++a)
      if (is_near_plane(patch, a)) sum.include_mirrored(a);
    return bounds[occupied[k]] = sum;
  }

 private:
  struct Include {
    const BoundMotion& bound;
    Lane lane;
    MotionBounds<D>* sum;

    KERF_FUNCTION void operator()(Index begin, Index end) const {
      const auto& all = bound.particles;
      for (Index place = begin + lane.number; place < end; place += lane.count) {
        const Index i = bound.order.particle(place);
        auto moved = all.position[i] - all.build_position[i];
        moved += bound.horizon * Vector<D, double>::from(all.velocity[i]);
        for (int a = 0; a < D; ++a) {
          sum->least[a] = moved[a] < sum->least[a] ? moved[a] : sum->least[a];
          sum->most[a] = moved[a] > sum->most[a] ? moved[a] : sum->most[a];
        }
        const double square = dot(moved, moved);
        if (!(square <= sum->farthest)) sum->farthest = square;
      }
    }
  };

  // Mirror images move too; particles far from a plane have none within reach.
  KERF_FUNCTION bool is_near_plane(const typename PatchGrids<D>::Patch& patch, int a) const {
    const auto& mirrors = particles.mirrors;
    const double margin = patches.grid[patch.level].cell;
    const bool low = (mirrors.faces & mirrors.low_face(a)) != 0;
    const bool high = (mirrors.faces & mirrors.high_face(a)) != 0;
    return (low && patches.low_side(patch, a) - mirrors.low[a] < margin) ||
           (high && mirrors.high[a] - patches.high_side(patch, a) < margin);
  }
};

// Returns the largest relative displacement of particles of a patch and those of adjacent ones, m.
template <int D>
struct LargestRelativeDisplacement {
  LevelGrids<D> cells;
  PatchGrids<D> patches;
  const Index* occupied;
  const MotionBounds<D>* bounds;

  // That of a share of the rows of patches.
  KERF_FUNCTION double part(Index k, const Lane& lane) const {
    const auto patch = patches.find(occupied[k]);
    double farthest = 0.0;
    Index row = 0;
    for (int level = 0; level < patches.levels; ++level)
      include_level(occupied[k], patch, level, {lane, &row, &farthest});
    return farthest;
  }
  KERF_FUNCTION double finish(Index, double farthest) const { return farthest; }

 private:
  struct Visited {
    Lane lane;
    Index* row;  // the number of the next one
    double* farthest;
  };
  // Visits the patches of a row, numbered within their level.
  struct VisitRow {
    const MotionBounds<D>* bounds;
    Index own, least, first_of_level;  // patches; those before `least` are skipped
    Visited visited;

    KERF_FUNCTION void operator()(Index first, Index last) const {
      if ((*visited.row)++ % visited.lane.count != visited.lane.number) return;
      double* const farthest = visited.farthest;
      for (Index other = first_of_level + first; other <= first_of_level + last; ++other) {
        if (other < least || bounds[own].farthest + bounds[other].farthest <= *farthest) continue;
        const double relative = bounds[own].relative(bounds[other]);
        if (relative > *farthest) *farthest = relative;
      }
    }
  };
  KERF_FUNCTION void include_level(Index own, const typename PatchGrids<D>::Patch& patch, int level,
                                   const Visited& visited) const {
    const Index least = level == patch.level ? own : 0;  // each pair of one level once
    for_each_adjacent_row(cells, patches, patch, level,
                          VisitRow{bounds, own, least, patches.first[level], visited});
  }
};

struct Larger {
  KERF_FUNCTION double operator()(double a, double b) const { return a < b ? b : a; }
};

// Marks the particles of patches that have moved farther than a distance.
template <int D>
struct MarkMoved {
  LevelGrids<D> cells;
  PatchGrids<D> patches;
  CellOrder order;
  const Index* occupied;
  const MotionBounds<D>* bounds;
  double distance;      // m
  std::uint8_t* moved;  // out, of each particle

  struct Mark {
    const MarkMoved& of;
    KERF_FUNCTION void operator()(Index begin, Index end) const {
      for (Index place = begin; place < end; ++place) of.moved[of.order.particle(place)] = 1;
    }
  };
  KERF_FUNCTION void operator()(Index k) const {
    if (bounds[occupied[k]].farthest <= distance) return;
    for_each_run(cells, order.begin, patches.find(occupied[k]), Mark{*this});
  }
};

template <int D, class P>
class ListValidity {
 public:
  ListValidity() = default;
  ListValidity(const LevelGrids<D>& cells, double skin)
      : cells_(cells), patches_(PatchGrids<D>::of(cells)), skin_(skin) {
    double nearest = cells.limit[0][0];
    for (int a = 0; a < cells.levels; ++a)
      for (int b = 0; b < cells.levels; ++b) nearest = std::min(nearest, cells.limit[a][b]);
    slack_ = (patch_margin - 1.0) * nearest + skin;
  }

  // Starts with a new list, or with one that is new in part, of particles in this order.
  void restart(const CellOrder& order) {
    occupied_.resize(patches_.count());
    marks_.resize(patches_.count());
    for_each_index(patches_.count(),
                   MarkOccupied<D>{cells_, patches_, order.begin, pointer(marks_)});
    const thrust::counting_iterator<Index> first(0);
    const auto end = thrust::copy_if(loop_policy(), first, first + patches_.count(),
                                     occupied_.begin(), IsSet{pointer(marks_)});
    count_ = static_cast<Index>(end - occupied_.begin());
    bounds_.resize(patches_.count());
    thrust::fill(bounds_.begin(), bounds_.end(), MotionBounds<D>::none());
    left_ = -1.0;  // particles may have moved already since they were listed
  }

  // Must be called for each step.
  void note(const StepMotion& motion) {
    travelled_ += motion.farthest;
    fastest_ = motion.fastest;
  }

  // Whether the noted steps alone show that it will be valid.
  bool holds_by_notes(double horizon) const {
    return 2.0 * rounding * (travelled_ + horizon * fastest_) <= left_;
  }

  // Returns whether the list will be valid after all particles have moved on for `horizon` seconds.
  // The particles are visited only where the noted steps leave that open, so that the answer does
  // not depend on the notes.
  bool holds(Particles<D, P>& particles, const CellOrder& order, double horizon) {
    if (holds_by_notes(horizon)) return true;
    const double left = left_at(particles, order, horizon);
    left_ = left - 2.0 * rounding * horizon * fastest_;  // without the prediction
    travelled_ = 0.0;
    return left >= 0.0;
  }

  // After holds() has found that the list will not: marks the particles of the patches that will
  // have moved farther than a share of the skin.
  void mark_moved(const CellOrder& order, double share, std::uint8_t* moved) const {
    for_each_index(count_, MarkMoved<D>{cells_, patches_, order, pointer(occupied_),
                                        pointer(bounds_), share * skin_, moved});
  }

  std::size_t bytes() const {
    return marks_.size() + occupied_.size() * sizeof(Index) +
           bounds_.size() * sizeof(MotionBounds<D>);
  }

 private:
  static constexpr double rounding = 1.0 + 1e-5;

  // Returns the relative displacement that is left then, m. Every pair of adjacent patches is whole
  // at one rank at least.
  double left_at(Particles<D, P>& particles, const CellOrder& order, double horizon) {
    const BoundMotion<D, P> bound{particles.view(),   cells_,  patches_,        order,
                                  pointer(occupied_), horizon, pointer(bounds_)};
    auto all = ranks::combined(
        reduce_in_groups(count_, bound, MotionBounds<D>::at_rest(), UniteBounds{}), UniteBounds{});
    for (int a = 0; a < D; ++a)
      if (MirrorPlanes<D>::flips(particles.mirrors.faces, a)) all.include_mirrored(a);
    const LargestRelativeDisplacement<D> farthest{cells_, patches_, pointer(occupied_),
                                                  pointer(bounds_)};
    const double relative =
        ranks::combined(reduce_in_groups(count_, farthest, 0.0, Larger{}), Larger{});
    return std::min(slack_ - all.relative(all), skin_ - relative);
  }

  LevelGrids<D> cells_{};
  PatchGrids<D> patches_{};
  double skin_ = 0.0, slack_ = 0.0;
  // Since the particles were last visited.
  double left_ = -1.0;      // m, relative displacement that was left
  double travelled_ = 0.0;  // m, bound of every displacement
  double fastest_ = 1e300;  // m/s
  Index count_ = 0;         // number of patches with particles
  Array<std::uint8_t> marks_;
  Array<Index> occupied_;
  Array<MotionBounds<D>> bounds_;
};

}  // namespace kerf
