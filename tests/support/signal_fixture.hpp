// SPDX-License-Identifier: Apache-2.0
// Signals of a run whose case is given as text.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "engine/device.hpp"
#include "input/read.hpp"
#include "verification/signal.hpp"

namespace kerf::test {

class SignalFixture : public ::testing::Test {
 protected:
  explicit SignalFixture(std::string_view text)
      : description_(parse_case(text, "test")),
        simulation_(make_simulation(description_)),
        beginning_(description_, *simulation_) {}

  double value(const std::map<std::string, std::string>& keys) {
    Parameters parameters("test");
    for (const auto& [key, text] : keys) parameters.set(key, text);
    Moment moment(beginning_, *simulation_);
    return make_signal(parameters, beginning_)(moment);
  }
  void finish() {
    while (!simulation_->finished()) simulation_->advance();
  }

  Case description_;
  std::unique_ptr<Simulation> simulation_;
  Beginning beginning_;
};

}  // namespace kerf::test
