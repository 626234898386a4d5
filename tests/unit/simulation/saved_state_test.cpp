// SPDX-License-Identifier: Apache-2.0
// The state of a run is tested before the engine takes it.
#include "simulation/saved_state.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "core/error.hpp"
#include "input/read.hpp"
#include "model/case.hpp"
#include "support/small_block.hpp"
#include "support/temporary_folder.hpp"

namespace kerf::test {
namespace {

using testing::HasSubstr;

// The state of that many particles, of which the last one is water.
Archive state_of(std::size_t particles) {
  Archive state;
  auto& arrays = state.arrays;
  for (const char* name : {"position", "build_position"})
    arrays[std::string("particles/") + name] = std::vector<double>(2 * particles, 0.001);
  arrays["particles/velocity"] = std::vector<float>(2 * particles, 1.0f);
  arrays["particles/compression"] = std::vector<float>(particles, 0.0f);
  std::vector<std::uint32_t> id(particles);
  for (std::uint32_t i = 0; i < particles; ++i) id[i] = i;
  std::vector<std::uint16_t> source(particles, 0);
  source.back() = 1;
  arrays["particles/id"] = id;
  arrays["particles/source"] = source;
  arrays["particles/inlet_column"] = std::vector<std::uint32_t>(particles, 0);
  arrays["particles/flags"] = std::vector<std::uint8_t>(particles, 0);
  arrays["clock"] = std::vector<double>{0.0, 1e-6};
  arrays["counters"] = std::vector<std::uint64_t>{1, particles, 0, 0};
  arrays["nozzle/0"] = std::vector<std::uint64_t>{1, 2};
  arrays["solid/wave"] = std::vector<double>{1e300, 0.0, 0.0};
  arrays["solid/cycle"] = std::vector<double>{0.0, 1.0};
  arrays["solid/elastic_share"] = std::vector<float>(4, 1.0f);
  state.texts["limit"] = "acoustic (water)";
  return state;
}

std::string refusal(const std::function<void(Archive&)>& change) {
  Archive state = state_of(7);
  change(state);
  return message_of<UserError>(
      [&] { check_saved_state(state, state_of(5), parse_case(small_block, "a.toml")); });
}

TEST(SavedState, MayHoldMoreParticlesThanAtTheStart) {
  EXPECT_EQ(refusal([](Archive&) {}), "");
}

TEST(SavedState, WhatTheEngineCannotTakeIsNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto set = [](const char* name, auto values) {
    return [name, values](Archive& state) { state.arrays[name] = values; };
  };
  using Reals = std::vector<double>;
  using Counts = std::vector<std::uint64_t>;
  EXPECT_THAT(refusal([](Archive& state) { state.arrays.erase("clock"); }), HasSubstr("'clock'"));
  EXPECT_THAT(refusal([](Archive& state) { state.texts.clear(); }), HasSubstr("'limit'"));
  EXPECT_THAT(refusal(set("clock", Reals{0.0})), HasSubstr("'clock' has another length"));
  EXPECT_THAT(refusal(set("clock", Reals{nan, 1e-6})), HasSubstr("'clock' has a value"));
  EXPECT_THAT(refusal(set("clock", Counts{1, 2})), HasSubstr("'clock' is of another type"));
  EXPECT_THAT(refusal(set("particles/position", Reals(13, 0.0))), HasSubstr("another length"));
  EXPECT_THAT(refusal(set("particles/position", Reals(14, nan))), HasSubstr("not a number"));
  EXPECT_THAT(refusal(set("nozzle/0", Counts{1})), HasSubstr("'nozzle/0' has another length"));
  EXPECT_THAT(refusal(set("solid/wave", Reals{1.0, 4.0, 0.0})), HasSubstr("'solid/wave'"));
  EXPECT_THAT(refusal(set("solid/cycle", Reals{nan, 1.0})), HasSubstr("'solid/cycle'"));
  EXPECT_THAT(refusal(set("particles/source", std::vector<std::uint16_t>(7, 2))),
              HasSubstr("'particles/source' has a number that is too great"));
  EXPECT_THAT(refusal(set("counters", Counts{1, 6, 0, 0})), HasSubstr("'particles/id'"));
  EXPECT_THAT(refusal(set("particles/inlet_column", std::vector<std::uint32_t>(7, 2))),
              HasSubstr("'particles/inlet_column'"));
  std::vector<std::uint8_t> upstream(7, 0);
  upstream.back() = 2;  // water in its nozzle
  EXPECT_EQ(refusal(set("particles/flags", upstream)), "");
  upstream.front() = 2;  // the block
  EXPECT_THAT(refusal(set("particles/flags", upstream)), HasSubstr("'particles/flags'"));
}

}  // namespace
}  // namespace kerf::test
