// SPDX-License-Identifier: Apache-2.0
#include "output/pulse_flag.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/nozzle.hpp"
#include "machine/machine_jet.hpp"
#include "model/case.hpp"
#include "output/readable.hpp"

namespace kerf {

namespace {

bool is_of_machine(const Case& description, std::size_t jet) {
  return description.machine && description.jets[jet].name == machine_jet_name &&
         jet + 1 == description.jets.size();
}

// A machine without pulses has a jet in drops beyond its coherent length.
bool is_in_drops(const Case& description, std::size_t jet) {
  return is_of_machine(description, jet) && !description.machine->is_pulsed();
}

}  // namespace

std::optional<std::string> merged_pulses(const Case& description, std::size_t jet) {
  const Jet& pulsed = description.jets[jet];
  const Slugs slugs = slugs_of(pulsed);
  if (!(slugs.merged > 1.0)) return {};
  const bool drops = is_in_drops(description, jet);
  const std::string path =
      is_of_machine(description, jet) ? "machine" : fmt::format("jet[{}]", jet + 1);
  const double greatest = pulse_spacing(pulsed);
  std::string text = fmt::format(
      "{}.{} = {}: {} is {} of water and a gap of {}. Allowed: at least {:g} spacings of water and "
      "{:g} of gap, which the particles hold. {:.4g} come as one, with the same mean flow and "
      "momentum, and hit less often but with more water each. Choose a {}.spacing of at most {}",
      path, drops ? "standoff" : "pulse_frequency",
      drops ? readable(description.machine->standoff, "m") : readable(pulsed.pulse_frequency, "Hz"),
      drops ? "each drop of the broken jet" : "each pulse",
      readable(pulsed.speed * pulsed.duty / pulsed.pulse_frequency, "m"),
      readable(pulsed.speed * (1.0 - pulsed.duty) / pulsed.pulse_frequency, "m"), Slugs::least_slug,
      Slugs::least_gap, slugs.merged, path, readable(greatest, "m"));
  if (!drops)
    text += fmt::format(", or a frequency of at most {}",
                        readable(pulsed.pulse_frequency * greatest / pulsed.spacing, "Hz"));
  return text;
}

void add_pulse_flag(const Case& description, std::vector<ValidityFlag>& flags) {
  for (std::size_t jet = 0; jet < description.jets.size(); ++jet)
    if (const auto text = merged_pulses(description, jet)) {
      flags.push_back(
          {"pulses",
           is_in_drops(description, jet) ? ValidityFlag::State::note : ValidityFlag::State::warning,
           description.jets[jet].spacing, pulse_spacing(description.jets[jet]), *text + "."});
      return;
    }
}

}  // namespace kerf
