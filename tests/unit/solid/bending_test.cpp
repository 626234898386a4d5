// SPDX-License-Identifier: Apache-2.0
// Pure bending of thin beams against the continuum: end moments, and the curvature between them.
#include <gtest/gtest.h>

#include "support/solid_blocks.hpp"

namespace kerf::test {
namespace {

constexpr double row_spacing = 1e-3;  // m

// A beam of `rows` particles across the axis y, seven times as long, turned as a whole.
struct Beam {
  int rows = 4;
  double poisson_ratio = 0.3;
  double jitter = 0.0;     // of the spacing
  bool hexagonal = false;  // rows along the beam
  double angle = 0.0;      // rad
  int width = 6;           // particles across the axis z, in 3D
};

template <int D>
SolidLayout<D> layout_of(const Beam& beam) {
  auto medium = soft_solid(row_spacing, D);
  const double modulus = 1e5, ratio = beam.poisson_ratio;
  medium.bulk_modulus = modulus / (3.0 * (1.0 - 2.0 * ratio));
  medium.shear_modulus = modulus / (2.0 * (1.0 + ratio));
  auto layout = block<D>(
      {.cells = {7 * beam.rows, beam.rows, beam.width}, .jitter = beam.jitter, .seed = 3}, medium);
  if (!beam.hexagonal) return layout;
  const double along = std::sqrt(2.0 / std::sqrt(3.0)), across = 1.0 / along;
  for (std::size_t k = 0; k < layout.reference.size(); ++k) {
    auto& x = layout.reference[k];
    const auto row = static_cast<int>(x[1] / row_spacing);
    x[0] = along * (x[0] + (row % 2 == 0 ? -0.25 : 0.25) * row_spacing);
    x[1] *= across;
  }
  return layout;
}

template <int D>
class BentBeam {
 public:
  explicit BentBeam(const Beam& beam) : flat_(layout_of<D>(beam)), beam_(beam), trial_(turned()) {}

  // Returns the bending stiffness over that of the continuum: in 2D the strain is plane.
  double relative_stiffness() {
    const double height = beam_.rows * row_spacing * (beam_.hexagonal ? row_distance() : 1.0);
    const double breadth = D == 3 ? beam_.width * row_spacing : 1.0;
    const double ratio = D == 2 ? beam_.poisson_ratio : 0.0;
    const double exact =
        1e5 / (1.0 - ratio * ratio) * breadth * height * height * height / 12.0;  // N m^2
    solve(moments());
    return 1.0 / (curvature() * exact);
  }

 private:
  using Column = Eigen::Matrix<double, D, 1>;
  using Field = std::vector<Column>;

  static double row_distance() { return std::sqrt(std::sqrt(3.0) / 2.0); }
  double length() const {
    return 7.0 * beam_.rows * row_spacing / (beam_.hexagonal ? row_distance() : 1.0);
  }
  Square<D> turn() const { return rotation<D>(beam_.angle); }
  SolidLayout<D> turned() const {
    auto layout = flat_;
    for (auto& x : layout.reference) {
      const Column y = turn() * as_column(x);
      for (int a = 0; a < D; ++a) x[a] = y[a];
    }
    return layout;
  }

  // Forces along the beam on the last twelfths of its length, with the moments 1 and -1 N m.
  Field moments() const {
    Field force(trial_.size(), Column::Zero());
    for (int end : {0, 1}) {
      std::vector<std::size_t> loaded;
      double middle = 0.0, square = 0.0;
      for (std::size_t i = 0; i < trial_.size(); ++i) {
        const double x = flat_.reference[i][0];
        if ((end == 0 ? x : length() - x) < length() / 12.0) loaded.push_back(i);
      }
      for (auto i : loaded) middle += flat_.reference[i][1] / static_cast<double>(loaded.size());
      for (auto i : loaded) square += std::pow(flat_.reference[i][1] - middle, 2);
      for (auto i : loaded)
        force[i] =
            turn().col(0) * (end == 0 ? 1.0 : -1.0) * (flat_.reference[i][1] - middle) / square;
    }
    return force;
  }

  // Returns minus the force of small displacements: K u.
  Field stiffness_times(const Field& u) {
    double largest = 0.0;
    for (const auto& v : u) largest = std::max(largest, v.norm());
    const double scale = 1e-9 * row_spacing / largest;  // linear to a part in 10^9
    for (std::size_t i = 0; i < trial_.size(); ++i)
      for (int a = 0; a < D; ++a)
        trial_.position[i][a] = trial_.layout.reference[i][a] + scale * u[i][a];
    trial_.evaluate();
    Field result;
    for (std::size_t i = 0; i < trial_.size(); ++i)
      result.push_back(as_column(trial_.force(i)) * (-1.0 / scale));
    return result;
  }
  static double product(const Field& a, const Field& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
    return sum;
  }

  // Conjugate gradients. The load has no resultant, so that rigid motions stay out.
  void solve(const Field& load) {
    displacement_.assign(load.size(), Column::Zero());
    Field rest = load, direction = load;
    const double start = product(load, load);
    double before = start;
    for (int n = 0; n < 4000 && before > 1e-16 * start; ++n) {
      const Field image = stiffness_times(direction);
      const double step = before / product(direction, image);
      for (std::size_t i = 0; i < load.size(); ++i) {
        displacement_[i] += step * direction[i];
        rest[i] -= step * image[i];
      }
      const double now = product(rest, rest);
      for (std::size_t i = 0; i < load.size(); ++i)
        direction[i] = rest[i] + now / before * direction[i];
      before = now;
    }
    EXPECT_LE(before, 1e-14 * start);
  }

  // Returns the curvature of the middle three sevenths, 1/m, from a fit of the deflection.
  double curvature() const {
    std::vector<std::size_t> fitted;
    for (std::size_t i = 0; i < trial_.size(); ++i)
      if (std::abs(flat_.reference[i][0] / length() - 0.5) < 1.5 / 7.0) fitted.push_back(i);
    Eigen::MatrixXd shape(fitted.size(), 6);
    Eigen::VectorXd deflection(fitted.size());
    for (std::size_t k = 0; k < fitted.size(); ++k) {
      const auto& x = flat_.reference[fitted[k]];
      const double s = x[0] / length() - 0.5, y = x[1] / length(),
                   z = D == 3 ? x[2] / length() : 0.0;
      shape.row(static_cast<Eigen::Index>(k)) << 1.0, s, 0.5 * s * s, y, y * y, z * z;
      deflection[static_cast<Eigen::Index>(k)] = turn().col(1).dot(displacement_[fitted[k]]);
    }
    const Eigen::VectorXd factors = shape.completeOrthogonalDecomposition().solve(deflection);
    return factors[2] / (length() * length());
  }

  SolidLayout<D> flat_;
  Beam beam_;
  SolidOnTrial<D, Double> trial_;
  Field displacement_;
};

void expect_stiff(double stiffness, const Beam& beam) {
  SCOPED_TRACE(testing::Message() << beam.rows << " rows, nu = " << beam.poisson_ratio
                                  << ", jitter = " << beam.jitter << ", angle = " << beam.angle
                                  << (beam.hexagonal ? ", hexagonal" : ""));
  EXPECT_NEAR(stiffness, 1.0, 0.05);
  testing::Test::RecordProperty("stiffness", std::to_string(stiffness));
}

// Rows of particles are softer by 2.7 / n^2 (docs/theory/total_lagrangian.md).
TEST(Bending, RowsAreAsStiffAsTheContinuum) {
  for (int rows : {10, 16})
    for (double ratio : {0.0, 0.3, 0.45})
      for (bool hexagonal : {false, true}) {
        const Beam beam{.rows = rows, .poisson_ratio = ratio, .hexagonal = hexagonal};
        expect_stiff(BentBeam<2>(beam).relative_stiffness(), beam);
      }
}

// A beam that is turned with its lattice bends as one that is not.
TEST(Bending, DoesNotDependOnTheDirectionOfALattice) {
  for (double ratio : {0.0, 0.45}) {
    Beam beam{.rows = 4, .poisson_ratio = ratio};
    const double flat = BentBeam<2>(beam).relative_stiffness();
    beam.angle = 0.5;
    EXPECT_NEAR(BentBeam<2>(beam).relative_stiffness(), flat, 1e-4);
  }
}

}  // namespace
}  // namespace kerf::test
