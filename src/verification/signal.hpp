// SPDX-License-Identifier: Apache-2.0
// A signal is one number of a run over time, in SI units. Checks name it by "signal" and give its
// parameters; docs/validation.md lists them.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "verification/moment.hpp"
#include "verification/parameters.hpp"

namespace kerf {

using Signal = std::function<double(Moment&)>;
using SignalMaker = std::function<Signal(const Parameters&, const Beginning&)>;

// Returns every signal by name.
const std::map<std::string, SignalMaker>& signal_makers();

// Makes the signal. Throws std::logic_error for an unknown name or wrong parameters.
Signal make_signal(const Parameters& parameters, const Beginning& beginning);

// Returns the number of the body that a key names, which is also its source in a frame.
std::size_t named_body(const Parameters& parameters, const Beginning& beginning,
                       const std::string& key = "body");

// Returns the axis that the key "axis" names: 0, 1, 2 for x, y, z.
std::size_t named_axis(const Parameters& parameters);

// Signals of probes, of the balance, of the cut and of the cut at the feed of the nozzle.
Signal probe_signal(const Parameters& parameters, const Beginning& beginning);
Signal balance_signal(const Parameters& parameters, const Beginning& beginning);
Signal cut_signal(const Parameters& parameters, const Beginning& beginning);
Signal exposure_signal(const Parameters& parameters, const Beginning& beginning);

// Signals over the particles of a body, weighted by a formula of their initial positions.
Signal body_mean_signal(const Parameters& parameters, const Beginning& beginning);
Signal kinetic_centroid_signal(const Parameters& parameters, const Beginning& beginning);
// Signal that compares the pressure with a formula of the position.
Signal profile_error_signal(const Parameters& parameters, const Beginning& beginning);

// Signals of shapes.
Signal extent_signal(const Parameters& parameters, const Beginning& beginning);
Signal asymmetry_signal(const Parameters& parameters, const Beginning& beginning);
Signal jet_split_signal(const Parameters& parameters, const Beginning& beginning);
Signal fractured_below_jet_signal(const Parameters& parameters, const Beginning& beginning);
Signal largest_stretch_signal(const Parameters& parameters, const Beginning& beginning);

// Signals of solids of the standard formulation: their energy and their broken bonds.
Signal hourglass_share_signal(const Parameters& parameters, const Beginning& beginning);
Signal largest_damage_signal(const Parameters& parameters, const Beginning& beginning);
Signal crack_signal(const Parameters& parameters, const Beginning& beginning);

// Signals of water on other bodies.
Signal jet_tip_signal(const Parameters& parameters, const Beginning& beginning);
Signal forward_share_signal(const Parameters& parameters, const Beginning& beginning);
Signal deepest_water_signal(const Parameters& parameters, const Beginning& beginning);

// Signals over the particles of a body that are in a region at the time.
Signal region_volume_signal(const Parameters& parameters, const Beginning& beginning);
Signal region_velocity_signal(const Parameters& parameters, const Beginning& beginning);
Signal reach_signal(const Parameters& parameters, const Beginning& beginning);

}  // namespace kerf
