// SPDX-License-Identifier: Apache-2.0
// How a particle of a solid touches other bodies (rates/surface_contact.hpp).
#pragma once

#include "core/vector.hpp"

namespace kerf {

template <int D, class T>
struct Touch {
  T push;               // J, slope of its energy over the filling phi; 0 = touches nothing
  T energy;             // J
  T slope;              // 1/m, |grad phi|
  Vector<D, T> normal;  // into the other body

  KERF_FUNCTION static Touch none() { return {T(0), T(0), T(0), Vector<D, T>::zero()}; }
};

}  // namespace kerf
