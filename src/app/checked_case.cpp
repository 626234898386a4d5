// SPDX-License-Identifier: Apache-2.0
#include "app/checked_case.hpp"

#include <fmt/format.h>

#include <utility>

#include "app/check_warnings.hpp"
#include "core/error.hpp"
#include "input/read.hpp"
#include "output/piece_reasons.hpp"
#include "study/local_executor.hpp"

namespace kerf {

CheckedCase checked_case(const std::string& text, const std::string& file) {
  Case description = parse_case(text, file, quick_look);
  const DerivedNumbers numbers = derive(description);
  auto warnings = check_warnings(description, numbers);
  for (const auto& warning : resolution_warnings(description))
    warnings.push_back(fmt::format("{}: {}", file, warning));
  auto piece = piece_reasons(description);
  return {{text, file, std::move(description), numbers, {}},
          std::move(piece),
          std::move(warnings),
          available_memory()};
}

std::optional<Case> valid_case(const std::string& text, const std::string& file) {
  try {
    return parse_case(text, file, quick_look);
  } catch (const UserError&) {
    return {};
  }
}

}  // namespace kerf
