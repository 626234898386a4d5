// SPDX-License-Identifier: Apache-2.0
#include "input/text_places.hpp"

#include <algorithm>

namespace kerf {

TextPlaces::TextPlaces(const std::string& text) : text_(text), lines_{0} {
  for (std::size_t at = 0; at < text.size(); ++at)
    if (text[at] == '\n') lines_.push_back(at + 1);
}

std::size_t TextPlaces::offset(const toml::source_position& place) const {
  if (place.line < 1 || place.line > lines_.size()) return text_.size();
  const auto is_continuation = [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
  };
  std::size_t at = lines_[place.line - 1];
  for (toml::source_index column = 1; column < place.column && at < text_.size(); ++column) {
    ++at;
    while (at < text_.size() && is_continuation(text_[at])) ++at;
  }
  return at;
}

std::size_t TextPlaces::line_start(std::size_t offset) const {
  return *std::prev(std::upper_bound(lines_.begin(), lines_.end(), offset));
}

std::size_t TextPlaces::line_end(std::size_t offset) const {
  const auto end = text_.find('\n', offset);
  return end == std::string::npos ? text_.size() : end + 1;
}

std::string TextPlaces::slice(const toml::source_region& region) const {
  const std::size_t begin = offset(region.begin);
  return text_.substr(begin, offset(region.end) - begin);
}

}  // namespace kerf
