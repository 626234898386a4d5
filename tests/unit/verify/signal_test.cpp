// SPDX-License-Identifier: Apache-2.0
// Signals on runs of a few particles whose motion is known.
#include "verify/signal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "case/read.hpp"
#include "support/fake_simulation.hpp"

namespace kerf {
namespace {

constexpr std::string_view flying_block = R"(
title = "a block flies through empty space"
dimension = 2
[time]
end = "1 ms"
[domain]
minimum = ["-100 mm", "-100 mm"]
maximum = ["100 mm", "100 mm"]
[[body]]
name = "block"
material = "rubber"
shape = { type = "box", minimum = ["0 mm", "0 mm"], maximum = ["20 mm", "10 mm"] }
spacing = "1 mm"
velocity = ["3 m/s", "-2 m/s"]
[[probe]]
name = "point"
position = ["10 mm", "5 mm"]
[[probe]]
name = "plane"
kind = "plane"
position = ["10 mm", "0 mm"]
normal = [1, 0]
)";

class SignalTest : public ::testing::Test {
 protected:
  explicit SignalTest(std::string_view text = flying_block)
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

TEST_F(SignalTest, BodyMeanOfAFreeFlight) {
  finish();
  const double seconds = simulation_->time();
  EXPECT_NEAR(value({{"signal", "body_mean"}, {"field", "velocity"}, {"axis", "x"}}), 3.0, 1e-5);
  const double moved = value({{"signal", "body_mean"}, {"field", "displacement"}, {"axis", "y"}});
  EXPECT_NEAR(moved / (-2.0 * seconds), 1.0, 1e-5);
}

TEST_F(SignalTest, BodyMeanProjectsOnAMode) {
  // Of a constant, on a cosine over its whole length: nothing. On the sine: 1 / mean |sin| x mean.
  EXPECT_NEAR(value({{"signal", "body_mean"},
                     {"field", "velocity"},
                     {"axis", "x"},
                     {"weight", "cos(pi*x/0.02)"}}),
              0.0, 1e-6);
  EXPECT_NEAR(value({{"signal", "body_mean"},
                     {"field", "velocity"},
                     {"axis", "x"},
                     {"weight", "sin(pi*x/0.02)"}}),
              3.0, 1e-5);
}

TEST_F(SignalTest, KineticCentroidOfAnEvenMotionIsTheMiddle) {
  EXPECT_NEAR(value({{"signal", "kinetic_centroid"}, {"axis", "x"}}), 0.010, 1e-7);
  EXPECT_NEAR(value({{"signal", "kinetic_centroid"}, {"axis", "x"}, {"weight", "x > 0.01"}}), 0.015,
              1e-7);
}

TEST_F(SignalTest, ProbesByNameAndComponent) {
  EXPECT_NEAR(value({{"signal", "probe"}, {"probe", "point"}, {"component", "y"}}), -2.0, 1e-5);
  EXPECT_NEAR(value({{"signal", "probe"}, {"probe", "plane"}, {"component", "x"}}), 0.0, 1e-6);
}

TEST_F(SignalTest, LedgerKeepsTheKineticEnergy) {
  const double expected = 0.5 * 1000.0 * 0.02 * 0.01 * (9.0 + 4.0);
  EXPECT_NEAR(value({{"signal", "ledger"}, {"field", "kinetic"}}) / expected, 1.0, 1e-6);
}

TEST_F(SignalTest, AFlyingBlockIsNotStretched) {
  finish();
  EXPECT_NEAR(value({{"signal", "largest_stretch"}}), 1.0, 1e-5);
}

TEST_F(SignalTest, AsymmetryOfABlockBesideTheMirror) {
  // The image of the block at 0 to 20 mm lies at -20 to 0 mm: nothing there within a spacing.
  EXPECT_NEAR(value({{"signal", "asymmetry"}, {"axis", "x"}}), 1.0, 1e-12);
}

TEST_F(SignalTest, RefusesWhatThereIsNot) {
  EXPECT_THROW(value({{"signal", "colour"}}), std::logic_error);
  EXPECT_THROW(value({{"signal", "probe"}, {"probe", "nowhere"}, {"component", "x"}}),
               std::logic_error);
  EXPECT_THROW(value({{"signal", "probe"}, {"probe", "plane"}, {"component", "pressure"}}),
               std::logic_error);
  EXPECT_THROW(
      value({{"signal", "body_mean"}, {"field", "velocity"}, {"axis", "x"}, {"body", "ghost"}}),
      std::logic_error);
  EXPECT_THROW(
      value({{"signal", "body_mean"}, {"field", "velocity"}, {"axis", "x"}, {"weight", "0"}}),
      std::logic_error);
}

constexpr std::string_view symmetric_pair = R"(
title = "two blocks of water, mirror images but for a shift"
dimension = 2
[time]
end = "1 ms"
[domain]
minimum = ["-100 mm", "-100 mm"]
maximum = ["100 mm", "100 mm"]
[materials.calm]
base = "water"
sound_speed = "10 m/s"
[[body]]
name = "both"
material = "calm"
spacing = "2 mm"
offset = ["0.25 mm", "0 mm"]
shape = { type = "union", parts = [
  { type = "box", minimum = ["-30 mm", "0 mm"], maximum = ["-10 mm", "10 mm"] },
  { type = "box", minimum = ["10 mm", "0 mm"], maximum = ["30 mm", "10 mm"] } ] }
)";

class PairTest : public SignalTest {
 protected:
  PairTest() : SignalTest(symmetric_pair) {}
};

TEST_F(PairTest, AsymmetryIsTwiceTheShift) {
  EXPECT_NEAR(value({{"signal", "asymmetry"}, {"axis", "x"}}), 2.0 * 0.25 / 2.0,
              1e-7);  // places in a frame are exact, sizes are float
}

TEST_F(PairTest, ProfileErrorOfNoPressureIsOne) {
  EXPECT_NEAR(value({{"signal", "profile_error"}, {"body", "both"}, {"formula", "1000*(0.1-y)"}}),
              1.0, 1e-12);
}

// A hydrostatic block whose rows, 2 mm high, lie above and below the right pressure in turn.
class RippledSimulation : public test::FakeSimulation {
 public:
  using FakeSimulation::FakeSimulation;
  Frame frame() const override {
    Frame frame = FakeSimulation::frame();
    for (std::size_t row = 0; row < frame.id.size(); ++row) {
      const double y = frame.position[row][1];
      const double ripple = std::lround(std::floor(y / 2e-3)) % 2 == 0 ? 20.0 : -20.0;
      frame.pressure[row] = static_cast<float>(1000.0 * (0.1 - y) + ripple);
    }
    return frame;
  }
};

TEST(ProfileError, LayersOfTwoRowsAverageOutARipple) {
  const Case description = test::fake_case();
  const RippledSimulation simulation(description);
  Beginning beginning(description, simulation);
  const auto error = [&](const std::string& layer) {
    Parameters parameters("test");
    parameters.set("signal", "profile_error");
    parameters.set("body", "block");
    parameters.set("weight", "y < 0.008");  // four rows
    parameters.set("formula", "1000*(0.1-y)");
    parameters.set("layer", layer);
    Moment moment(beginning, simulation);
    return make_signal(parameters, beginning)(moment);
  };
  const double scale = std::hypot(std::hypot(99.0, 97.0), std::hypot(95.0, 93.0));
  EXPECT_NEAR(error("1"), std::hypot(20.0, 20.0) * std::sqrt(2.0) / scale, 1e-6);
  EXPECT_NEAR(error("2"), 0.0, 1e-6);
}

constexpr std::string_view wet_block = R"(
title = "a jet and a layer of liquid above a block"
dimension = 2
formulation = "standard"
[time]
end = "1 ms"
[domain]
minimum = ["-100 mm", "-100 mm"]
maximum = ["100 mm", "100 mm"]
[[body]]
name = "block"
material = "rubber"
shape = { type = "box", minimum = ["-20 mm", "-10 mm"], maximum = ["20 mm", "0 mm"] }
spacing = "2 mm"
[[body]]
name = "layer"
material = "water"
shape = { type = "box", minimum = ["-10 mm", "0 mm"], maximum = ["10 mm", "4 mm"] }
spacing = "1 mm"
[[jet]]
name = "jet"
speed = "5 m/s"
width = "4 mm"
position = ["0 mm", "4 mm"]
standoff = "1 mm"
spacing = "1 mm"
)";

class WetBlockTest : public SignalTest {
 protected:
  WetBlockTest() : SignalTest(wet_block) {}
};

TEST_F(WetBlockTest, WaterLiesHalfASpacingOfItsOwnAboveTheTop) {
  EXPECT_NEAR(value({{"signal", "deepest_water"}, {"body", "block"}}), -0.5 / 2.0, 1e-6);
}

TEST_F(WetBlockTest, TheTipOfAJetThatHasJustLeftLiesBetweenItAndTheLiquid) {
  // The uppermost row of the layer is half a spacing below the point aimed at, the water of the jet
  // within the nozzle, a millimetre and more above it.
  const double tip = value({{"signal", "jet_tip"}, {"body", "layer"}});
  EXPECT_GE(tip, 0.5 * (-1.0e-3 + 0.5e-3) - 1e-9);
  EXPECT_LE(tip, 0.5e-3);
}

TEST_F(WetBlockTest, NoElasticEnergyNoHourglassShare) {
  EXPECT_EQ(value({{"signal", "hourglass_share"}}), 0.0);
}

TEST_F(WetBlockTest, RefusesABodyThatThereIsNot) {
  EXPECT_THROW(value({{"signal", "deepest_water"}, {"body", "ghost"}}), std::logic_error);
  EXPECT_THROW(value({{"signal", "jet_tip"}, {"body", "ghost"}}), std::logic_error);
}

}  // namespace
}  // namespace kerf
