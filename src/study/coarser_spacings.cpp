// SPDX-License-Identifier: Apache-2.0
#include "study/coarser_spacings.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/shapes.hpp"
#include "input/refine.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

constexpr double least_across = 5.0;  // particles across the jet
constexpr double least_ratio = 1.26;

double across_jet(const Case& description) {
  const Jet& jet = description.jets.front();
  return jet.width / jet.spacing;
}

bool has_planes(const Case& description) {
  const Faces& planes = description.symmetry;
  for (std::size_t a = 0; a < 3; ++a)
    if (planes.minimum[a] || planes.maximum[a]) return true;
  return false;
}

// Adds the ratios at which a whole number of cells of a body lies in a length, and their roots, at
// which that is so at the second spacing.
void add_whole(double cells, double greatest, std::vector<double>& ratios) {
  constexpr double most = 400.0;  // cells; of more the even steps are near enough
  if (!(cells <= most)) return;
  for (double count = std::ceil(cells / (greatest * greatest)); count <= cells; count += 1.0) {
    if (count < 1.0) continue;
    ratios.push_back(cells / count);
    ratios.push_back(std::sqrt(cells / count));
  }
}

// Adds those of a body between its sides and the planes, or its other side, along an axis.
void add_whole_of(const Body& body, const Case& description, std::size_t axis, double greatest,
                  std::vector<double>& ratios) {
  const Box box = bounding_box(body.shape, description.dimension);
  const double cell = body.spacing * (1 << body.grading.levels);
  const Box& domain = description.domain;
  for (const double plane : {domain.minimum[axis], domain.maximum[axis]}) {
    const bool is_cut = plane > box.minimum[axis] && plane < box.maximum[axis];
    const double end = is_cut ? plane : box.maximum[axis];
    add_whole((end - box.minimum[axis]) / cell, greatest, ratios);
  }
}

// Returns ratios up to the greatest, in even steps and such that the cells of bodies fit between
// their sides and the planes, those nearest to `wanted` first.
std::vector<double> candidates(const Case& description, double wanted, double greatest) {
  constexpr double step = 0.005;
  std::vector<double> ratios{wanted};
  for (double ratio = least_ratio; ratio <= greatest; ratio += step) ratios.push_back(ratio);
  for (const Body& body : description.bodies)
    for (std::size_t a = 0; a < 3; ++a) add_whole_of(body, description, a, greatest, ratios);
  std::erase_if(ratios, [&](double ratio) { return ratio < least_ratio || ratio > greatest; });
  std::stable_sort(ratios.begin(), ratios.end(),
                   [&](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); });
  return ratios;
}

}  // namespace

CoarserSpacings convergence_spacings(const Case& description) {
  constexpr double beyond = 2.0;
  constexpr long fewest = 4, fewest_of_one = 2;  // columns, where planes leave no choice
  const double usual = std::sqrt(2.0), across = across_jet(description);
  const double wanted = std::clamp(std::sqrt(across / least_across), least_ratio, usual);
  if (!has_planes(description)) return {wanted, 2};
  const auto suits = [&](double ratio, long columns) {
    return std::lround(across / ratio) >= columns &&
           suits_its_planes(refined(description, 1.0 / ratio));
  };
  const std::vector<double> ratios = candidates(description, wanted, beyond);
  for (const double greatest : {usual, beyond})
    for (const double ratio : ratios)
      if (ratio <= greatest && suits(ratio * ratio, fewest) && suits(ratio, fewest))
        return {ratio, 2};
  for (const long columns : {fewest, fewest_of_one})
    for (const double ratio : ratios)
      if (suits(ratio, columns)) return {ratio, 1};
  return {wanted, 2};
}

double draft_ratio(const Case& description) {
  constexpr double greatest = 2.5;
  const double wanted = across_jet(description) >= 2.0 * least_across ? 2.0 : std::sqrt(2.0);
  if (!has_planes(description)) return wanted;
  for (const double ratio : candidates(description, wanted, greatest))
    if (suits_its_planes(refined(description, 1.0 / ratio))) return ratio;
  return wanted;
}

}  // namespace kerf
