// SPDX-License-Identifier: Apache-2.0
// The words of a case file for sides of a box.
#pragma once

#include <string>
#include <vector>

#include "model/shape.hpp"

namespace kerf {

// Returns the words of the sides that are set, in the order of `face_words`.
inline std::vector<std::string> names_of(const Faces& faces) {
  std::vector<std::string> names;
  for (std::size_t a = 0; a < 3; ++a) {
    if (faces.minimum[a]) names.emplace_back(face_words[2 * a]);
    if (faces.maximum[a]) names.emplace_back(face_words[2 * a + 1]);
  }
  return names;
}

}  // namespace kerf
