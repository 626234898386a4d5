// SPDX-License-Identifier: Apache-2.0
#include "analysis/whole_frame.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "analysis/jet_axis.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

bool contains_axis(const JetAxis& jet, std::size_t axis, double position) {
  constexpr double rounding = 1e-6;  // of the width of the jet, and of the unit vector
  return std::abs(jet.aim[axis] - position) <= rounding * jet.width &&
         std::abs(jet.along[axis]) <= rounding;
}

template <class T>
void repeat(std::vector<T>& values, std::size_t count) {
  const auto once = static_cast<std::ptrdiff_t>(values.size());
  values.resize(count * values.size());
  for (std::size_t n = 1; n < count; ++n)
    std::copy_n(values.begin(), once, values.begin() + static_cast<std::ptrdiff_t>(n) * once);
}

std::array<double, 3> mirrored(std::array<double, 3> x, const SymmetryImages& images,
                               std::uint32_t image, bool is_position) {
  for (std::size_t p = 0; p < images.planes.size(); ++p) {
    if ((image >> p & 1u) == 0) continue;
    const auto& [axis, position, joins] = images.planes[p];
    x[axis] = (is_position ? 2.0 * position : 0.0) - x[axis];
  }
  return x;
}

void mirror(std::vector<std::array<double, 3>>& vectors, const SymmetryImages& images,
            bool is_position) {
  const std::size_t once = vectors.size();
  vectors.reserve(images.count() * once);
  for (std::uint32_t image = 1; image < images.count(); ++image)
    for (std::size_t row = 0; row < once; ++row)
      vectors.push_back(mirrored(vectors[row], images, image, is_position));
}

// Numbers the pieces of the whole: a piece that bonds join to its images in some planes is one with
// these. `label`: of the part, and then of the whole.
void mirror_pieces(std::vector<std::uint32_t>& label, const std::vector<std::uint8_t>& joined,
                   const SymmetryImages& images) {
  if (label.empty()) return;
  const auto once = static_cast<std::uint32_t>(label.size());
  std::unordered_map<std::uint32_t, std::uint32_t> first;  // row of each label
  std::vector<std::uint32_t> own(once), planes(once, 0);   // planes by `first`, as bits of images
  for (std::uint32_t row = 0; row < once; ++row) {
    const bool is_as_before = row > 0 && label[row] == label[row - 1];  // as most are
    own[row] = is_as_before ? own[row - 1] : first.try_emplace(label[row], row).first->second;
    for (std::size_t p = 0; p < images.planes.size() && !joined.empty(); ++p)
      if ((joined[row] & images.planes[p].joins) != 0) planes[own[row]] |= 1u << p;
  }
  label.clear();
  for (std::uint32_t image = 0; image < images.count(); ++image)
    for (std::uint32_t row = 0; row < once; ++row)
      label.push_back((image & ~planes[own[row]]) * once + own[row]);
}

}  // namespace

SymmetryImages symmetry_images(const Case& description) {
  SymmetryImages images;
  std::optional<JetAxis> jet;
  if (!description.jets.empty()) jet.emplace(description.jets.front(), description.dimension);
  for (std::size_t a = 0; a < static_cast<std::size_t>(description.dimension); ++a) {
    const bool is_low = description.symmetry.minimum[a], is_high = description.symmetry.maximum[a];
    std::vector<SymmetryImages::Plane> planes;
    if (is_low)
      planes.push_back({a, description.domain.minimum[a], static_cast<std::uint8_t>(1u << 2 * a)});
    if (is_high)
      planes.push_back({a, description.domain.maximum[a], static_cast<std::uint8_t>(2u << 2 * a)});
    for (const SymmetryImages::Plane& plane : planes) {
      const bool has_jet = jet && contains_axis(*jet, a, plane.position);
      if (planes.size() > 1 && !has_jet) continue;
      images.planes.push_back(plane);
      break;
    }
  }
  if (jet) images.jets = images_of(*jet, images);
  return images;
}

std::array<double, 3> point_of_part(std::array<double, 3> x, const SymmetryImages& images) {
  for (const SymmetryImages::Plane& plane : images.planes) {
    const double beyond = x[plane.axis] - plane.position;
    x[plane.axis] = plane.position + (plane.is_low() ? std::abs(beyond) : -std::abs(beyond));
  }
  return x;
}

int images_of(const JetAxis& jet, const SymmetryImages& images) {
  int count = 1;
  for (const SymmetryImages::Plane& plane : images.planes)
    if (!contains_axis(jet, plane.axis, plane.position)) count *= 2;
  return count;
}

std::size_t jets_of_whole(const Case& description) {
  return axes_of_jets(description, symmetry_images(description)).size();
}

std::vector<JetAxis> axes_of_jets(const Case& description, const SymmetryImages& images) {
  std::vector<JetAxis> axes;
  for (const Jet& each : description.jets) {
    const JetAxis jet(each, description.dimension);
    for (std::uint32_t image = 0; image < images.count(); ++image) {
      // A plane through the axis adds no jet.
      bool is_same = false;
      for (std::size_t p = 0; p < images.planes.size(); ++p)
        is_same = is_same || ((image >> p & 1u) != 0 &&
                              contains_axis(jet, images.planes[p].axis, images.planes[p].position));
      if (is_same) continue;
      JetAxis& axis = axes.emplace_back(jet);
      axis.aim = mirrored(axis.aim, images, image, true);
      for (auto* vector : {&axis.along, &axis.across, &axis.sideways, &axis.travel})
        *vector = mirrored(*vector, images, image, false);
    }
  }
  return axes;
}

Frame whole_frame(const Frame& part, const SymmetryImages& images) {
  Frame whole = part;
  if (images.planes.empty()) return whole;
  const std::size_t count = images.count();
  mirror(whole.position, images, true);
  mirror(whole.velocity, images, false);
  repeat(whole.category, count);
  repeat(whole.id, count);
  repeat(whole.source, count);
  repeat(whole.spacing, count);
  repeat(whole.mass, count);
  repeat(whole.density, count);
  repeat(whole.pressure, count);
  repeat(whole.upstream, count);
  mirror_pieces(whole.piece, part.joined_planes, images);
  mirror_pieces(whole.body_piece, part.joined_planes, images);
  whole.joined_planes.clear();
  std::erase_if(whole.columns, [](const Column& column) { return column.components != 1; });
  for (Column& column : whole.columns) repeat(column.values, count);
  return whole;
}

}  // namespace kerf
