// SPDX-License-Identifier: Apache-2.0
// Signals of water and other matter at the start of a run.
#include <limits>
#include <stdexcept>

#include "support/signal_fixture.hpp"

namespace kerf {
namespace {

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

class WetBlockTest : public test::SignalFixture {
 protected:
  WetBlockTest() : SignalFixture(wet_block) {}
};

TEST_F(WetBlockTest, WaterLiesHalfASpacingOfItsOwnAboveTheTop) {
  EXPECT_NEAR(value({{"signal", "deepest_water"}, {"body", "block"}}), -0.5 / 2.0, 1e-6);
}

TEST_F(WetBlockTest, TheTipOfANewJetLiesBetweenItAndTheLiquid) {
  // The uppermost row of the layer is half a spacing below the point aimed at, the water of the jet
  // within the nozzle, a millimetre and more above it.
  const double tip = value({{"signal", "jet_tip"}, {"body", "layer"}});
  EXPECT_GE(tip, 0.5 * (-1.0e-3 + 0.5e-3) - 1e-9);
  EXPECT_LE(tip, 0.5e-3);
}

TEST_F(WetBlockTest, ARegionContainsItsRows) {
  // Two of the four rows of the layer, of 20 particles.
  EXPECT_NEAR(value({{"signal", "region_volume"}, {"body", "layer"}, {"within", "y < 2e-3"}}),
              20e-3 * 2e-3, 1e-8);
  EXPECT_NEAR(value({{"signal", "region_volume"},
                     {"body", "layer"},
                     {"within", "abs(x) < 5e-3"},
                     {"over", "4e-3"}}),
              10e-3, 1e-7);
  EXPECT_EQ(value({{"signal", "region_velocity"},
                   {"body", "layer"},
                   {"within", "y < 2e-3"},
                   {"axis", "y"}}),
            0.0);
  EXPECT_THROW(value({{"signal", "region_velocity"},
                      {"body", "layer"},
                      {"within", "y < 2e-3"},
                      {"axis", "down"}}),
               std::logic_error);
}

TEST_F(WetBlockTest, ARegionContainsTheWaterOfAJet) {
  const auto velocity = [&](const char* jet) {
    return value({{"signal", "region_velocity"}, {"jet", jet}, {"within", "1"}, {"axis", "y"}});
  };
  EXPECT_FLOAT_EQ(static_cast<float>(velocity("jet")), -5.0f);
  EXPECT_THROW(velocity("stream"), std::logic_error);
}

// The right edge of the layer is at 10 mm, its top at 4 mm, that of the two lower rows at 2 mm; the
// particles are half a spacing further in.
TEST_F(WetBlockTest, ARegionReachesToItsEdge) {
  const auto reach = [&](const char* within, const char* axis) {
    return value({{"signal", "reach"}, {"body", "layer"}, {"within", within}, {"axis", axis}});
  };
  EXPECT_NEAR(reach("1", "x"), 10e-3, 1e-8);
  EXPECT_NEAR(reach("1", "y"), 4e-3, 1e-8);
  EXPECT_NEAR(reach("y < 2e-3", "y"), 2e-3, 1e-8);
  EXPECT_EQ(reach("x > 1", "x"), -std::numeric_limits<double>::infinity());
}

TEST_F(WetBlockTest, NoElasticEnergyNoHourglassShare) {
  EXPECT_EQ(value({{"signal", "hourglass_share"}}), 0.0);
}

TEST_F(WetBlockTest, RefusesAnUnknownBody) {
  EXPECT_THROW(value({{"signal", "deepest_water"}, {"body", "ghost"}}), std::logic_error);
  EXPECT_THROW(value({{"signal", "jet_tip"}, {"body", "ghost"}}), std::logic_error);
}

}  // namespace
}  // namespace kerf
