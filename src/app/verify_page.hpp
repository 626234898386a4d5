// SPDX-License-Identifier: Apache-2.0
// This header declares the generated part of docs/validation.md and docs/experiments.md: tables,
// curves and pictures.
#pragma once

#include <filesystem>
#include <vector>

#include "verification/table.hpp"
#include "verification/verify.hpp"

namespace kerf {

// Replaces the part between the marks of the page PAGE.md and its figures in images/PAGE/ beside
// it; figures that the page does not show are removed. With `keeps_others` the sections of cases
// that are not among `cases` stay. Throws UserError (exit_files) when the page cannot be read or
// written or has no marks.
void write_verification_page(const std::filesystem::path& page,
                             const std::vector<VerificationCase>& cases, const Findings& findings,
                             TableKind kind, bool keeps_others);

}  // namespace kerf
