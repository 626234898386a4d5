// SPDX-License-Identifier: Apache-2.0
// Artificial kerfs with known shapes, on regular and jittered lattices, with straight and inclined
// jets. Positions in a cut are (crosswise, depth along the jet, lengthwise), as in layout.hpp
// except for the sign of the depth.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "analysis/kerf.hpp"
#include "layout.hpp"

namespace kerf::layout {

inline constexpr int all_seeds = 20;
inline constexpr double most_jitter = 0.3;  // spacings
inline constexpr double steady = 0.05;      // change of a measure that a jittered layout may make

struct Carving {
  int dimension = 2;
  double angle = 0.0;           // rad, of the jet
  bool is_block_tilted = true;  // so that the jet is normal to its face
  Position low{-50.0 * mm, -thickness, -20.0 * mm};
  Position high{50.0 * mm, 0.0, 20.0 * mm};
  std::function<bool(const Position&)> is_gone;  // by position before the tilt
  double time = 0.0;                             // s, of the frame
  KerfConditions conditions;

  // A tilted block differs in its coordinates only: both layouts test these.
  int seeds() const { return dimension == 3 && angle != 0.0 && is_block_tilted ? 2 : all_seeds; }
  Case description() const { return make_case(dimension, angle); }

  // The block before the cut; seed 0 = the regular lattice.
  Frame lay_out(int seed) const {
    Frame frame;
    frame.dimension = dimension;
    add_box(frame, solid(), low, high);
    if (seed > 0) jitter(frame, most_jitter, static_cast<unsigned>(seed));
    return frame;
  }
  // Removed particles are chosen by their positions on the regular lattice, so that jitter only
  // displaces particles.
  Kerf measure(int seed) const {
    const Frame regular = lay_out(0);
    Frame initial = lay_out(seed), frame = initial;
    for (std::size_t row = 0; row < frame.position.size(); ++row)
      if (is_gone(regular.position[row])) frame.category[row] = Category::fractured;
    return measure_pair(std::move(initial), std::move(frame));
  }
  // Removed particles are chosen by their jittered positions, so that each seed removes different
  // ones.
  Kerf measure_recut(int seed) const {
    Frame initial = lay_out(seed), frame = initial;
    change(frame, Category::fractured, is_gone);
    return measure_pair(std::move(initial), std::move(frame));
  }
  // A change of frames before the tilt.
  Kerf measure_pair(Frame initial, Frame frame) const {
    if (is_block_tilted) tilt(initial, angle);
    if (is_block_tilted) tilt(frame, angle);
    frame.time = time;
    const CutMonitor monitor(description(), initial);
    return measure_kerf(monitor.workpiece(), frame, conditions);
  }
};

inline double depth_of(const Kerf& kerf) {
  return kerf.shape.depth;
}

struct Measure {
  std::string what;
  std::function<double(const Kerf&)> of;
  double exact = 0.0;
  double bound = solid_spacing;
};

// The measurements are within their bounds on the regular lattice and on jittered ones with either
// choice of removed particles, and jitter changes them by less than 5%. The largest change is
// recorded.
inline void expect_steady(const Carving& carving, const std::vector<Measure>& measures) {
  const Kerf regular = carving.measure(0);
  std::vector<double> most(measures.size(), 0.0), error = most;
  for (int seed = 0; seed <= carving.seeds(); ++seed) {
    const Kerf jittered = carving.measure(seed), recut = carving.measure_recut(seed);
    for (std::size_t n = 0; n < measures.size(); ++n) {
      const auto& [what, of, exact, bound] = measures[n];
      const double before = of(regular), now = of(jittered);
      EXPECT_NEAR(now, exact, bound) << what << ", seed " << seed;
      EXPECT_NEAR(of(recut), exact, bound) << what << ", seed " << seed << " cut anew";
      EXPECT_NEAR(now, before, steady * std::abs(before)) << what << ", seed " << seed;
      most[n] = std::max(most[n], std::abs(now / before - 1.0));
      error[n] = std::max({error[n], std::abs(now - exact), std::abs(of(recut) - exact)});
    }
  }
  for (std::size_t n = 0; n < measures.size(); ++n) {
    const auto& [what, of, exact, bound] = measures[n];
    testing::Test::RecordProperty(what, std::to_string(100.0 * most[n]).substr(0, 4) + "%, " +
                                            std::to_string(error[n] / bound).substr(0, 4));
  }
}

}  // namespace kerf::layout
