// SPDX-License-Identifier: Apache-2.0
#include "output/seal.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>
#include <cstdlib>

namespace kerf {

namespace {

std::string seal_of(std::string_view content, std::string_view kind, int version) {
  boost::crc_32_type sum;
  sum.process_bytes(content.data(), content.size());
  return fmt::format("\nkerf {}, version {:5}, crc32 {:08x}\n", kind, version, sum.checksum());
}

}  // namespace

std::string sealed(std::string content, std::string_view kind, int version) {
  content += seal_of(content, kind, version);
  return content;
}

std::optional<int> sealed_version(std::string_view content, std::string_view kind) {
  constexpr std::string_view mark = "version ";
  const std::string pattern = seal_of({}, kind, 0);
  if (content.size() < pattern.size()) return std::nullopt;
  const std::size_t split = content.size() - pattern.size();
  const std::string seal(content.substr(split));
  const int version = std::atoi(seal.substr(pattern.find(mark) + mark.size(), 5).c_str());
  if (seal != seal_of(content.substr(0, split), kind, version)) return std::nullopt;
  return version;
}

}  // namespace kerf
