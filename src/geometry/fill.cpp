// SPDX-License-Identifier: Apache-2.0
#include "geometry/fill.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/jitter.hpp"
#include "geometry/lattice_angle.hpp"
#include "geometry/plane_turn.hpp"
#include "geometry/shapes.hpp"
#include "geometry/surface_fit.hpp"

namespace kerf {

namespace {

// Equally spaced nodes along one axis: `centre` + (i - (count - 1) / 2) step, i = first .. last.
struct Axis {
  double centre = 0.0;
  double step = 0.0;
  long count = 0;
  long first = 0;
  long last = -1;

  // `index` need not be an integer.
  double at(double index) const {
    return centre + (index - 0.5 * static_cast<double>(count - 1)) * step;
  }
};

// Round shapes and many meshes are symmetric about the centre of their bounding box.
bool is_centred(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::disc:
    case Shape::Kind::ring:
    case Shape::Kind::sphere:
    case Shape::Kind::mesh:
      return true;
    case Shape::Kind::difference:
      return is_centred(shape.parts.front());
    default:
      return false;
  }
}

constexpr double slack = 1e-6;  // of a spacing

// A length within the tolerance of n steps is n steps.
Axis make_axis(double low, double high, double step, bool centred) {
  const double length = (high - low) / step;
  Axis axis;
  axis.step = step;
  axis.count = static_cast<long>(std::floor(length + 0.5 - slack));
  const bool whole = std::abs(length - static_cast<double>(axis.count)) < slack;
  axis.centre =
      whole || centred ? 0.5 * (low + high) : low + 0.5 * static_cast<double>(axis.count) * step;
  axis.last = axis.count - 1;
  return axis;
}

// The lattice of a body: the axes of its unshifted nodes and the shifts of rows and layers.
struct LatticeFrame {
  Axis x, y, z;
  bool hexagonal = false;
  // Rows and layers are counted from the middle one when the lattice is centred.
  long middle_row = 0;
  long middle_layer = 0;
  Box inner;  // contains all nodes: they are not on a face of the bounding box, unless centred

  bool odd_row(long j) const { return ((j - middle_row) & 1) != 0; }
  bool odd_layer(long k) const { return ((k - middle_layer) & 1) != 0; }
};

// A centred hexagonal lattice has a node at the centre, hence an odd number of rows and layers.
void make_odd(Axis& axis) {
  if (axis.count % 2 == 0) ++axis.count;
  axis.last = axis.count - 1;
}

Box inner_box(const Box& box, double margin) {
  Box inner = box;
  for (std::size_t a = 0; a < 3; ++a) {
    inner.minimum[a] += margin;
    inner.maximum[a] -= margin;
  }
  return inner;
}

// Returns the lattice of a body in its own axes.
LatticeFrame make_frame(const Body& body, int dimension) {
  const Box box = bounding_box(body.shape, dimension);
  const bool centred = is_centred(body.shape);
  const double d = body.spacing;
  LatticeFrame frame;
  frame.hexagonal = body.lattice == Lattice::hexagonal;
  frame.inner = inner_box(box, centred ? -d : slack * d);
  const double row = frame.hexagonal ? d * std::numbers::sqrt3 / 2.0 : d;
  const double layer = frame.hexagonal ? d * std::sqrt(2.0 / 3.0) : d;
  frame.x = make_axis(box.minimum[0], box.maximum[0], d, centred);
  frame.y = make_axis(box.minimum[1], box.maximum[1], row, centred);
  frame.z = dimension == 3 ? make_axis(box.minimum[2], box.maximum[2], layer, centred)
                           : Axis{0.0, d, 1, 0, 0};
  if (frame.hexagonal && centred) {
    make_odd(frame.x);
    make_odd(frame.y);
    if (dimension == 3) make_odd(frame.z);
    frame.middle_row = (frame.y.count - 1) / 2;
    frame.middle_layer = (frame.z.count - 1) / 2;
  }
  return frame;
}

// The indices of an axis whose nodes, shifted by at most `reach`, can lie in [low, high].
void narrow(Axis& axis, double low, double high, double reach) {
  const double from = (low - reach - axis.at(0.0)) / axis.step;
  const double to = (high + reach - axis.at(0.0)) / axis.step;
  const auto index = [](double value) {
    constexpr double limit = 1e15;
    return static_cast<long>(std::clamp(value, -limit, limit));
  };
  axis.first = std::max(axis.first, index(std::floor(from)) - 1);
  axis.last = std::min(axis.last, index(std::ceil(to)) + 1);
}

// Shifted nodes may be added at either end.
void widen(Axis& axis, double shift) {
  const long more = static_cast<long>(std::ceil(std::abs(shift) / axis.step));
  axis.first -= more;
  axis.last += more;
}

// Shift of the nodes of row j in layer k along x and y, in steps of the axes. A shift of a whole
// spacing is none.
std::array<double, 2> row_shift(const LatticeFrame& frame, long j, long k) {
  if (!frame.hexagonal) return {0.0, 0.0};
  const bool odd_layer = frame.odd_layer(k);
  return {frame.odd_row(j) != odd_layer ? 0.5 : 0.0, odd_layer ? 1.0 / 3.0 : 0.0};
}

bool within(const Box& box, const Point& point, int dimension) {
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    if (point[a] < box.minimum[a] || point[a] > box.maximum[a]) return false;
  return true;
}

// Returns false if the visit has ended.
bool visit_row(const Body& body, int dimension, const LatticeVisit& request,
               const LatticeFrame& frame, std::array<long, 2> row) {
  const auto [j, k] = row;
  const auto [shift_x, shift_y] = row_shift(frame, j, k);
  const double index = static_cast<double>(j) + shift_y;
  Point point{0.0, frame.y.at(index) + body.offset[1],
              dimension == 3 ? frame.z.at(static_cast<double>(k)) + body.offset[2] : 0.0};
  for (long i = frame.x.first; i <= frame.x.last; i += request.stride) {
    point[0] = frame.x.at(static_cast<double>(i) + shift_x) + body.offset[0];
    if (!within(request.window, point, dimension) || !within(frame.inner, point, dimension))
      continue;
    if (contains(body.shape, point, dimension) && !request.visit(point)) return false;
  }
  return true;
}

// Returns the lattice with the ranges of indices whose nodes can lie in the window.
LatticeFrame frame_within(const Body& body, int dimension, const Box& window) {
  LatticeFrame frame = make_frame(body, dimension);
  const std::array<Axis*, 3> axes{&frame.x, &frame.y, &frame.z};
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
    widen(*axes[a], body.offset[a]);
    if (frame.hexagonal) widen(*axes[a], axes[a]->step);
    narrow(*axes[a], window.minimum[a], window.maximum[a], body.spacing + std::abs(body.offset[a]));
  }
  return frame;
}

double nodes_along(const Axis& axis) {
  return std::max(0.0, static_cast<double>(axis.last) - static_cast<double>(axis.first) + 1.0);
}

// Returns node `number` of a sequence that fills a range evenly: multiples of the powers of the
// root g of g^(D + 1) = g + 1 (1.3247 in 2D, 1.2207 in 3D), modulo 1.
long spread_index(const Axis& axis, double number, std::size_t direction, int dimension) {
  const double root = dimension == 2 ? 1.32471795724474602596 : 1.22074408460575947536;
  const double place = number * std::pow(root, -1.0 - static_cast<double>(direction)) + 0.5;
  const double share = place - std::floor(place);
  return axis.first +
         std::min(static_cast<long>(share * nodes_along(axis)), axis.last - axis.first);
}

void visit_along_axes(const Body& body, int dimension, const LatticeVisit& request) {
  const LatticeFrame frame = frame_within(body, dimension, request.window);
  for (long k = frame.z.first; k <= frame.z.last; k += request.stride)
    for (long j = frame.y.first; j <= frame.y.last; j += request.stride)
      if (!visit_row(body, dimension, request, frame, {j, k})) return;
}

double sample_along_axes(const Body& body, int dimension, const LatticeVisit& request,
                         double most) {
  LatticeFrame frame = frame_within(body, dimension, request.window);
  const double nodes = nodes_along(frame.x) * nodes_along(frame.y) * nodes_along(frame.z);
  if (nodes <= most) {
    visit_along_axes(body, dimension, request);
    return 1.0;
  }
  LatticeVisit one = request;
  one.stride = 1;
  const LatticeFrame whole = frame;
  bool goes_on = true;
  one.visit = [&](const Point& point) { return goes_on = request.visit(point); };
  for (double n = 0.0; n < most && goes_on; n += 1.0) {
    frame.x.first = frame.x.last = spread_index(whole.x, n, 0, dimension);
    const long k = dimension == 3 ? spread_index(whole.z, n, 2, dimension) : 0;
    visit_row(body, dimension, one, frame, {spread_index(whole.y, n, 1, dimension), k});
  }
  return nodes / most;
}

// Returns what visit(body, request) returns with both in the axes of the body's lattice.
template <class Visit>
auto in_lattice_axes(const Body& body, int dimension, const LatticeVisit& request,
                     const Visit& visit) {
  if (body.lattice_angle == 0.0) return visit(body, request);
  const PlaneTurn turn(body.lattice_angle);
  LatticeVisit straight = request;
  straight.window = box_around(request.window, PlaneTurn(-body.lattice_angle));
  straight.visit = [&](const Point& node) {
    const Point point = turn(node);
    return !within(request.window, point, dimension) || request.visit(point);
  };
  return visit(along_lattice(body), straight);
}

}  // namespace

void visit_particles(const Body& body, int dimension, const LatticeVisit& request) {
  in_lattice_axes(body, dimension, request,
                  [&](const Body& straight, const LatticeVisit& straight_request) {
                    visit_along_axes(straight, dimension, straight_request);
                  });
}

double visit_sample(const Body& body, int dimension, const LatticeVisit& request, double most) {
  return in_lattice_axes(body, dimension, request,
                         [&](const Body& straight, const LatticeVisit& straight_request) {
                           return sample_along_axes(straight, dimension, straight_request, most);
                         });
}

std::vector<Point> fill(const Body& body, int dimension) {
  const Body straight = along_lattice(body);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Point> particles;
  LatticeVisit request;
  request.window = {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  request.visit = [&](const Point& point) {
    particles.push_back(point);
    return true;
  };
  visit_along_axes(straight, dimension, request);
  fit_to_surface(straight, dimension, particles);
  jitter(straight, dimension, particles);
  if (body.lattice_angle != 0.0) {
    const PlaneTurn turn(body.lattice_angle);
    for (Point& particle : particles) particle = turn(particle);
  }
  return particles;
}

double particle_volume(const Body& body, int dimension) {
  const double d = body.spacing;
  if (body.lattice == Lattice::square) return dimension == 2 ? d * d : d * d * d;
  return dimension == 2 ? d * d * std::numbers::sqrt3 / 2.0 : d * d * d / std::numbers::sqrt2;
}

double lattice_nodes(const Body& body, int dimension) {
  const Box box = bounding_box(along_lattice(body).shape, dimension);
  double volume = 1.0;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    volume *= (box.maximum[a] - box.minimum[a]) + body.spacing;
  return volume / particle_volume(body, dimension);
}

Box lattice_box(const Body& body, int dimension) {
  const LatticeFrame frame = make_frame(along_lattice(body), dimension);
  const std::array<const Axis*, 3> axes{&frame.x, &frame.y, &frame.z};
  Box box;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
    box.minimum[a] = axes[a]->at(-0.5);
    box.maximum[a] = axes[a]->at(static_cast<double>(axes[a]->count) - 0.5);
  }
  return box;
}

}  // namespace kerf
