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

namespace {

// Returns why a run refuses a case that is too large for it; nothing where it does not.
std::optional<std::string> refusal_of(const std::string& text, const std::string& file,
                                      const DerivedNumbers& numbers) {
  constexpr std::size_t surely_few = 100'000;  // also where they are graded
  if (numbers.particles_expected < surely_few) return {};
  try {
    parse_case(text, file, {ReadEffort{}.most_particles, quick_look.most_tested});
  } catch (const UserError& error) {
    return fmt::format("A run refuses this case: {}", error.what());
  }
  return {};
}

}  // namespace

CheckedCase checked_case(const std::string& text, const std::string& file) {
  Case description = parse_case(text, file, quick_look);
  const auto loose = refuse_unbonded(description, text, file);
  const DerivedNumbers numbers = derive(description);
  auto warnings = check_warnings(description, numbers, loose);
  for (const auto& warning : resolution_warnings(description))
    warnings.push_back(fmt::format("{}: {}", file, warning));
  const auto refusal = refusal_of(text, file, numbers);
  if (refusal) warnings.insert(warnings.begin(), *refusal);
  auto piece = piece_reasons(description);
  CheckedCase checked{{text, file, std::move(description), numbers, {}},
                      std::move(piece),
                      std::move(warnings),
                      available_memory()};
  checked.is_refused = refusal.has_value();
  return checked;
}

std::string verdict_of(const CheckedCase& checked) {
  if (checked.is_refused)
    return "a run refuses this case, which is too large (see Warnings); its keys are valid";
  if (checked.costed.numbers.memory > checked.memory)
    return "this machine has too little memory for a run of the case (see What to change); its "
           "keys "
           "are valid";
  return "the case is valid";
}

std::optional<Case> valid_case(const std::string& text, const std::string& file) {
  try {
    return parse_case(text, file, quick_look);
  } catch (const UserError&) {
    return {};
  }
}

}  // namespace kerf
