// SPDX-License-Identifier: Apache-2.0
// Bytes as text, RFC 4648.
#pragma once

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <string>
#include <string_view>

namespace kerf {

inline std::string base64(std::string_view bytes) {
  using namespace boost::archive::iterators;
  using Encode = base64_from_binary<transform_width<const char*, 6, 8>>;
  std::string text(Encode(bytes.data()), Encode(bytes.data() + bytes.size()));
  text.append((3 - bytes.size() % 3) % 3, '=');
  return text;
}

}  // namespace kerf
