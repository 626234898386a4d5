// SPDX-License-Identifier: Apache-2.0
// Steps of a run and comparisons of the states of runs.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <string>

#include "core/error.hpp"
#include "engine/device.hpp"

namespace kerf::test {

inline void take_steps(Simulation& simulation, int steps) {
  for (int n = 0; n < steps && !simulation.finished(); ++n) simulation.advance();
}

inline Archive saved(const Simulation& simulation) {
  Archive archive;
  simulation.save(archive);
  return archive;
}

inline bool same_bits(const ArchiveArray& a, const ArchiveArray& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&](const auto& x) {
        const auto& y = std::get<std::decay_t<decltype(x)>>(b);
        return x.size() == y.size() &&
               (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0);
      },
      a);
}

// Compares the states from which two runs continue, bit for bit.
inline void expect_same_state(const Archive& a, const Archive& b) {
  ASSERT_EQ(a.arrays.size(), b.arrays.size());
  for (const auto& [name, array] : a.arrays) {
    ASSERT_TRUE(b.arrays.count(name)) << name;
    EXPECT_TRUE(same_bits(array, b.arrays.at(name))) << name << " differs";
  }
  EXPECT_EQ(a.texts, b.texts);
}

template <class T>
bool same_column(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

// Compares the output of two runs, bit for bit.
inline void expect_same_frame(const Frame& a, const Frame& b) {
  EXPECT_EQ(std::memcmp(&a.time, &b.time, sizeof(double)), 0);
  EXPECT_EQ(a.step, b.step);
  EXPECT_TRUE(same_column(a.id, b.id));
  EXPECT_TRUE(same_column(a.position, b.position));
  EXPECT_TRUE(same_column(a.velocity, b.velocity));
  EXPECT_TRUE(same_column(a.category, b.category));
  EXPECT_TRUE(same_column(a.source, b.source));
  EXPECT_TRUE(same_column(a.density, b.density));
  EXPECT_TRUE(same_column(a.pressure, b.pressure));
  EXPECT_TRUE(same_column(a.upstream, b.upstream));
  ASSERT_EQ(a.columns.size(), b.columns.size());
  for (std::size_t k = 0; k < a.columns.size(); ++k)
    EXPECT_TRUE(same_column(a.columns[k].values, b.columns[k].values)) << a.columns[k].name;
}

inline void expect_same_ledger(const Balance& a, const Balance& b) {
  EXPECT_EQ(std::memcmp(&a, &b, sizeof(Balance)), 0);
}

inline void expect_same_run(const Simulation& a, const Simulation& b) {
  expect_same_frame(a.frame(), b.frame());
  expect_same_ledger(a.balance(), b.balance());
  expect_same_state(saved(a), saved(b));
}

// Compares a run of 300 steps with one that is stopped after 170 steps and restored; returns the
// balance at the stop.
inline Balance expect_same_bits_after_restart(const Case& c) {
  const auto straight = make_simulation(c), first = make_simulation(c);
  take_steps(*straight, 300);
  take_steps(*first, 170);
  const auto second = make_simulation(c);
  second->restore(saved(*first));
  take_steps(*second, 130);
  expect_same_run(*straight, *second);
  return first->balance();
}

// Maps the id of each particle to its index in the frame.
inline std::map<std::uint32_t, std::size_t> by_id(const Frame& frame) {
  std::map<std::uint32_t, std::size_t> place;
  for (std::size_t k = 0; k < frame.id.size(); ++k) place[frame.id[k]] = k;
  return place;
}

inline std::size_t count_of(const Frame& frame, Category category) {
  return static_cast<std::size_t>(
      std::count(frame.category.begin(), frame.category.end(), category));
}

}  // namespace kerf::test
