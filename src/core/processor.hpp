// SPDX-License-Identifier: Apache-2.0
// The processor that this program runs on, for those who tell how fast it is.
#pragma once

#include <fstream>
#include <string>

namespace kerf {

inline std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

}  // namespace kerf
