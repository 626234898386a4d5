// SPDX-License-Identifier: Apache-2.0
// Vector has D components; this file and tensor.hpp alone loop over components.
#pragma once

#include <cmath>

#include "core/host_device.hpp"

namespace kerf {

template <int D, class T>
struct Vector {
  T component[D];

  KERF_FUNCTION T& operator[](int a) { return component[a]; }
  KERF_FUNCTION const T& operator[](int a) const { return component[a]; }

  KERF_FUNCTION static Vector zero() {
    Vector v;
    for (int a = 0; a < D; ++a) v[a] = T(0);
    return v;
  }
  KERF_FUNCTION static Vector filled(T value) {
    Vector v;
    for (int a = 0; a < D; ++a) v[a] = value;
    return v;
  }
  // From another number type, or from the first D entries of anything indexable.
  template <class Other>
  KERF_FUNCTION static Vector from(const Other& other) {
    Vector v;
    for (int a = 0; a < D; ++a) v[a] = static_cast<T>(other[a]);
    return v;
  }

  KERF_FUNCTION Vector& operator+=(const Vector& other) {
    for (int a = 0; a < D; ++a) component[a] += other[a];
    return *this;
  }
  KERF_FUNCTION Vector& operator-=(const Vector& other) {
    for (int a = 0; a < D; ++a) component[a] -= other[a];
    return *this;
  }
  KERF_FUNCTION Vector& operator*=(T factor) {
    for (int a = 0; a < D; ++a) component[a] *= factor;
    return *this;
  }
  KERF_FUNCTION friend Vector operator+(Vector u, const Vector& v) { return u += v; }
  KERF_FUNCTION friend Vector operator-(Vector u, const Vector& v) { return u -= v; }
  KERF_FUNCTION friend Vector operator*(T factor, Vector v) { return v *= factor; }
};

template <int D, class T>
KERF_FUNCTION T dot(const Vector<D, T>& u, const Vector<D, T>& v) {
  T sum = u[0] * v[0];
  for (int a = 1; a < D; ++a) sum += u[a] * v[a];
  return sum;
}

template <int D, class T>
KERF_FUNCTION T norm(const Vector<D, T>& v) {
  return std::sqrt(dot(v, v));
}

}  // namespace kerf
