// SPDX-License-Identifier: Apache-2.0
// A seal is the last line of a file, which HDF5 does not read: it is present only if all preceding
// bytes are, and it changes with any byte. The HDF5 library may crash on a damaged file, so that a
// file is given to it only with an intact seal.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace kerf {

// Returns the content with its seal. `kind` is one word.
std::string sealed(std::string content, std::string_view kind, int version);

// Returns the version in the seal of a file of that kind; nothing where the file is damaged, or is
// another one.
std::optional<int> sealed_version(std::string_view content, std::string_view kind);

}  // namespace kerf
