// SPDX-License-Identifier: Apache-2.0
// Signals of runs of a few particles with known motion.
#include "verification/signal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "input/read.hpp"
#include "support/fake_simulation.hpp"
#include "support/signal_fixture.hpp"

namespace kerf {
namespace {

constexpr std::string_view flying_block = R"(
title = "a block flies through empty space"
dimension = 2
formulation = "shinohara2004"
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

class SignalTest : public test::SignalFixture {
 protected:
  explicit SignalTest(std::string_view text = flying_block) : SignalFixture(text) {}
};

TEST_F(SignalTest, BodyMeanOfAFreeFlight) {
  finish();
  const double seconds = simulation_->time();
  EXPECT_NEAR(value({{"signal", "body_mean"}, {"field", "velocity"}, {"axis", "x"}}), 3.0, 1e-5);
  const double moved = value({{"signal", "body_mean"}, {"field", "displacement"}, {"axis", "y"}});
  EXPECT_NEAR(moved / (-2.0 * seconds), 1.0, 1e-5);
}

TEST_F(SignalTest, BodyMeanRelativeToItselfIsZero) {
  EXPECT_NEAR(value({{"signal", "body_mean"},
                     {"field", "velocity"},
                     {"axis", "x"},
                     {"weight", "x > 0.01"},
                     {"less", "block"}}),
              0.0, 1e-6);
}

TEST_F(SignalTest, BodyMeanProjectsOnAMode) {
  // The projection of a constant on a full cosine is 0; on the sine it is 1 / mean
  // sin
  // x mean.
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

TEST_F(SignalTest, KineticCentroidOfAUniformMotionIsTheCentre) {
  EXPECT_NEAR(value({{"signal", "kinetic_centroid"}, {"axis", "x"}}), 0.010, 1e-7);
  EXPECT_NEAR(value({{"signal", "kinetic_centroid"}, {"axis", "x"}, {"weight", "x > 0.01"}}), 0.015,
              1e-7);
}

TEST_F(SignalTest, ProbesByNameAndComponent) {
  EXPECT_NEAR(value({{"signal", "probe"}, {"probe", "point"}, {"component", "y"}}), -2.0, 1e-5);
  EXPECT_NEAR(value({{"signal", "probe"}, {"probe", "plane"}, {"component", "x"}}), 0.0, 1e-6);
}

TEST_F(SignalTest, BalanceSignalIsTheKineticEnergy) {
  const double expected = 0.5 * 1000.0 * 0.02 * 0.01 * (9.0 + 4.0);
  EXPECT_NEAR(value({{"signal", "balance"}, {"field", "kinetic"}}) / expected, 1.0, 1e-6);
}

TEST_F(SignalTest, AFlyingBlockIsNotStretched) {
  finish();
  EXPECT_NEAR(value({{"signal", "largest_stretch"}}), 1.0, 1e-5);
}

TEST_F(SignalTest, BrokenBondsNeedTheStandardFormulation) {
  EXPECT_THROW(value({{"signal", "largest_damage"}}), std::logic_error);
}

TEST_F(SignalTest, ExtentIsFromSurfaceToSurface) {
  finish();
  EXPECT_NEAR(value({{"signal", "extent"}, {"body", "block"}, {"along", "x"}}), 20e-3, 1e-6);
  EXPECT_NEAR(value({{"signal", "extent"}, {"body", "block"}, {"along", "y"}}), 10e-3, 1e-6);
  EXPECT_THROW(value({{"signal", "extent"}, {"body", "block"}, {"along", "t"}}), std::logic_error);
  EXPECT_THROW(value({{"signal", "extent"}, {"body", "ghost"}, {"along", "x"}}), std::logic_error);
}

TEST_F(SignalTest, AsymmetryOfABlockBesideTheMirror) {
  // The image of the block at 0 to 20 mm is at -20 to 0 mm, with no particle within a spacing.
  EXPECT_NEAR(value({{"signal", "asymmetry"}, {"axis", "x"}}), 1.0, 1e-12);
}

TEST_F(SignalTest, NoExposureWhereNoNozzleStandsForOneThatMoves) {
  EXPECT_TRUE(std::isnan(value({{"signal", "exposure"}, {"field", "greatest_feed"}})));
  EXPECT_THROW(value({{"signal", "exposure"}, {"field", "feed"}}), std::logic_error);
}

TEST_F(SignalTest, RefusesUnknownNames) {
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
formulation = "shinohara2004"
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
              1e-7);  // positions in a frame are exact, sizes are float
}

TEST_F(PairTest, ProfileErrorOfNoPressureIsOne) {
  EXPECT_NEAR(value({{"signal", "profile_error"}, {"body", "both"}, {"formula", "1000*(0.1-y)"}}),
              1.0, 1e-12);
}

// A hydrostatic block with rows 2 mm high that are alternately above and below the right pressure.
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

// A block that is broken along its diagonal, with given energies.
class TornSimulation : public test::FakeSimulation {
 public:
  using FakeSimulation::FakeSimulation;
  Frame frame() const override {
    Frame frame = FakeSimulation::frame();
    Column damage{"damage", "1", 1, std::vector<float>(frame.id.size(), 0.0f)};
    for (std::size_t row = 0; row < frame.id.size(); ++row) {
      const Point& place = frame.position[row];
      if (frame.category[row] == Category::solid && std::abs(place[0] - place[1]) < 1e-6)
        damage.values[row] = place[0] < 8e-3 ? 0.5f : 0.25f;
    }
    frame.columns.push_back(damage);
    return frame;
  }
  Balance balance() const override {
    Balance balance;
    balance.elastic_strain = elastic;
    balance.hourglass = hourglass;
    return balance;
  }
  double elastic = 0.0, hourglass = 0.0;
};

class BrokenStripTest : public ::testing::Test {
 protected:
  BrokenStripTest()
      : description_(test::fake_case()),
        simulation_(description_),
        beginning_(description_, simulation_) {}

  Signal signal(const std::map<std::string, std::string>& keys) {
    Parameters parameters("test");
    for (const auto& [key, text] : keys) parameters.set(key, text);
    return make_signal(parameters, beginning_);
  }
  double value(const Signal& signal) {
    Moment moment(beginning_, simulation_);
    return signal(moment);
  }

  Case description_;
  TornSimulation simulation_;
  Beginning beginning_;
};

TEST_F(BrokenStripTest, HourglassShareIsOfTheMostElasticEnergySoFar) {
  const Signal share = signal({{"signal", "hourglass_share"}});
  EXPECT_EQ(value(share), 0.0);
  simulation_.elastic = 2.0;
  simulation_.hourglass = 0.5;
  EXPECT_EQ(value(share), 0.25);
  simulation_.elastic = 1.0;
  simulation_.hourglass = 0.2;
  EXPECT_EQ(value(share), 0.1);
}

TEST_F(BrokenStripTest, LargestDamage) {
  EXPECT_EQ(value(signal({{"signal", "largest_damage"}})), 0.5);
}

TEST_F(BrokenStripTest, CrackAlongTheDiagonal) {
  std::map<std::string, std::string> keys{{"signal", "crack"}, {"tip_x", "0 mm"},
                                          {"tip_y", "0 mm"},   {"axis", "y"},
                                          {"damage", "0.3"},   {"field", "angle"}};
  EXPECT_NEAR(value(signal(keys)), 0.25 * std::numbers::pi, 1e-6);
  keys["field"] = "length";
  EXPECT_NEAR(value(signal(keys)), std::hypot(7e-3, 7e-3), 1e-8);
  keys["damage"] = "0.2";
  EXPECT_NEAR(value(signal(keys)), std::hypot(9e-3, 9e-3), 1e-8);
  keys["within"] = "6 mm";
  EXPECT_NEAR(value(signal(keys)), std::hypot(3e-3, 3e-3), 1e-8);
  keys["where"] = "x < 0";
  EXPECT_EQ(value(signal(keys)), 0.0);
  keys["axis"] = "z";
  EXPECT_THROW(value(signal(keys)), std::logic_error);
}

}  // namespace
}  // namespace kerf
