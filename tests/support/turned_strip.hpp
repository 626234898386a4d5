// SPDX-License-Identifier: Apache-2.0
// A long notched strip whose axes are turned against the lattice of its particles. Its clamped
// edges move apart until the strip ahead of the notch stores a chosen energy per area of crack, and
// stay there.
#pragma once

#include "support/solid_blocks.hpp"

namespace kerf::test {

struct StripChoice {
  double angle = 0.0;     // of the notch against the lattice, degrees
  double spacing = 1e-3;  // m
  double shift = 0.0;     // of the lattice against the strip, spacings
  bool is_mirrored = false;
  double jitter = 0.0;    // spacings
  double height = 20e-3;  // between the clamped edges, m
};

// Axes of the strip: along the notch and across it.
struct StripAxes {
  double cosine = 1.0, sine = 0.0;
  Vector<2, double> in_strip(const Vector<2, double>& x) const {
    return {cosine * x[0] + sine * x[1], -sine * x[0] + cosine * x[1]};
  }
  Vector<2, double> across(double y) const { return {-sine * y, cosine * y}; }
};

// A straight cut along the middle of the strip up to `tip`.
struct StraightNotch {
  StripAxes axes;
  double tip;
  KERF_FUNCTION bool operator()(const Vector<2, double>& a, const Vector<2, double>& b) const {
    const auto p = axes.in_strip(a), q = axes.in_strip(b);
    if ((p[1] < 0.0) == (q[1] < 0.0)) return false;
    return p[0] + p[1] / (p[1] - q[1]) * (q[0] - p[0]) < tip;
  }
};

struct GrownCrack {
  double length = 0.0;  // beyond the notch, m
  double angle = 0.0;   // of its path against the notch, degrees
};

class TurnedStrip {
 public:
  TurnedStrip(const StripChoice& choice, Medium<double> medium)
      : choice_(choice),
        medium_(medium),
        axes_{std::cos(choice.angle * radian), std::sin(choice.angle * radian)},
        trial_(layout()) {
    trial_.solid.cut(StraightNotch{axes_, tip()});
    for (std::size_t i = 0; i < trial_.size(); ++i) {
      const auto place = axes_.in_strip(trial_.layout.reference[i]);
      place_.push_back(place);
      const bool is_clamped = std::abs(place[1]) > 0.5 * choice.height;
      clamped_.push_back(!is_clamped ? 0.0 : place[1] > 0.0 ? 1.0 : -1.0);
      bonds_.push_back(trial_.solid.view().intact_bonds(static_cast<Index>(i)));
    }
  }

  // Loads the strip until a crack that grows releases `energy` per area, J/m^2, and waits. A crack
  // far from the ends of a clamped strip releases M strain^2 H / 2 (Rivlin & Thomas, J. Polym. Sci.
  // 10 (1953) 291), with M the P-wave modulus and H the distance of the clamped rows.
  GrownCrack load(double energy) {
    const double modulus = medium_.bulk_modulus + 4.0 / 3.0 * medium_.shear_modulus;
    const double wave = std::sqrt(modulus / medium_.density), crossing = choice_.height / wave;
    const double rise = 20.0 * crossing, wait = 10.0 * crossing, dt = 0.4 * choice_.spacing / wave;
    const double rows = choice_.height + choice_.spacing;
    const double displacement = 0.5 * std::sqrt(2.0 * energy * rows / modulus);
    trial_.evaluate();
    for (double t = 0.0; t < rise + wait; t += dt)  // as t^2 to its end
      step(dt, t < rise ? 2.0 * displacement * (t + 0.5 * dt) / (rise * rise) : 0.0);
    return crack();
  }

 private:
  static constexpr double radian = 0.017453292519943295;
  double length() const { return 2.6 * choice_.height; }
  double tip() const { return -0.1 * choice_.height; }

  SolidLayout<2> layout() const {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> uniform(-choice_.jitter, choice_.jitter);
    SolidLayout<2> layout;
    layout.media = {medium_};
    const int most = static_cast<int>(length() / choice_.spacing);
    for (int row = -most; row <= most; ++row)
      for (int column = -most; column <= most; ++column) {
        Vector<2, double> x{choice_.spacing * (column + 0.5 + 0.3 * choice_.shift),
                            choice_.spacing * (row + 0.5 + choice_.shift)};
        if (choice_.is_mirrored) x[1] = -x[1];
        const auto place = axes_.in_strip(x);
        if (std::abs(place[0]) > 0.5 * length() ||
            std::abs(place[1]) > 0.5 * choice_.height + 3.0 * choice_.spacing)
          continue;
        for (int a = 0; a < 2; ++a) x[a] += choice_.spacing * uniform(engine);
        layout.reference.push_back(x);
        layout.medium_index.push_back(0);
      }
    return layout;
  }

  void step(double dt, double speed) {
    trial_.kick(0.5 * dt);
    for (std::size_t i = 0; i < trial_.size(); ++i) {
      if (clamped_[i] != 0.0)
        trial_.velocity[i] = Vector<2, float>::from(axes_.across(clamped_[i] * speed));
      trial_.position[i] += dt * Vector<2, double>::from(trial_.velocity[i]);
    }
    trial_.deform();
    trial_.solid.fracture();
    trial_.evaluate();
    trial_.kick(0.5 * dt);
    trial_.solid.keep_softening();
  }

  // Particles that have lost bonds since the notch was cut show the crack; the line through its
  // path starts at the tip of the notch.
  GrownCrack crack() {
    double farthest = 0.0, square = 0.0, product = 0.0;
    for (std::size_t i = 0; i < trial_.size(); ++i) {
      const double left = trial_.solid.view().intact_bonds(static_cast<Index>(i));
      const double lost = 1.0 - left / bonds_[i];
      const double along = place_[i][0] - tip();
      if (lost > 0.3) farthest = std::max(farthest, along);
      if (lost < 0.2 || along < 1.5 * choice_.spacing || along > 0.9 * choice_.height) continue;
      square += along * along;
      product += along * place_[i][1];
    }
    return {farthest, square > 0.0 ? std::atan(product / square) / radian : 0.0};
  }

  StripChoice choice_;
  Medium<double> medium_;
  StripAxes axes_;
  SolidOnTrial<2, Mixed> trial_;
  std::vector<Vector<2, double>> place_;  // in the axes of the strip, m
  std::vector<double> clamped_, bonds_;   // side of the clamp, 0 = none; intact bonds at the start
};

}  // namespace kerf::test
