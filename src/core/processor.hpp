// SPDX-License-Identifier: Apache-2.0
// processor_name() returns the name of the processor that the program runs on.
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
