// SPDX-License-Identifier: Apache-2.0
// The times at which a run observes its cut. They follow from the jets alone, so that neither the
// output nor an end that is never reached changes a verdict, its time or the end of a run.
#pragma once

namespace kerf {

struct Case;

// The interval is the time in which the fastest jet passes a part of the spacing of its particles,
// or a thousandth of the time of the run if that is more: at first water goes in by a small part of
// a spacing between two observations, and a long run has a few thousand of them.
class ObservationTimes {
 public:
  static constexpr double spacings = 0.25, relative = 1e-3;

  explicit ObservationTimes(const Case& description);
  // Without a jet the cut is observed with each row of output.
  bool has_own() const { return shortest_ > 0.0; }
  // Returns whether an observation is due at a time, s, after the last one.
  bool is_due(double now, double last) const;
  // Returns the number of observations until a time, s.
  double count(double end) const;

 private:
  double shortest_ = 0.0;  // s; 0 = without a jet
};

}  // namespace kerf
