// SPDX-License-Identifier: Apache-2.0
// Signals of the solids of the standard formulation: their energy and their broken bonds.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "model/expression.hpp"
#include "verification/signal.hpp"

namespace kerf {

namespace {

// Returns the share of broken bonds of each particle.
const std::vector<float>& damage_of(const Frame& frame) {
  for (const Column& column : frame.columns)
    if (column.name == "damage") return column.values;
  throw std::logic_error("a signal of broken bonds needs the standard formulation");
}

struct Crack {
  double length = 0.0;  // m
  double angle = 0.0;   // rad
};

// The positions with broken bonds, as offsets from the tip of the notch at which the crack starts.
struct CrackView {
  Point tip{};
  std::size_t axis = 0;  // of the notch
  double least_damage = 0.0;
  double within = 0.0;          // m from the tip
  std::vector<Point> position;  // of the first layout, by id
  std::vector<bool> counts;

  Crack find_crack(const Frame& frame) const {
    const std::vector<float>& damage = damage_of(frame);
    Crack crack;
    double xx = 0.0, xy = 0.0, yy = 0.0, x = 0.0, y = 0.0;
    for (std::size_t row = 0; row < frame.id.size(); ++row) {
      const std::uint32_t id = frame.id[row];
      if (id >= counts.size() || !counts[id] || damage[row] < least_damage) continue;
      const double dx = position[id][0] - tip[0], dy = position[id][1] - tip[1];
      const double distance = std::hypot(dx, dy);
      if (distance > within) continue;
      crack.length = std::max(crack.length, distance);
      xx += dx * dx, xy += dx * dy, yy += dy * dy;
      x += dx, y += dy;
    }
    // Finds the line through the tip with the least sum of squared distances.
    const double turn = 0.5 * std::atan2(2.0 * xy, xx - yy);
    const double along_notch = axis == 0 ? std::cos(turn) : std::sin(turn);
    const double forward = std::cos(turn) * x + std::sin(turn) * y < 0.0 ? -1.0 : 1.0;
    if (crack.length > 0.0) crack.angle = std::acos(std::clamp(forward * along_notch, -1.0, 1.0));
    return crack;
  }
};

}  // namespace

// Energy of the hourglass control over the most elastic energy that there was so far.
Signal hourglass_share_signal(const Parameters&, const Beginning&) {
  return [most = std::make_shared<double>(0.0)](Moment& moment) {
    const Balance& balance = moment.balance();
    *most = std::max(*most, balance.elastic_strain);
    return *most > 0.0 ? balance.hourglass / *most : 0.0;
  };
}

// Largest share of its bonds that a particle has lost.
Signal largest_damage_signal(const Parameters&, const Beginning&) {
  return [](Moment& moment) {
    const std::vector<float>& damage = damage_of(moment.frame());
    return damage.empty() ? 0.0
                          : static_cast<double>(*std::max_element(damage.begin(), damage.end()));
  };
}

// A crack that starts at the tip of a notch along an axis: `length`, the largest distance from the
// tip to a particle that has lost a share `damage` of its bonds or more; `angle` between the axis
// and the line through the tip that fits these particles best, in the plane of x and y. Positions
// are those of the initial layout, where the formula `where` is not 0 and within a distance of the
// tip.
Signal crack_signal(const Parameters& parameters, const Beginning& beginning) {
  const auto view = std::make_shared<CrackView>();
  view->tip = {parameters.number("tip_x", "m"), parameters.number("tip_y", "m"), 0.0};
  const std::string axis = parameters.text("axis");
  if (axis != "x" && axis != "y") parameters.fail("axis is x or y");
  view->axis = axis == "x" ? 0 : 1;
  view->least_damage = parameters.number("damage", "");
  view->within = parameters.number("within", "m", std::numeric_limits<double>::infinity());
  const std::string field = parameters.text("field");
  if (field != "length" && field != "angle") parameters.fail("field is length or angle");
  const Expression where(parameters.text("where", "1"), {"x", "y", "z"});
  const Frame& frame = beginning.frame;
  view->position.resize(frame.id.size());
  view->counts.resize(frame.id.size());
  for (std::size_t row = 0; row < frame.id.size(); ++row) {
    view->position[frame.id[row]] = frame.position[row];
    view->counts[frame.id[row]] =
        frame.category[row] == Category::solid && where(frame.position[row]) != 0.0;
  }
  return [view, is_angle = field == "angle"](Moment& moment) {
    const Crack crack = view->find_crack(moment.frame());
    return is_angle ? crack.angle : crack.length;
  };
}

}  // namespace kerf
