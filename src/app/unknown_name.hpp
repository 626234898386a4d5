// SPDX-License-Identifier: Apache-2.0
// A name on the command line that there is not.
#pragma once

#include <string>
#include <vector>

namespace kerf {

// Throws the UserError "SENTENCE. Did you mean "..."? Allowed: ...", the question only where one of
// the names that there are is near.
[[noreturn]] void refuse_name(const std::string& sentence, const std::string& name,
                              const std::vector<std::string>& known,
                              const std::string& separator = ", ");

}  // namespace kerf
