// SPDX-License-Identifier: Apache-2.0
// What `kerf --version` prints.
#pragma once

#include <string>

namespace kerf {

// Returns "kerf VERSION" and, on lines of their own, the commit, the compiler and what this build
// can do on this machine.
std::string version_text();

}  // namespace kerf
