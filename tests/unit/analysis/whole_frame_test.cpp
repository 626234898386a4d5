// SPDX-License-Identifier: Apache-2.0
// Half and quarter of a workpiece beside symmetry planes have the metrics of the whole one.
#include <ostream>

#include "analysis/whole_frame.hpp"

#include <gtest/gtest.h>

#include "analysis/kerf.hpp"
#include "bonded_layout.hpp"

namespace kerf {
namespace {

using namespace layout;

// All metrics of a frame by name; those of lists of numbers by their first entries.
class Metrics {
 public:
  Metrics(const Case& description, const Frame& initial, const Frame& frame) {
    CutMonitor monitor(description, initial);
    Frame start = initial;
    monitor.observe(start);
    const CutState state = monitor.observe(frame);
    const CutSummary summary = monitor.summary();
    add("", CutState::metrics(), state);
    add("", CutSummary::metrics(), summary);
    KerfConditions conditions = kerf_conditions(description, summary);
    conditions.contact_time = 1e-3;
    const Kerf kerf = measure_kerf(monitor.workpiece(), frame, conditions);
    add("kerf.", KerfShape::metrics(), kerf.shape);
    add("opening.", KerfShape::metrics(), kerf.opening);
    std::apply([&](const auto&... each) { (add("kerf.", each.metrics(), each), ...); },
               kerf.measurements);
    for (const KerfLayer& layer : kerf.layers) {
      values["layer"].push_back(layer.volume);
      values["layer"].push_back(layer.removed_volume);
      values["layer"].push_back(layer.margin);
      values["layer"].push_back(layer.verdict.cut.through ? 1.0 : 0.0);
    }
  }
  std::map<std::string, std::vector<double>> values;

 private:
  template <class Record>
  void add(const std::string& prefix, const MetricList<Record>& metrics, const Record& record) {
    for (const Metric<Record>& metric : metrics) {
      const MetricValue value = metric.value(record);
      if (const auto* numbers = std::get_if<std::vector<double>>(&value))
        values[prefix + metric.name] = *numbers;
      else
        values[prefix + metric.name] = {number_of(value)};
    }
  }
};

// A plate of two bodies with a conical hole of round water, debris that flies off, a damaged wall
// and small fragments; everything is symmetric to x = 0 and z = 0.
struct Plate {
  int dimension = 3;
  double depth = 30.0 * mm;  // of the hole

  Case description(bool half, bool quarter) const {
    Case made = make_case(dimension);
    made.bodies.push_back(made.bodies[0]);
    made.bodies[1].name = "upper";
    made.bodies[1].joined_to = "block";
    constexpr double far = 1.0;
    made.domain = {{half ? 0.0 : -far, -far, quarter ? 0.0 : -far}, {far, far, far}};
    made.symmetry.minimum = {half, false, quarter};
    return made;
  }
  Frame initial() const {
    Frame frame = make_block(dimension);
    for (std::size_t k = 0; k < frame.id.size(); ++k)
      frame.source[k] = frame.position[k][1] > -16.0 * mm ? 1 : 0;
    bond(Frame(frame), frame);
    frame.columns.push_back({"damage", "1", 1, std::vector<float>(frame.id.size(), 0.0f), {}});
    return frame;
  }
  Frame cut() const {
    const Frame before = initial();
    Frame frame = before;
    frame.time = 4e-3;
    const auto radius = [&](double y) { return 9.0 * mm + 0.1 * y; };
    for (std::size_t k = 0; k < frame.id.size(); ++k) {
      Position& x = frame.position[k];
      const double r = std::hypot(x[0], x[2]);
      if (r < radius(x[1]) + 5.0 * mm) frame.columns[0].values[k] = 0.5f;
      if (r > radius(x[1]) || x[1] < -depth) continue;
      // Some of the removed solid is left as single fragments.
      if (r > radius(x[1]) - 2.0 * mm && x[1] < -6.0 * mm && x[1] > -9.0 * mm) {
        frame.velocity[k] = {100.0 * x[0], 3.0, 100.0 * x[2]};
        x[1] += 30.0 * mm;
        continue;
      }
      frame.category[k] = Category::fractured;
    }
    bond(before, frame, [&](const Position& x, const Position& y) {
      const auto loose = [&](const Position& p) {
        return std::hypot(p[0], p[2]) < radius(p[1]) && p[1] > -depth;
      };
      return loose(x) || loose(y);
    });
    const std::size_t solids = frame.id.size();
    const Case made = description(false, false);
    add_water(frame, made, depth - 4.0 * mm, jet_width);
    for (std::size_t k = solids; k < frame.id.size(); ++k) {
      Position& x = frame.position[k];
      frame.velocity[k] = {0.0, -5.0, 0.0};
      frame.piece.push_back(frame.id[k]);
      frame.body_piece.push_back(frame.id[k]);
      frame.columns[0].values.push_back(0.0f);
      if (x[1] < 12.0 * mm) continue;
      // Its top splashes outwards.
      const double r = std::hypot(x[0], x[2]);
      frame.velocity[k] = {2.0 * x[0] / r, 1.0 + 200.0 * r, 2.0 * x[2] / r};
      x = {x[0] + 12.0 * mm * x[0] / r, x[1], x[2] + 12.0 * mm * x[2] / r};
    }
    return frame;
  }
  // The particles beyond the planes are left out; pieces are what the planes leave of them.
  static Frame part_of(const Frame& whole, bool quarter) {
    std::vector<std::size_t> rows;
    for (std::size_t k = 0; k < whole.id.size(); ++k)
      if (whole.position[k][0] > 0.0 && (!quarter || whole.position[k][2] > 0.0)) rows.push_back(k);
    Frame part = select(whole, rows, [](std::size_t) { return true; });
    Column damage{"damage", "1", 1, {}, {}};
    for (const std::size_t k : rows) {
      part.piece.push_back(whole.piece[k]);
      part.body_piece.push_back(whole.body_piece[k]);
      damage.values.push_back(whole.columns[0].values[k]);
    }
    part.joined_planes = joined(whole, part, rows);
    part.columns.push_back(damage);
    return part;
  }
  // The planes across which each piece of the part goes on.
  static std::vector<std::uint8_t> joined(const Frame& whole, const Frame& part,
                                          const std::vector<std::size_t>& rows) {
    std::map<std::uint32_t, std::uint8_t> planes;
    for (std::size_t k = 0; k < whole.id.size(); ++k) {
      if (whole.position[k][0] < 0.0) planes[whole.body_piece[k]] |= 1;
      if (whole.position[k][2] < 0.0) planes[whole.body_piece[k]] |= 16;
    }
    std::vector<std::uint8_t> result;
    for (std::size_t n = 0; n < rows.size(); ++n) result.push_back(planes[part.body_piece[n]]);
    return result;
  }

  friend std::ostream& operator<<(std::ostream& out, const Plate& of) {
    return out << of.dimension << "D, a hole of " << of.depth << " m";
  }
};

void expect_equal(const Metrics& part, const Metrics& whole, const std::string& what) {
  ASSERT_EQ(part.values.size(), whole.values.size());
  for (const auto& [name, values] : whole.values) {
    const auto& other = part.values.at(name);
    ASSERT_EQ(other.size(), values.size()) << name;
    for (std::size_t n = 0; n < values.size(); ++n) {
      if (std::isnan(values[n])) {
        EXPECT_TRUE(std::isnan(other[n])) << what << " " << name;
        continue;
      }
      // The sums have another order; faces are found in a field of single precision, to some 1e-3
      // of a spacing where it is flat.
      EXPECT_NEAR(other[n], values[n], 3e-4 * std::abs(values[n]) + 1e-9) << what << " " << name;
    }
  }
}

class WholePlate : public testing::TestWithParam<Plate> {};

TEST_P(WholePlate, HasTheMetricsOfItsHalfAndQuarter) {
  const Plate plate = GetParam();
  const Frame initial = plate.initial(), cut = plate.cut();
  const Metrics whole(plate.description(false, false), initial, cut);
  EXPECT_GT(whole.values.at("kerf.removed_volume")[0], 0.0);
  EXPECT_GT(whole.values.at("front_depth")[0], 20.0 * mm);
  EXPECT_GT(whole.values.at("kerf.splash.mass")[0], 0.0);
  EXPECT_GT(whole.values.at("kerf.small_fragments.count")[0], 1.0);
  EXPECT_EQ(whole.values.at("cut_through")[0], plate.depth > thickness ? 1.0 : 0.0);
  for (const bool quarter : {false, true}) {
    if (quarter && plate.dimension == 2) continue;
    const Metrics part(plate.description(true, quarter), Plate::part_of(initial, quarter),
                       Plate::part_of(cut, quarter));
    expect_equal(part, whole, quarter ? "quarter" : "half");
  }
}

INSTANTIATE_TEST_SUITE_P(TwoAndThree, WholePlate,
                         testing::Values(Plate{2, 30.0 * mm}, Plate{2, 60.0 * mm},
                                         Plate{3, 30.0 * mm}, Plate{3, 60.0 * mm}));

// A jet beside the plane has an image, and the whole two cuts.
TEST(WholeFrame, AJetBesideThePlaneHasAnImage) {
  Case description = make_case(2);
  description.domain = {{-25.0 * mm, -1.0, 0.0}, {1.0, 1.0, 0.0}};
  description.symmetry.minimum[0] = true;
  SymmetryImages images = symmetry_images(description);
  EXPECT_EQ(images.count(), 2u);
  EXPECT_EQ(images.jets, 2);
  description.domain.minimum[0] = 0.0;
  images = symmetry_images(description);
  EXPECT_EQ(images.jets, 1);
  // Of two opposite planes the one in the axis counts.
  description.domain.maximum[0] = 50.0 * mm;
  description.symmetry.maximum[0] = true;
  images = symmetry_images(description);
  ASSERT_EQ(images.planes.size(), 1u);
  EXPECT_EQ(images.planes[0].position, 0.0);
  description.jets[0].position[0] = 20.0 * mm;
  EXPECT_EQ(symmetry_images(description).count(), 1u);
}

// Pieces that bonds join across the plane are one with their images, others are two.
TEST(WholeFrame, NumbersThePiecesOfTheWhole) {
  Frame part;
  part.dimension = 2;
  add(part, solid(), {1.0 * mm, 0.0, 0.0});
  add(part, solid(), {9.0 * mm, 0.0, 0.0});
  part.piece = part.body_piece = part.id;
  part.joined_planes = {1, 0};
  SymmetryImages images;
  images.planes = {{0, 0.0, 1}};
  const Frame whole = whole_frame(part, images);
  ASSERT_EQ(whole.id.size(), 4u);
  EXPECT_EQ(whole.piece[0], whole.piece[2]);
  EXPECT_NE(whole.piece[1], whole.piece[3]);
  EXPECT_NE(whole.piece[0], whole.piece[1]);
  EXPECT_EQ(whole.position[3], (Position{-9.0 * mm, 0.0, 0.0}));
}

// Two jets are as many beside a plane through the middle between them: both cut, and both pay.
TEST(WholeFrame, AJetBesideAPlaneIsTwo) {
  Case whole = make_case(3);
  whole.domain = {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
  whole.jets[0].stop = std::numeric_limits<double>::infinity();
  whole.jets.push_back(whole.jets[0]);
  whole.jets[0].position[0] = 12.0 * mm;
  whole.jets[1].position[0] = -12.0 * mm;
  Case half = whole;
  half.jets.pop_back();
  half.domain.minimum[0] = 0.0;
  half.symmetry.minimum[0] = true;
  EXPECT_EQ(jets_of_whole(whole), 2u);
  EXPECT_EQ(jets_of_whole(half), 2u);
  Frame block = make_block(3), cut = block;
  change(cut, Category::fractured, [](const Position& x) {
    return std::hypot(std::abs(x[0]) - 12.0 * mm, x[2]) < 5.0 * mm && x[1] > -20.0 * mm;
  });
  // Water of each jet that flies off, above the other jet too, where it is none.
  for (const double side : {1.0, -1.0})
    for (const double place : {2.0, 12.0, 18.5, 25.0}) {
      const std::uint16_t source = side > 0.0 ? 1 : 2;
      add(cut, {Category::water, source, water_spacing, 1000.0},
          {side * place * mm, 5.0 * mm, 0.5 * mm});
      cut.velocity.back() = {side, 2.0, 0.0};
    }
  const auto measured = [](const Case& description, const Frame& initial, Frame frame) {
    CutMonitor monitor(description, initial);
    frame.time = 4e-3;
    monitor.observe(frame);
    CutSummary summary = monitor.summary();
    summary.contact_time = 1e-3;
    summary.last.time = 4e-3;
    return measure_kerf(monitor.workpiece(), frame, kerf_conditions(description, summary));
  };
  const auto is_beyond = [](const Position& x) { return x[0] < 0.0; };
  const Kerf a = measured(whole, block, cut);
  const Kerf b = measured(half, without(block, is_beyond), without(cut, is_beyond));
  EXPECT_NEAR(a.of<Removal>().volume, b.of<Removal>().volume, 1e-9 * a.of<Removal>().volume);
  const double energy = a.of<Removal>().specific_energy * a.of<Removal>().volume;
  EXPECT_NEAR(energy, 2.0 * 0.5 * 1000.0 * M_PI / 4.0 * jet_width * jet_width * 125.0 * 3e-3,
              1e-6 * energy);
  EXPECT_NEAR(b.of<Removal>().specific_energy, a.of<Removal>().specific_energy,
              1e-6 * a.of<Removal>().specific_energy);
  EXPECT_NEAR(a.of<Splash>().mass, 6e-6, 1e-9) << "six drops of 1 mg are beside the jets";
  EXPECT_NEAR(b.of<Splash>().mass, a.of<Splash>().mass, 1e-12);
  EXPECT_NEAR(b.of<Splash>().angle, a.of<Splash>().angle, 1e-9);
}

}  // namespace
}  // namespace kerf
