// SPDX-License-Identifier: Apache-2.0
// A cut counts wherever a nozzle that travels makes it, and depths wherever on its axis it aims.
#include <gtest/gtest.h>

#include "analysis/cut.hpp"
#include "bonded_layout.hpp"

namespace kerf {
namespace {

using namespace layout;

// A nozzle that crosses a plane block with 2 m/s towards `way`, in a layout turned by its angle.
struct Crossing {
  double angle = 0.0, way = 1.0, time = 20e-3;
  bool has_bonds = true;
  double beside = 0.0;  // s, for which the nozzle moves beside the block first

  bool cuts(const std::function<bool(const Position&)>& gone,
            const std::function<bool(const Position&)>& never_there = {}) const {
    Case description = make_case(2, angle);
    Jet& jet = description.jets[0];
    jet.traverse = {2.0 * way * std::cos(angle), 2.0 * way * std::sin(angle), 0.0};
    for (std::size_t a = 0; a < 2; ++a) jet.position[a] -= beside * jet.traverse[a];
    jet.time_beside = beside;
    Frame initial = make_block(2);
    if (never_there)
      initial = select(initial, rows_of(initial),
                       [&](std::size_t k) { return !never_there(initial.position[k]); });
    for (std::size_t k = 0; k < initial.id.size(); ++k)
      initial.id[k] = static_cast<std::uint32_t>(k);
    Frame frame = initial;
    frame.time = time + beside;
    change(frame, Category::fractured, [&](const Position& x) {
      return gone({way * x[0], x[1], 0.0});
    });
    if (has_bonds) {
      bond(initial, frame);
      bond(initial, initial);
      add_water_beside_bonds(frame, description, 20.0 * mm);
    } else {
      add_water(frame, description, 20.0 * mm, jet_width);
    }
    tilt(initial, angle);
    tilt(frame, angle);
    CutMonitor monitor(description, initial);
    monitor.observe(frame);
    return monitor.summary().cut_through;
  }
};

std::vector<Crossing> crossings() {
  std::vector<Crossing> all;
  for (const double angle : {0.0, 0.4, -0.7})
    for (const double way : {1.0, -1.0})
      for (const bool has_bonds : {true, false}) all.push_back({angle, way, 20e-3, has_bonds});
  return all;
}

bool is_slot(const Position& x, double low, double high, double bottom = -thickness) {
  return x[0] > low && x[0] < high && x[1] > bottom;
}

TEST(CutOnAPath, CountsWhereverItIs) {
  for (const Crossing& crossing : crossings())
    for (const double place : {0.0, 12.0 * mm, 24.0 * mm, 36.0 * mm})
      EXPECT_TRUE(crossing.cuts([=](const Position& x) {
        return is_slot(x, place - 4.0 * mm, place + 4.0 * mm);
      })) << place
          << " " << crossing.angle << " " << crossing.way;
}

TEST(CutOnAPath, CountsFromTheEdgeOnForANozzleFromBeside) {
  for (Crossing crossing : crossings()) {
    crossing.beside = 10e-3;
    for (const double place : {0.0, 24.0 * mm, 36.0 * mm})
      EXPECT_TRUE(crossing.cuts([=](const Position& x) {
        return is_slot(x, place - 4.0 * mm, place + 4.0 * mm);
      })) << place
          << " " << crossing.angle << " " << crossing.way;
    crossing.time = 5e-3;
    EXPECT_FALSE(crossing.cuts([](const Position& x) { return is_slot(x, 20.0 * mm, 28.0 * mm); }))
        << crossing.angle;
  }
}

TEST(CutOnAPath, AFloorThatStandsIsNoCut) {
  for (const Crossing& crossing : crossings())
    EXPECT_FALSE(crossing.cuts([](const Position& x) {
      return is_slot(x, -5.0 * mm, 45.0 * mm, -thickness + 2.5 * mm);
    })) << crossing.angle;
}

TEST(CutOnAPath, WhatTheNozzleHasNotReachedIsNoCut) {
  for (Crossing crossing : crossings()) {
    crossing.time = 5e-3;  // 10 mm of travel
    EXPECT_FALSE(crossing.cuts([](const Position& x) { return is_slot(x, 20.0 * mm, 28.0 * mm); }))
        << crossing.angle;
  }
}

// A gap of the layout that the nozzle crosses is no cut, nor is a cut beside it that has a floor.
TEST(CutOnAPath, AGapOfTheLayoutIsNoCut) {
  const auto gap = [](const Position& x) {
    return std::abs(std::abs(x[0]) - 20.0 * mm) < 3.0 * mm;
  };
  for (const Crossing& crossing : crossings())
    EXPECT_FALSE(crossing.cuts(
        [](const Position& x) { return is_slot(x, -4.0 * mm, 4.0 * mm, -30.0 * mm); }, gap))
        << crossing.angle;
}

// The same water and nozzle, with the aim before, on and behind the face.
TEST(AimPoint, DepthsAreThoseBelowTheFace) {
  for (const int dimension : {2, 3})
    for (const double angle : {0.0, 0.4}) {
      Frame initial = make_block(dimension), frame = initial;
      Case description = make_case(dimension, angle);
      add_water(frame, description, 30.0 * mm, jet_width);
      tilt(initial, angle);
      tilt(frame, angle);
      const double depth = CutMonitor(description, initial).observe(frame).front_depth;
      EXPECT_NEAR(depth, 29.0 * mm, 1.1 * mm);
      for (const double below : {-15.0 * mm, 12.0 * mm, 40.0 * mm, 60.0 * mm}) {
        Case other = make_case(dimension, angle);
        other.jets[0].position = {std::sin(angle) * below, -std::cos(angle) * below, 0.0};
        other.jets[0].standoff += below;
        const CutMonitor monitor(other, initial);
        ASSERT_TRUE(monitor.workpiece().jet.has_value());
        EXPECT_NEAR(monitor.workpiece().jet->standoff, 20.0 * mm, solid_spacing);
        EXPECT_NEAR(CutMonitor(other, initial).observe(frame).front_depth, depth, solid_spacing)
            << dimension << " " << angle << " " << below;
      }
    }
}

}  // namespace
}  // namespace kerf
