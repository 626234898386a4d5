// SPDX-License-Identifier: Apache-2.0
// A fake simulation without computing cost: a block breaks under a jet by an artificial rule. Its
// steps vary and depend on the complete history, so that a run that loses any state when it is
// resumed gives different results.
#pragma once

#include <cmath>
#include <functional>
#include <string>

#include "input/read.hpp"
#include "simulation/simulation.hpp"
#include "support/frames.hpp"

namespace kerf::test {

inline const std::string fake_case_text = R"(title = "A made-up cut"
dimension = 2
[time]
end = "10 ms"
[[body]]
name = "block"
material = "tofu"
shape = { type = "box", minimum = ["-10 mm", "0 mm"], maximum = ["10 mm", "10 mm"] }
spacing = "2 mm"
[[body]]
name = "plate"
role = "rigid"
shape = { type = "box", minimum = ["-14 mm", "-4 mm"], maximum = ["14 mm", "0 mm"] }
spacing = "2 mm"
repulsion = "25 m2/s2"
[[jet]]
name = "jet"
material = "water"
speed = "5 m/s"
width = "4 mm"
position = ["0 mm", "10 mm"]
standoff = "6 mm"
spacing = "1 mm"
[[probe]]
name = "wall"
kind = "point"
position = ["0 mm", "5 mm"]
[output]
frame_interval = "1 ms"
picture_times = ["0 ms", "5 ms"]
series_interval = "0.2 ms"
checkpoint_interval = "1 h"
)";

inline Case fake_case() {
  return parse_case(fake_case_text, "fake.toml");
}

class FakeSimulation : public Simulation {
 public:
  // Calls `before_step` with the number of the next step before it is taken.
  explicit FakeSimulation(const Case& description,
                          std::function<void(std::uint64_t)> before_step = {})
      : end_(description.time.end), before_step_(std::move(before_step)) {}

  double cut_end = 0.0;        // s, at which the front is below the block; 0 = the end of the run
  double breaks_down = 1e300;  // s, from when on the kinetic energy is a hundred times too large

  void advance() override {
    if (before_step_) before_step_(step_ + 1);
    memory_ = std::fmod(1.7 * memory_ + 0.3, 1.0);
    dt_ = 2e-5 * (1.0 + 0.5 * memory_);
    limit_ = memory_ < 0.4 ? "acoustic (water)" : "acceleration";
    const bool last = time_ + dt_ >= end_;
    if (last) {
      dt_ = end_ - time_;
      limit_ = "end of run";
    }
    time_ = last ? end_ : time_ + dt_;
    ++step_;
  }
  bool finished() const override { return time_ >= end_; }
  double time() const override { return time_; }
  std::uint64_t step() const override { return step_; }
  std::size_t particles() const override { return frame().position.size(); }
  StepInfo last_step() const override { return {dt_, limit_, step_}; }

  Frame frame() const override {
    Frame frame;
    frame.time = time_;
    frame.step = step_;
    const double depth = 1.2e-2 * time_ / (cut_end > 0.0 ? cut_end : end_);
    for (int i = 0; i < 10; ++i) {
      for (int j = 0; j < 5; ++j) {
        const double x = 2e-3 * i - 9e-3, y = 2e-3 * j + 1e-3;
        const bool broken = std::abs(x) < 2e-3 && y > 1e-2 - depth;
        add_particle(frame, {x, y, 0.0}, broken ? Category::fractured : Category::solid, 2e-3);
      }
    }
    for (double y = 1.6e-2; y > 1e-2 - depth; y -= 1e-3)
      for (const double x : {-1.5e-3, -0.5e-3, 0.5e-3, 1.5e-3})
        add_particle(frame, {x, y, 0.0}, Category::water, 1e-3);
    for (std::size_t i = 0; i < frame.id.size(); ++i) {
      frame.id[i] = static_cast<std::uint32_t>(i);
      frame.source[i] = frame.category[i] == Category::water ? 2 : 0;
    }
    return frame;
  }
  Balance balance() const override {
    Balance balance;
    balance.mass_initial = balance.mass_now = 1.0;
    balance.energy_in = 1.0 + time_;
    balance.kinetic = (1.0 + time_) * (1.0 + 1e-3 * memory_) * (time_ < breaks_down ? 1.0 : 100.0);
    balance.force_rigid = {memory_, -time_, 0.0};
    balance.impulse_water = {0.0, -time_, 0.0};
    return balance;
  }
  std::vector<double> probe_values() const override { return {1e5 * memory_, time_, 0.0, 0.0}; }
  double pair_interactions() const override { return 100.0 * static_cast<double>(step_); }
  double neighbours_per_particle() const override { return 20.0; }
  double bytes_per_particle() const override { return 100.0; }
  std::vector<StageTime> stage_times() const override {
    return {{"rates", 1.0}, {"neighbours", 0.5}};  // in the order of their first use
  }

  void save(Archive& archive) const override {
    archive.arrays["state"] = std::vector<double>{time_, dt_, memory_};
    archive.arrays["step"] = std::vector<std::uint64_t>{step_};
    archive.texts["limit"] = limit_;
  }
  void restore(const Archive& archive) override {
    const auto& state = std::get<std::vector<double>>(archive.arrays.at("state"));
    time_ = state.at(0);
    dt_ = state.at(1);
    memory_ = state.at(2);
    step_ = std::get<std::vector<std::uint64_t>>(archive.arrays.at("step")).at(0);
    limit_ = archive.texts.at("limit");
  }

 private:
  double end_;
  std::function<void(std::uint64_t)> before_step_;
  double time_ = 0.0, dt_ = 0.0, memory_ = 0.1;
  std::uint64_t step_ = 0;
  std::string limit_;
};

}  // namespace kerf::test
