// SPDX-License-Identifier: Apache-2.0
// A neighbour list is refreshed where particles have come, have moved or interact differently, and
// kept elsewhere. A build position is where a particle was when it was last listed, a time of its
// own for each particle: the list has every pair whose build positions are within the cutoff and
// the skin.
#pragma once

#include <cmath>

#include "neighbours/unmoved_particles.hpp"

namespace kerf {

// Marks the particles that have become fluid since they were listed.
template <int D, class P>
struct MarkFractured {
  ParticleView<D, P> particles;
  const std::uint8_t* listed_as;
  std::uint8_t* marks;

  KERF_FUNCTION void operator()(Index i) const {
    marks[i] = particles.fractured[i] != listed_as[i] ? 1 : 0;
  }
};

// Marks the particles whose list may change when a marked one is listed at its position, or at its
// build position: those within the cutoff of the one or the other, and of its mirror images.
template <int D, class P>
struct MarkAround {
  ParticleView<D, P> particles;
  LevelGrids<D> grids;
  CellOrder order;      // of the build positions
  UnmovedView unmoved;  // in this order
  const std::uint8_t* moved;
  bool moves;                 // the marked ones get new build positions
  std::uint8_t* listed_anew;  // out

  KERF_FUNCTION void operator()(Index i) const {
    if (moved[i] == 0) return;
    set_flag(listed_anew[i]);
    const Places own{particles.build_position[i],
                     moves ? particles.position[i] : particles.build_position[i]};
    mark(i, 0, own);
    const auto& mirrors = particles.mirrors;
    if (mirrors.faces == 0) return;
    for (int image = 1; image < MirrorPlanes<D>::images; ++image)
      if (MirrorCode code; mirrors.find_image(image, code)) mark(i, code, own);
  }

 private:
  struct Places {
    Vector<D, double> before, now;
  };
  struct MarkRow {
    const MarkAround& around;
    const Places& places;
    double limit_squared;

    KERF_FUNCTION void operator()(Index begin, Index end) const {
      const UnmovedView& others = around.unmoved;
      for (Index k = others.before[begin]; k < others.before[end]; ++k) {
        const Index j = others.particle[k];
        if (load_flag(around.listed_anew[j]) != 0) continue;
        const auto& x = around.particles.build_position[j];
        const auto from_before = x - places.before, from_now = x - places.now;
        if (dot(from_before, from_before) < limit_squared ||
            dot(from_now, from_now) < limit_squared)
          set_flag(around.listed_anew[j]);
      }
    }
  };

  // `code`: the image by which the particle at `own` acts; 0: itself.
  KERF_FUNCTION void mark(Index i, MirrorCode code, const Places& own) const {
    constexpr double rounding = 1.0 + 1e-6;
    const auto& mirrors = particles.mirrors;
    const Places places{mirrors.image_position(code, own.before),
                        mirrors.image_position(code, own.now)};
    for (int level = 0; level < grids.levels; ++level) {
      const double limit = rounding * grids.limit[particles.medium(i).level][level];
      if (!mirrors.is_near(code, own.before, limit) && !mirrors.is_near(code, own.now, limit))
        continue;
      Vector<D, double> minimum, maximum;
      for (int a = 0; a < D; ++a) {
        minimum[a] = std::fmin(places.before[a], places.now[a]) - limit;
        maximum[a] = std::fmax(places.before[a], places.now[a]) + limit;
      }
      const MarkRow mark_row{*this, places, limit * limit};
      grids.grid[level].for_each_row(
          minimum, maximum, ParticlesOfRow<MarkRow>{order.begin + grids.first[level], mark_row});
    }
  }
};

// A measure of the disorder of the particles of a group since they were sorted: how many are in a
// cell before that of their predecessor, or have joined since then.
struct DisorderOfGroup {
  GroupView groups;
  const Index *cell, *sorted_cell;  // of each particle, now and when they were sorted

  KERF_FUNCTION Index operator()(Index group) const {
    const Index first = groups.begin[group], last = groups.begin[group + 1];
    Index late = sorted_cell[first] == unsorted ? 1 : 0;
    for (Index i = first + 1; i < last; ++i) late += cell[i] < cell[i - 1] ? 1 : 0;
    return late;
  }
};

// Whether a particle is marked and not a ghost.
template <int D, class P>
struct IsMarked {
  ParticleView<D, P> particles;
  const std::uint8_t* marks;
  KERF_FUNCTION bool operator()(Index i) const { return marks[i] != 0 && !particles.ghosts.has(i); }
};

// Lists the marked particles at their positions from now on.
template <int D, class P>
struct MoveBuildPosition {
  ParticleView<D, P> particles;
  const std::uint8_t* moved;

  KERF_FUNCTION void operator()(Index i) const {
    if (moved[i] != 0) particles.build_position[i] = particles.position[i];
  }
};

}  // namespace kerf
