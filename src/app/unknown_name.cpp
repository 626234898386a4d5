// SPDX-License-Identifier: Apache-2.0
#include "app/unknown_name.hpp"

#include <fmt/format.h>

#include "case/problems.hpp"
#include "core/error.hpp"

namespace kerf {

void refuse_name(const std::string& sentence, const std::string& name,
                 const std::vector<std::string>& known, const std::string& separator) {
  const std::string guess = closest(name, known);
  throw UserError(fmt::format("{}. {}Allowed: {}.", sentence,
                              guess.empty() ? "" : fmt::format("Did you mean \"{}\"? ", guess),
                              fmt::join(known, separator)));
}

}  // namespace kerf
