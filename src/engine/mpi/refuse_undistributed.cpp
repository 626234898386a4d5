// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "core/error.hpp"
#include "engine/lead.hpp"
#include "machine/travelling_frame.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

// Returns what several ranks cannot compute, as a clause; empty = nothing.
std::string problem_of(const Case& description) {
  if (description.formulation != Formulation::standard)
    return "the formulation 'shinohara2004' is not divided among ranks";
  for (const Body& body : description.bodies)
    if (body.grading.levels > 0)
      return fmt::format(
          "the body '{}' is graded, and the grids of several spacings are not "
          "divided among ranks",
          body.name);
  if (description.numerics.water != WaterScheme::riemann)
    return "the density gradients that numerics.water = \"delta_sph\" needs of the neighbours are "
           "not exchanged between ranks";
  if (description.time.relax > 0.0)
    return "the motion that time.relax takes from solids is not summed over ranks";
  if (travelling_frame(description))
    return "a window that travels with the nozzle is not divided among ranks";
  return "";
}

}  // namespace

void refuse_undistributed(const Case& description, const std::string& asked,
                          const std::string& remedy) {
  const std::string problem = problem_of(description);
  if (problem.empty()) return;
  throw UserError(fmt::format("{}: {}. Allowed with several ranks: water, rigid and elastic bodies "
                              "and jets in the formulation 'standard'. {}",
                              asked, problem, remedy),
                  exit_bad_input);
}

}  // namespace kerf
