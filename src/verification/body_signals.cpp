// SPDX-License-Identifier: Apache-2.0
// These signals are means over the particles of one body.
#include <cmath>
#include <memory>
#include <vector>

#include "model/expression.hpp"
#include "verification/signal.hpp"

namespace kerf {

namespace {

constexpr std::size_t everything = static_cast<std::size_t>(-1);

std::size_t body_index(const Parameters& parameters, const Beginning& beginning,
                       const std::string& key = "body") {
  return parameters.has(key) ? named_body(parameters, beginning, key) : everything;
}

// The initial position and weight of each particle by its id; 0 for those that do not count.
struct Weights {
  std::vector<Point> position;
  std::vector<double> weight;  // mass times the formula
  double total = 0.0;          // of their sizes

  bool has(std::uint32_t id) const { return id < weight.size() && weight[id] != 0.0; }
};

std::shared_ptr<const Weights> make_weights(const Parameters& parameters,
                                            const Beginning& beginning) {
  const Expression formula(parameters.text("weight", "1"), {"x", "y", "z"});
  const std::size_t body = body_index(parameters, beginning);
  const Frame& frame = beginning.frame;
  auto result = std::make_shared<Weights>();
  result->position.resize(frame.id.size());
  result->weight.resize(frame.id.size(), 0.0);
  for (std::size_t row = 0; row < frame.id.size(); ++row) {
    const std::uint32_t id = frame.id[row];
    result->position[id] = frame.position[row];
    if (frame.category[row] == Category::rigid) continue;
    if (body != everything && frame.source[row] != body) continue;
    result->weight[id] = static_cast<double>(frame.mass[row]) * formula(frame.position[row]);
    result->total += std::abs(result->weight[id]);
  }
  if (result->total == 0.0) parameters.fail("no particle has any weight");
  return result;
}

}  // namespace

// sum w u / sum |w|, u the displacement or velocity along an axis, w = mass x formula. With the
// shape of a mode as the formula it is the amplitude of that mode. u is taken relative to the mean
// of the body `less`, if one is named.
Signal body_mean_signal(const Parameters& parameters, const Beginning& beginning) {
  const auto weights = make_weights(parameters, beginning);
  const std::size_t axis = named_axis(parameters);
  const std::size_t less = body_index(parameters, beginning, "less");
  const std::string field = parameters.text("field");
  if (field != "velocity" && field != "displacement")
    parameters.fail("field is velocity or displacement");
  const bool moved = field == "displacement";
  return [weights, axis, less, moved](Moment& moment) {
    const Frame& frame = moment.frame();
    double sum = 0.0, weight = 0.0, ground = 0.0, ground_mass = 0.0;
    for (std::size_t row = 0; row < frame.id.size(); ++row) {
      const std::uint32_t id = frame.id[row];
      const bool counts = weights->has(id), is_ground = frame.source[row] == less;
      if (!counts && !is_ground) continue;
      const double value = moved ? frame.position[row][axis] - weights->position[id][axis]
                                 : frame.velocity[row][axis];
      if (counts) {
        sum += weights->weight[id] * value;
        weight += weights->weight[id];
      }
      if (is_ground) {
        ground += frame.mass[row] * value;
        ground_mass += frame.mass[row];
      }
    }
    return (ground_mass > 0.0 ? sum - weight * ground / ground_mass : sum) / weights->total;
  };
}

// Centroid of the kinetic energy along an axis: sum w v^2 x / sum w v^2, with x the initial
// position.
Signal kinetic_centroid_signal(const Parameters& parameters, const Beginning& beginning) {
  const auto weights = make_weights(parameters, beginning);
  const std::size_t axis = named_axis(parameters);
  return [weights, axis](Moment& moment) {
    const Frame& frame = moment.frame();
    double sum = 0.0, total = 0.0;
    for (std::size_t row = 0; row < frame.id.size(); ++row) {
      const std::uint32_t id = frame.id[row];
      if (!weights->has(id)) continue;
      const double v = frame.velocity[row][axis];
      const double energy = weights->weight[id] * v * v;
      sum += energy * weights->position[id][axis];
      total += energy;
    }
    return total > 0.0 ? sum / total : 0.0;
  };
}

// Relative L2 distance of a body's pressure, averaged over layers, from a formula of x, y, z:
// sqrt(sum (p - formula)^2 / sum formula^2), each layer at its mean position. A layer is "layer"
// spacings high: a layer of two rows averages out a ripple from row to row, to which the pressure
// force does not respond.
Signal profile_error_signal(const Parameters& parameters, const Beginning& beginning) {
  const auto formula = std::make_shared<const Expression>(parameters.text("formula"),
                                                          std::vector<std::string>{"x", "y", "z"});
  const auto weights = make_weights(parameters, beginning);
  const double height = parameters.number("layer", "", 1.0);
  return [weights, formula, height](Moment& moment) {
    struct Layer {
      double count = 0.0, pressure = 0.0;
      Point position{};
    };
    const Frame& frame = moment.frame();
    std::map<long, Layer> layers;
    for (std::size_t row = 0; row < frame.id.size(); ++row) {
      if (!weights->has(frame.id[row])) continue;
      const Point& position = frame.position[row];
      Layer& layer = layers[std::lround(std::floor(position[1] / (height * frame.spacing[row])))];
      layer.count += 1.0;
      layer.pressure += frame.pressure[row];
      for (std::size_t a = 0; a < 3; ++a) layer.position[a] += position[a];
    }
    double error = 0.0, scale = 0.0;
    for (auto& [number, layer] : layers) {
      for (double& x : layer.position) x /= layer.count;
      const double expected = (*formula)(layer.position);
      const double gap = layer.pressure / layer.count - expected;
      error += gap * gap;
      scale += expected * expected;
    }
    return std::sqrt(error / scale);
  };
}

}  // namespace kerf
