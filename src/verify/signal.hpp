// SPDX-License-Identifier: Apache-2.0
// A signal is one number of a run over time, in SI units. Checks choose it by name ("signal") and
// give its parameters; docs/validation.md lists them.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "verify/moment.hpp"
#include "verify/parameters.hpp"

namespace kerf {

using Signal = std::function<double(Moment&)>;
using SignalMaker = std::function<Signal(const Parameters&, const Beginning&)>;

// Every signal there is, by name.
const std::map<std::string, SignalMaker>& signal_makers();

// Throws std::logic_error for a name that is not there or parameters that do not fit.
Signal make_signal(const Parameters& parameters, const Beginning& beginning);

// Number of the body that a key names, which is also its source in a frame.
std::size_t named_body(const Parameters& parameters, const Beginning& beginning,
                       const std::string& key = "body");

// The axis that the key "axis" names: 0, 1, 2 for x, y, z.
std::size_t named_axis(const Parameters& parameters);

// From the run's own books.
Signal probe_signal(const Parameters& parameters, const Beginning& beginning);
Signal ledger_signal(const Parameters& parameters, const Beginning& beginning);
Signal cut_signal(const Parameters& parameters, const Beginning& beginning);

// Over the particles of a body, weighted by a formula of their first places.
Signal body_mean_signal(const Parameters& parameters, const Beginning& beginning);
Signal kinetic_centroid_signal(const Parameters& parameters, const Beginning& beginning);
// Against a formula of where they are.
Signal profile_error_signal(const Parameters& parameters, const Beginning& beginning);

// Of the shape of things.
Signal extent_signal(const Parameters& parameters, const Beginning& beginning);
Signal asymmetry_signal(const Parameters& parameters, const Beginning& beginning);
Signal jet_split_signal(const Parameters& parameters, const Beginning& beginning);
Signal fractured_below_jet_signal(const Parameters& parameters, const Beginning& beginning);
Signal largest_stretch_signal(const Parameters& parameters, const Beginning& beginning);

// Of solids of the standard formulation: their energy and their broken bonds.
Signal hourglass_share_signal(const Parameters& parameters, const Beginning& beginning);
Signal largest_damage_signal(const Parameters& parameters, const Beginning& beginning);
Signal crack_signal(const Parameters& parameters, const Beginning& beginning);

// Of water on other matter.
Signal jet_tip_signal(const Parameters& parameters, const Beginning& beginning);
Signal forward_share_signal(const Parameters& parameters, const Beginning& beginning);
Signal deepest_water_signal(const Parameters& parameters, const Beginning& beginning);

// Over what of a body is in a region at the time.
Signal region_volume_signal(const Parameters& parameters, const Beginning& beginning);
Signal region_velocity_signal(const Parameters& parameters, const Beginning& beginning);

}  // namespace kerf
