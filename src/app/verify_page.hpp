// SPDX-License-Identifier: Apache-2.0
// The generated part of docs/validation.md: tables, curves beside their references, and pictures.
#pragma once

#include <filesystem>
#include <vector>

#include "verify/verify.hpp"

namespace kerf {

// Puts the part between the marks of the page anew, and its figures into images/validation/ beside
// it; figures that are no longer shown are removed. Throws UserError (exit_files) where the page
// cannot be read or written, or has no marks.
void write_verification_page(const std::filesystem::path& page,
                             const std::vector<VerificationCase>& cases, const Findings& findings);

}  // namespace kerf
