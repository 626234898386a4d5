// SPDX-License-Identifier: Apache-2.0
// A symmetry plane is a face of the domain that mirrors the particles beside it. A neighbour list
// names the mirror image of particle j by its index j with a code in the highest bits, two bits for
// each axis: mirrored at the lower face, at the upper one, or at neither; at an edge or a corner
// several axes are mirrored. Without planes there are no codes, and an entry is an index. The
// theory is in docs/theory/symmetry.md.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/matrix.hpp"

namespace kerf {

// 0: the particle itself.
using MirrorCode = std::uint32_t;

template <int D>
struct MirrorPlanes {
  Vector<D, double> low, high;  // m, coordinates of the faces
  MirrorCode faces = 0;         // codes of all faces that are planes

  static constexpr int shift = 32 - 2 * D;
  static constexpr std::uint32_t most_particles = std::uint32_t(1) << shift;
  static constexpr int images = D == 3 ? 27 : 9;  // of one particle, with itself

  KERF_FUNCTION static MirrorCode low_face(int axis) { return MirrorCode(1) << (shift + 2 * axis); }
  KERF_FUNCTION static MirrorCode high_face(int axis) {
    return MirrorCode(2) << (shift + 2 * axis);
  }
  KERF_FUNCTION static bool flips(MirrorCode code, int axis) {
    return (code & (low_face(axis) | high_face(axis))) != 0;
  }

  KERF_FUNCTION std::uint32_t particle(std::uint32_t entry) const { return entry & ~faces; }
  KERF_FUNCTION MirrorCode code(std::uint32_t entry) const { return entry & faces; }

  // Image number 0 .. images - 1, the particle itself first; false where there is no such plane.
  KERF_FUNCTION bool find_image(int number, MirrorCode& result) const {
    result = 0;
    for (int a = 0; a < D; ++a, number /= 3) {
      if (number % 3 == 1) result |= low_face(a);
      if (number % 3 == 2) result |= high_face(a);
    }
    return (result & ~faces) == 0;
  }

  // Position of the image of a point.
  KERF_FUNCTION Vector<D, double> image_position(MirrorCode code, Vector<D, double> x) const {
    for (int a = 0; a < D; ++a)
      if (flips(code, a)) x[a] = 2.0 * face(code, a) - x[a];
    return x;
  }
  // The vector from the image of y to x. Exchange of x and y changes signs only.
  KERF_FUNCTION Vector<D, double> separation(MirrorCode code, const Vector<D, double>& x,
                                             const Vector<D, double>& y) const {
    auto r = x - y;
    if (code != 0)
      for (int a = 0; a < D; ++a)
        if (flips(code, a)) r[a] = (x[a] - face(code, a)) + (y[a] - face(code, a));
    return r;
  }
  // Whether the image of x, itself inside, is within `reach` of the domain.
  KERF_FUNCTION bool is_near(MirrorCode code, const Vector<D, double>& x, double reach) const {
    for (int a = 0; a < D; ++a)
      if (flips(code, a) && !(std::abs(x[a] - face(code, a)) < reach)) return false;
    return true;
  }

  // Whether x is within `reach` of a plane.
  KERF_FUNCTION bool is_near_any(const Vector<D, double>& x, double reach) const {
    for (int a = 0; a < D; ++a)
      if (((faces & low_face(a)) != 0 && is_near(low_face(a), x, reach)) ||
          ((faces & high_face(a)) != 0 && is_near(high_face(a), x, reach)))
        return true;
    return false;
  }

  // Mirror images of vectors and tensors.
  template <class T>
  KERF_FUNCTION static Vector<D, T> image(MirrorCode code, Vector<D, T> v) {
    if (code != 0)
      for (int a = 0; a < D; ++a)
        if (flips(code, a)) v[a] = -v[a];
    return v;
  }
  template <class T>
  KERF_FUNCTION static Matrix<D, T> image(MirrorCode code, Matrix<D, T> m) {
    if (code == 0) return m;
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b)
        if (flips(code, a) != flips(code, b)) m(a, b) = -m(a, b);
    return m;
  }
  template <class T>
  KERF_FUNCTION static SymmetricTensor<D, T> image(MirrorCode code, SymmetricTensor<D, T> s) {
    if (code == 0) return s;
    for (int a = 0; a < D; ++a)
      for (int b = a + 1; b < D; ++b)
        if (flips(code, a) != flips(code, b)) s(a, b) = -s(a, b);
    return s;
  }

 private:
  KERF_FUNCTION double face(MirrorCode code, int axis) const {
    return (code & low_face(axis)) != 0 ? low[axis] : high[axis];
  }
};

}  // namespace kerf
