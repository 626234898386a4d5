// SPDX-License-Identifier: Apache-2.0
#include "output/solid_flags.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/error.hpp"
#include "model/case.hpp"
#include "output/crushing.hpp"
#include "output/result.hpp"

namespace kerf {
namespace {

// A layer of this many particles has bonds in all directions.
constexpr double least_layers = 2.0;

const Body& body_of(const Case& description, const LooseParticles& loose) {
  return description.bodies.at(static_cast<std::size_t>(loose.body));
}

}  // namespace

std::string loose_sentence(const Case& description, const LooseParticles& loose) {
  return fmt::format(
      "{} of the {} particles of \"{}\" have too few neighbours to be bonded, where it is one "
      "particle thick or a tip: they are loose from the start, bear no load and do not count as "
      "part of the workpiece. A finer spacing than {:.4g} m, with {:g} particles or more across, "
      "bonds them",
      loose.loose, loose.all, body_of(description, loose).name, body_of(description, loose).spacing,
      least_layers);
}

std::optional<LooseBody> loose_body(const Case& description,
                                    const std::vector<LooseParticles>& bodies) {
  for (const LooseParticles& loose : bodies) {
    if (loose.loose < loose.all) continue;
    const Body& body = body_of(description, loose);
    const bool is_workpiece = description.workpiece && loose.body == 0;
    const int number = loose.body + (description.workpiece ? 0 : 1);
    const std::string key =
        is_workpiece ? std::string("workpiece.spacing") : fmt::format("body[{}].spacing", number);
    return LooseBody{
        key,
        fmt::format(
            "{} (\"{}\") = {:.4g} m: none of its {} particles has neighbours enough "
            "to be bonded, so that it is no solid but loose particles. Allowed: {:g} particles or "
            "more across the thickness. Choose a spacing of half of that or less",
            key, body.name, body.spacing, loose.all, least_layers)};
  }
  return {};
}

void refuse_loose_bodies(const Case& description, const std::vector<LooseParticles>& bodies) {
  if (const auto loose = loose_body(description, bodies))
    throw UserError(loose->sentence, exit_bad_input);
}

namespace {

// Tells of intact solid that is out of the domain, where nothing is known of it.
void add_of_left_whole(const RunOutcome& outcome, std::vector<ValidityFlag>& flags) {
  constexpr double little = 0.01;  // of the workpiece
  const double share = outcome.cut.left_fraction();
  if (!(share > 0.0)) return;
  const auto state = share > little ? ValidityFlag::State::warning : ValidityFlag::State::note;
  flags.push_back(
      {"left_whole", state, share, little,
       fmt::format("{:.2g}% of the workpiece has left the domain unbroken: the shares and volumes "
                   "of what is fractured and removed count it, although {}. "
                   "A larger [domain] keeps it.",
                   100.0 * share,
                   outcome.description.jets.empty() ? "nothing has broken it"
                                                    : "the jet has not broken it")});
}

// Flags the first body under the jet that its pressure crushes.
void add_of_crushing(const RunOutcome& outcome, std::vector<ValidityFlag>& flags) {
  const Case& description = outcome.description;
  if (description.jets.empty() || description.formulation != Formulation::standard) return;
  for (const BodyVerdict& verdict : outcome.cut.bodies) {
    if (!verdict.is_in_way) continue;
    const Jet& jet = description.jets.front();
    const Body& body = description.bodies.at(static_cast<std::size_t>(verdict.body));
    const auto crushing = crushing_of(description, body, jet);
    if (!crushing) continue;
    std::string sentence = crushing_sentence(description, body, jet, *crushing) + ".";
    sentence.front() = 'T';
    flags.push_back({"crushing", ValidityFlag::State::warning, crushing->pressure, crushing->limit,
                     std::move(sentence)});
    return;
  }
}

}  // namespace

void add_solid_flags(const RunOutcome& outcome, std::vector<ValidityFlag>& flags) {
  for (const LooseParticles& loose : outcome.loose)
    flags.push_back({"loose_particles", ValidityFlag::State::warning,
                     static_cast<double>(loose.loose), 0.0,
                     loose_sentence(outcome.description, loose) + "."});
  if (const double share = outcome.cut.pressed_share; share > 0.0)
    flags.push_back(
        {"pressed_into_rigid", ValidityFlag::State::warning, share, 0.0,
         fmt::format(
             "{:.2g}% of the workpiece was a spacing or more inside a rigid body, where no "
             "solid can be: the pressure was beyond the stiffness of the solid. What is behind "
             "the face of that body means nothing. Use a slower jet or a stiffer solid.",
             100.0 * share)});
  add_of_left_whole(outcome, flags);
  add_of_crushing(outcome, flags);
}

}  // namespace kerf
