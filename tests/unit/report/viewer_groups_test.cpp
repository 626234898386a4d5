// SPDX-License-Identifier: Apache-2.0
// Particles are coloured by body, material and piece, with the names of the case.
#include "report/viewer_groups.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "model/case.hpp"
#include "report/viewer_fields.hpp"
#include "support/frames.hpp"

namespace kerf {
namespace {

using testing::ElementsAre;

// A skin on a bone of another material, on a rigid table, under a jet.
Case layered() {
  Case description;
  description.materials.resize(3);
  description.materials[0].name = "water";
  description.materials[1].name = "gelatine";
  description.materials[2].name = "cortical";
  description.bodies.resize(3);
  description.bodies[0].name = "skin";
  description.bodies[0].material = 1;
  description.bodies[1].name = "bone";
  description.bodies[1].material = 2;
  description.bodies[2].name = "table";
  description.bodies[2].role = Role::rigid;
  description.jets.resize(1);
  description.jets[0].name = "jet";
  description.jets[0].material = 0;
  return description;
}

// One particle of each source, in the order of sources; the bone has two.
Frame five_particles() {
  Frame frame;
  const Category categories[] = {Category::solid, Category::solid, Category::fractured,
                                 Category::rigid, Category::water};
  for (const Category category : categories)
    test::add_particle(frame, {0.0, 0.0, 0.0}, category, 1e-3);
  frame.source = {0, 1, 1, 2, 3};
  return frame;
}

const ViewerGroups& groups_of(const std::vector<ViewerGroups>& all, const std::string& key) {
  for (const ViewerGroups& groups : all)
    if (groups.key == key) return groups;
  throw std::runtime_error("there are no groups " + key);
}

TEST(ViewerGroups, NameEveryBodyAndJet) {
  const auto groups = viewer_groups(five_particles(), layered());
  EXPECT_THAT(groups_of(groups, "body").names, ElementsAre("skin", "bone", "table", "jet"));
  EXPECT_THAT(*group_values("body", five_particles(), layered()), ElementsAre(0, 1, 1, 2, 3));
}

TEST(ViewerGroups, TellTwoMaterialsApart) {
  const auto groups = viewer_groups(five_particles(), layered());
  EXPECT_THAT(groups_of(groups, "material").names,
              ElementsAre("water", "gelatine", "cortical", "rigid"));
  EXPECT_THAT(*group_values("material", five_particles(), layered()), ElementsAre(1, 2, 2, 3, 0));
}

TEST(ViewerGroups, NumberPiecesFromTheHeaviest) {
  Frame frame = five_particles();
  frame.mass = {1.0f, 5.0f, 0.5f, 9.0f, 9.0f};
  frame.piece = {10, 20, 30, 40, 50};
  const auto names = groups_of(viewer_groups(frame, layered()), "piece").names;
  const auto values = *group_values("piece", frame, layered());
  EXPECT_THAT(std::vector<float>(values.begin(), values.begin() + 3), ElementsAre(1, 0, 2));
  EXPECT_EQ(names.at(static_cast<std::size_t>(values[1])), "largest piece");
  EXPECT_EQ(names.at(static_cast<std::size_t>(values[3])), "no solid");
  EXPECT_EQ(values[3], values[4]);
}

TEST(ViewerGroups, ManySmallPiecesAreOneGroup) {
  Frame frame;
  for (int n = 0; n < 20; ++n) test::add_particle(frame, {}, Category::solid, 1e-3);
  for (std::size_t n = 0; n < 20; ++n) {
    frame.piece.push_back(frame.id[n]);
    frame.source[n] = 0;
  }
  const auto names = groups_of(viewer_groups(frame, layered()), "piece").names;
  const auto values = *group_values("piece", frame, layered());
  EXPECT_EQ(names.at(static_cast<std::size_t>(*std::max_element(values.begin(), values.end()))),
            "smaller pieces");
}

TEST(ViewerGroups, FieldsBeginWithThemAndHaveTheLabelsOfReaders) {
  Frame frame = five_particles();
  frame.columns.push_back({"damage", "1", 1, std::vector<float>(5, 0.0f), "damage"});
  std::vector<std::string> labels;
  for (const ViewerField& field : viewer_fields(frame, layered())) labels.push_back(field.label);
  EXPECT_THAT(labels,
              ElementsAre("body", "material", "speed", "pressure", "equivalent stress (von Mises)",
                          "crack (share of broken bonds)"));
}

TEST(ViewerGroups, AQuantityIsNoGroup) {
  EXPECT_FALSE(group_values("speed", five_particles(), layered()).has_value());
}

}  // namespace
}  // namespace kerf
