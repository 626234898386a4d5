// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "core/error.hpp"
#include "engine/lead.hpp"
#include "model/case.hpp"

namespace kerf {

void refuse_undistributed(const Case& description, const std::string& asked,
                          const std::string& remedy) {
  if (description.formulation == Formulation::standard) return;
  throw UserError(
      fmt::format("{}: the formulation '{}' is not divided among ranks. Allowed with "
                  "several ranks: 'standard'. {}",
                  asked, formulation_words[std::size_t(description.formulation)], remedy),
      exit_bad_input);
}

}  // namespace kerf
