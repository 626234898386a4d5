// SPDX-License-Identifier: Apache-2.0
// A placement sets a verification case up elsewhere: turned against the lattices of its bodies,
// mirrored, with its jets moved by part of a spacing, or with its nozzles further away. The physics
// stays the same, so what a run gives is mapped back to the case as it is written, and every signal
// and reference holds as before.
#pragma once

#include <string>
#include <vector>

#include "simulation/balance.hpp"
#include "simulation/frame.hpp"

namespace kerf {

struct Case;
struct VerificationCase;

// Why a case does not allow each kind of move, in a clause such as "the wall would be in the jet";
// empty where it does.
struct PlacementRefusals {
  std::string turned, mirrored, moved, standoff;
};

// A point x of the case lies at R(angle) M (x + moved d across) of the run, where M mirrors x and d
// is the spacing of the first jet, by which `across` (at right angles to the jet) is scaled.
struct Placement {
  double angle = 0.0;  // rad, about z, counterclockwise; lattices turn only where they follow faces
  bool mirrored = false;  // x becomes -x before the turn
  double moved = 0.0;     // spacings of the first jet, by which jets and probes move across the jet
  double standoff = 1.0;  // factor of the standoff of jets; at least 1

  bool is_as_written() const { return *this == Placement{}; }
  std::string text() const;  // "turned 30 deg, mirrored"; "as written"
  bool operator==(const Placement&) const = default;
};

// Draws any angle, a mirror, a move by up to half a spacing and up to one and a half times the
// standoff from a text, in the same way on every machine.
Placement random_placement(const std::string& text);

// Returns why a case cannot be placed like this, in a clause such as "it has no jet"; empty if it
// can.
std::string placement_problem(const Case& description, const Placement& placement);

// Returns the parts of a placement that a case allows; the case as it is written if it allows none.
Placement allowed_part(const Case& description, const Placement& placement);

// The same for a verification case: what all of its runs allow and it does not refuse.
std::string placement_problem(const VerificationCase& verification, const Placement& placement);
Placement allowed_part(const VerificationCase& verification, const Placement& placement);

// Returns the parts of a placement that a verification case allows, and why not the others, as
// text.
std::string allowed_text(const VerificationCase& verification, const Placement& placement);

// Returns the case of the run. The domain is the bounding box of the turned one.
Case placed(Case description, const Placement& placement);

// Maps what a run gives back to the case as it is written.
class PlacementInverse {
 public:
  PlacementInverse(const Case& written, const Placement& placement);

  double delay() const { return delay_; }  // s, later arrival of jets with a larger standoff
  // Scalars, and tensors among the further columns, stay as they are.
  Frame frame(Frame frame) const;
  Balance balance(Balance balance) const;
  std::vector<double> probe_values(std::vector<double> values) const;

 private:
  std::array<double, 3> vector(const std::array<double, 3>& v) const;

  Placement placement_;
  std::array<double, 3> shift_{};     // m, of jets and probes in the case as written
  std::vector<std::size_t> vectors_;  // index of the first component of each vector of probes
  double delay_ = 0.0;
};

}  // namespace kerf
