// SPDX-License-Identifier: Apache-2.0
#include "output/result_metrics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "output/result.hpp"

namespace kerf {
namespace {

TEST(ResultMetrics, HaveNamesAndLabelsOfTheirOwn) {
  std::set<std::string> names, labels;
  for (const ResultMetric& metric : result_metrics()) {
    EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
    EXPECT_TRUE(labels.insert(metric.label).second) << metric.label;
  }
}

TEST(ResultMetrics, HaveMeaningsThatAreSentences) {
  for (const ResultMetric& metric : result_metrics()) {
    ASSERT_FALSE(metric.meaning.empty()) << metric.name;
    EXPECT_EQ(metric.meaning.back(), '.') << metric.name;
    EXPECT_EQ(metric.meaning.find("{}"), std::string::npos) << metric.name;
    EXPECT_EQ(metric.label.find("{}"), std::string::npos) << metric.name;
  }
}

// In two dimensions extensive quantities are per metre of depth, and a volume is an area.
TEST(ResultMetrics, HaveTheUnitsOfTheirDimension) {
  struct Expected {
    const char *name, *space, *plane;
  };
  for (const Expected& expected : {Expected{"kerf.removed_volume", "m3", "m2"},
                                   {"kerf.removal_rate", "m3/s", "m2/s"},
                                   {"kerf.splash.mass", "kg", "kg/m"},
                                   {"kerf.leaked_mass", "kg", "kg/m"},
                                   {"fractured_mass", "kg", "kg/m"},
                                   {"kerf.specific_energy", "J/m3", "J/m3"},
                                   {"kerf.depth", "m", "m"},
                                   {"kerf.taper", "rad", "rad"},
                                   {"kerf.margin", "", ""},
                                   {"machine.flow_rate", "m3/s", "m2/s"},
                                   {"machine.power", "W", "W/m"},
                                   {"machine.pressure", "Pa", "Pa"},
                                   {"machine.standoff", "m", "m"},
                                   {"balance.impulse_water", "N s", "N s/m"},
                                   {"front_speed", "m/s", "m/s"},
                                   {"cut_through_time", "s", "s"},
                                   {"cut_through", "", ""},
                                   {"unknown", "", ""}}) {
    EXPECT_EQ(metric_unit(expected.name, 3), expected.space) << expected.name;
    EXPECT_EQ(metric_unit(expected.name, 2), expected.plane) << expected.name;
  }
}

TEST(ResultMetrics, AreNamedByTheirLabels) {
  EXPECT_EQ(metric_label("kerf.depth"), "depth of the kerf");
  EXPECT_EQ(metric_label("opening.depth"), "depth of the opening");
  EXPECT_EQ(metric_label("unknown"), "unknown");
}

RunOutcome outcome_with_kerf() {
  RunOutcome outcome;
  outcome.description.materials.resize(1);
  outcome.description.bodies.resize(2);
  for (Body& body : outcome.description.bodies) body.material = 0;
  outcome.description.bodies[1].name = "plate";
  Kerf& kerf = outcome.kerf.emplace();
  kerf.shape.middle.width = 1.0;
  kerf.opening.middle.width = 2.0;
  kerf.of<Removal>().volume = 3.0;
  kerf.of<DamagedZone>().width = 4.0;
  kerf.of<CutMargin>().value = -0.5;
  kerf.of<Splash>().angle = 0.25;
  kerf.of<Leak>().mass = 5.0;
  kerf.of<FragmentSizes>().count = 6;
  kerf.of<FragmentSizes>().speed = {7.0, 8.0, 9.0};
  KerfLayer layer;
  layer.body = 1;
  layer.shape.top.width = 10.0;
  layer.shape.bottom.width = 11.0;
  layer.volume = 4.0;
  layer.removed_volume = 1.0;
  kerf.layers = {layer};
  return outcome;
}

TEST(ResultMetrics, ReadTheKerf) {
  const auto kerf = result_of(outcome_with_kerf()).at("kerf");
  EXPECT_EQ(kerf.at("middle").at("width"), 1.0);
  EXPECT_EQ(kerf.at("removed_volume"), 3.0);
  EXPECT_EQ(kerf.at("damaged_zone"), 4.0);
  EXPECT_EQ(kerf.at("margin"), -0.5);
  EXPECT_EQ(kerf.at("splash").at("angle"), 0.25);
  EXPECT_EQ(kerf.at("leaked_mass"), 5.0);
  EXPECT_EQ(kerf.at("small_fragments").at("count"), 6);
  EXPECT_EQ(kerf.at("small_fragments").at("speed"), nlohmann::ordered_json({7.0, 8.0, 9.0}));
  const auto& layer = kerf.at("layers").at(0);
  EXPECT_EQ(layer.at("name"), "plate");
  EXPECT_EQ(layer.at("top").at("width"), 10.0);
  EXPECT_EQ(layer.at("bottom").at("width"), 11.0);
  EXPECT_EQ(layer.at("removed_fraction"), 0.25);
  EXPECT_EQ(result_of(outcome_with_kerf()).at("opening").at("middle").at("width"), 2.0);
}

TEST(ResultMetrics, OmitInapplicableMetrics) {
  RunOutcome outcome;
  for (const char* key : {"kerf", "opening", "machine"})
    EXPECT_FALSE(result_of(outcome).contains(key)) << key;
  outcome.description.dimension = 3;
  outcome.description.materials.emplace_back();
  Machine& machine = outcome.description.machine.emplace();
  machine.material = 0;
  machine.cone_angle = 0.5;
  machine.orifice_type = OrificeType::sharp;
  EXPECT_EQ(result_of(outcome).at("machine").at("orifice_type"), "sharp");
  EXPECT_FALSE(result_of(outcome).at("machine").contains("cone_angle"));
  machine.orifice_type = OrificeType::conical;
  EXPECT_EQ(result_of(outcome).at("machine").at("cone_angle"), 0.5);
}

}  // namespace
}  // namespace kerf
