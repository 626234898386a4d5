// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/cell_grid.hpp"
#include "geometry/closed_surface.hpp"
#include "geometry/fill.hpp"
#include "geometry/kernel_gradients.hpp"
#include "geometry/lattice_angle.hpp"
#include "geometry/nearest_face.hpp"
#include "geometry/nearest_point.hpp"
#include "geometry/point_vectors.hpp"
#include "geometry/shapes.hpp"
#include "geometry/surface_elements.hpp"
#include "parallel/threads.hpp"

namespace kerf {

namespace {

constexpr int relaxing_steps = 30;
constexpr int free_steps = 20;           // then the outermost layer keeps its depth
constexpr double zone = 5.0;             // spacings from a slanted face within which particles move
constexpr double longest_step = 0.1;     // spacings
constexpr double layer_depth = 0.5;      // spacings, of the outermost layer
constexpr double lowest_of_layer = 0.8;  // spacings, of particles that are taken into it
constexpr double deep = 1.8;  // spacings from the nearest element: no face is nearer than a spacing
constexpr double alignment = 1e-6;         // of a normal with an axis
constexpr double least_plane_share = 0.3;  // of spacing^(D-1), area of a plane face that is near
// With this smoothing length of the elements, in spacings, the two outermost rows of a lattice that
// is in line with its surface are at rest within 0.01 h.
constexpr double surface_smoothing_ratio = 1.19;

// An element of the surface.
template <int D>
struct Element {
  Vector<D, double> normal;
  double area = 0.0;  // m^(D-1)
  int axis = -1;      // along which the normal points; -1: none
};

// Of the elements of a surface, m.
double element_size(double spacing, int dimension) {
  return (dimension == 2 ? 0.125 : 0.5) * spacing;
}

int axis_of(const Point& normal) {
  for (std::size_t a = 0; a < 3; ++a)
    if (std::abs(normal[a]) > 1.0 - alignment) return static_cast<int>(a);
  return -1;
}

// The elements of the surface of a body.
template <int D>
class BodySurface {
 public:
  using Position = Vector<D, double>;

  BodySurface(const Shape& shape, double spacing)
      : smoothing_length_(surface_smoothing_ratio * spacing) {
    for (const SurfaceElement& element : surface_elements(shape, D, element_size(spacing, D))) {
      middle_.push_back(vector_of<D>(element.position));
      elements_.push_back({vector_of<D>(element.normal), element.area, axis_of(element.normal)});
      if (elements_.back().axis < 0) slanted_.push_back(middle_.back());
    }
    near_.emplace(middle_, reach());
    nearest_.emplace(middle_);
    nearest_slanted_.emplace(slanted_);
  }

  // How far particles are taken into account, m.
  static double zone_reach(double spacing) {
    return (zone + WendlandC2<D>::support * relaxing_smoothing_ratio + 1.0) * spacing;
  }
  // How far elements act on particles, m.
  double reach() const { return WendlandC2<D>::support * smoothing_length_; }
  // Return the distance from the nearest element and from the nearest slanted one; infinity where
  // there is none.
  double distance(const Position& x) const { return nearest_->distance(x); }
  double slanted_distance(const Position& x) const { return nearest_slanted_->distance(x); }
  // Returns 1 for the axes along which a particle may move: no plane face across them is nearer
  // than a spacing. Single elements of round faces do not count.
  Position free_axes(const Position& x, double spacing) const {
    auto across = Position::zero();
    near_->visit_near(x, [&](std::size_t e) {
      const int axis = elements_[e].axis;
      if (axis >= 0 && axis < D && norm(middle_[e] - x) < spacing)
        across[axis] += elements_[e].area;
    });
    Position free;
    for (int a = 0; a < D; ++a)
      free[a] = across[a] > least_plane_share * std::pow(spacing, D - 1) ? 0.0 : 1.0;
    return free;
  }
  // Returns sum_e A_e W n_e, 1/m: the kernel gradients of the space outside.
  Position outside_gradient(const Position& x) const {
    auto sum = Position::zero();
    const double square_of_reach = reach() * reach();
    near_->visit_near(x, [&](std::size_t e) {
      const Position apart = middle_[e] - x;
      const double square = dot(apart, apart);
      if (square < square_of_reach)
        sum += (elements_[e].area * WendlandC2<D>::value(std::sqrt(square), smoothing_length_)) *
               elements_[e].normal;
    });
    return sum;
  }

 private:
  double smoothing_length_;  // m
  std::vector<Position> middle_, slanted_;
  std::vector<Element<D>> elements_;
  std::optional<CellGrid<D>> near_;
  std::optional<NearestPoint<D>> nearest_, nearest_slanted_;
};

template <int D>
class SurfaceFit {
 public:
  using Position = Vector<D, double>;

  SurfaceFit(const Body& body, const std::vector<Point>& nodes)
      : body_(body), spacing_(body.spacing), surface_(body.shape, body.spacing) {
    std::vector<double> slanted_distance(nodes.size());
    for_each_on_threads(static_cast<Index>(nodes.size()), [&](Index i) {
      slanted_distance[i] = surface_.slanted_distance(vector_of<D>(nodes[i]));
    });
    std::vector<std::size_t> still;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (slanted_distance[i] < zone * spacing_)
        node_.push_back(i);
      else if (slanted_distance[i] < surface_.zone_reach(spacing_))
        still.push_back(i);
    }
    moving_ = node_.size();
    node_.insert(node_.end(), still.begin(), still.end());
    for (const std::size_t i : node_) position_.push_back(vector_of<D>(nodes[i]));
    free_.resize(moving_);
    distance_.resize(moving_);
    for_each_on_threads(static_cast<Index>(moving_), [&](Index k) {
      free_[k] = surface_.free_axes(position_[k], spacing_);
      distance_[k] = surface_.distance(position_[k]);
    });
  }

  void step(bool keeps_layer) {
    const double h = relaxing_smoothing_ratio * spacing_;
    const auto inside = kernel_gradients<D>(position_, moving_, particle_volume(body_, D), h);
    for_each_on_threads(static_cast<Index>(moving_), [&](Index k) {
      Position sum = inside[k];
      if (distance_[k] < surface_.reach()) sum += surface_.outside_gradient(position_[k]);
      Position shift = (-relaxing_share * h * h) * sum;
      for (int a = 0; a < D; ++a) shift[a] *= free_[k][a];
      const double length = norm(shift), longest = longest_step * spacing_;
      if (length > longest) shift = (longest / length) * shift;
      move(k, position_[k] + shift, keeps_layer);
    });
  }

  void put_into(std::vector<Point>& nodes) const {
    for (std::size_t k = 0; k < moving_; ++k) nodes[node_[k]] = point_of<D>(position_[k]);
  }

 private:
  void move(std::size_t k, const Position& x, bool keeps_layer) {
    const Position ago = position_[k];
    position_[k] = distance_[k] < deep * spacing_ ? bounded(k, x, keeps_layer) : x;
    distance_[k] -= norm(position_[k] - ago);
  }
  // Returns the position, moved to the depth of the outermost layer where it is less deep, and
  // where it is in that layer; the old position where the new one is outside.
  Position bounded(std::size_t k, const Position& x, bool keeps_layer) const {
    if (!contains(body_.shape, point_of<D>(x), D)) return position_[k];
    const auto face = nearest_face(body_.shape, {}, point_of<D>(x), spacing_, D);
    if (!face) return x;
    const double missing = layer_depth * spacing_ - face->depth;
    if (missing <= 0.0 && !(keeps_layer && face->depth < lowest_of_layer * spacing_)) return x;
    Position way = vector_of<D>(face->normal);
    for (int a = 0; a < D; ++a) way[a] *= free_[k][a];
    const double square = dot(way, way);
    return square > 0.1 ? x - (missing / square) * way : x;
  }

  const Body& body_;
  double spacing_;
  BodySurface<D> surface_;
  std::vector<std::size_t> node_;  // numbers of those taken, first those that move
  std::size_t moving_ = 0;
  std::vector<Position> position_;
  std::vector<Position> free_;    // of those that move: 1 along axes on which they may
  std::vector<double> distance_;  // m, of those that move: no element is nearer
};

template <int D>
void fit(const Body& body, std::vector<Point>& nodes) {
  SurfaceFit<D> surface(body, nodes);
  for (int n = 0; n < relaxing_steps; ++n) surface.step(n >= free_steps);
  surface.put_into(nodes);
}

bool has_slanted_triangle(const TriangleMesh& mesh) {
  return std::any_of(
      mesh.triangles.begin(), mesh.triangles.end(), [&](const std::array<std::uint32_t, 3>& of) {
        const Point& a = mesh.corners[of[0]];
        Point normal = cross(sum(mesh.corners[of[1]], -1.0, a), sum(mesh.corners[of[2]], -1.0, a));
        const double twice = std::sqrt(dot(normal, normal));
        return twice > 0.0 && axis_of(sum({}, 1.0 / twice, normal)) < 0;
      });
}

bool has_slanted_edge(const Shape& polygon) {
  for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
    const auto& a = polygon.vertices[i];
    const auto& b = polygon.vertices[(i + 1) % polygon.vertices.size()];
    const double x = std::abs(b[0] - a[0]), y = std::abs(b[1] - a[1]);
    if (std::min(x, y) > alignment * std::max(x, y)) return true;
  }
  return false;
}

}  // namespace

bool has_slanted_face(const Shape& shape, int dimension) {
  switch (shape.kind) {
    case Shape::Kind::box:
      return false;
    case Shape::Kind::polygon:
      return has_slanted_edge(shape);
    case Shape::Kind::join:
    case Shape::Kind::difference:
      return std::any_of(shape.parts.begin(), shape.parts.end(),
                         [&](const Shape& part) { return has_slanted_face(part, dimension); });
    case Shape::Kind::mesh:
      return has_slanted_triangle(shape.mesh.surface->mesh());
    default:
      return true;  // round faces
  }
}

bool is_fitted(const Body& body, int dimension) {
  return body.body_fitted && body.grading.levels == 0 &&
         has_slanted_face(along_lattice(body).shape, dimension);
}

bool shares_volume(const Body& body, int dimension) {
  return body.role != Role::rigid && is_fitted(body, dimension);
}

double fitted_volume(const Body& body, int dimension) {
  const Point origin = bounding_box(body.shape, dimension).minimum;  // near, so that little cancels
  double flux = 0.0;                                                 // of x - origin
  for (const SurfaceElement& element :
       surface_elements(body.shape, dimension, element_size(body.spacing, dimension)))
    flux += element.area * dot(sum(element.position, -1.0, origin), element.normal);
  return flux / dimension;
}

void fit_to_surface(const Body& body, int dimension, std::vector<Point>& nodes) {
  if (nodes.empty() || !is_fitted(body, dimension)) return;
  if (dimension == 2)
    fit<2>(body, nodes);
  else
    fit<3>(body, nodes);
}

}  // namespace kerf
