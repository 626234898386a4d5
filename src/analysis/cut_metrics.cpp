// SPDX-License-Identifier: Apache-2.0
// The metrics of a cut: at an instant, over the run so far, and of a fragment.
#include <cmath>

#include "analysis/cut.hpp"

namespace kerf {

const MetricList<CutState>& CutState::metrics() {
  static const MetricList<CutState> list{
      {"front_depth", "m", "depth of the water front",
       "Depth of the water front below the point aimed at, along the jet.", &CutState::front_depth},
      {"cut_depth", "m", "depth of the cut",
       "Greatest depth below the face so far to which solid is removed, detached or torn all along "
       "a path from the face; 0 for a dent.",
       &CutState::cut_depth},
      {"fractured_mass", extensive("kg"), "fractured mass",
       "Mass of the workpiece that is fractured or has left the domain.",
       &CutState::fractured_mass},
      {"fractured_fraction", share(), "fractured share of the workpiece",
       "Fractured mass over the mass of the workpiece at the start.",
       &CutState::fractured_fraction},
      {"fractured_width", "m", "width of the fractured region",
       "Width of the fractured region at half the depth of the water front, at most of the "
       "thickness, in the sections of the width of the opening.",
       &CutState::fractured_width},
      {"kerf_width", "m", "width of the opening",
       "Width free of intact solid around the axis at half the depth of the water front, at most "
       "of the thickness. In 3D it is that across the path of a nozzle that travels, that along "
       "the path for which a nozzle stands, or else the mean over the directions across the jet.",
       &CutState::kerf_width},
      {"pieces", "1", "pieces over 5 % of the workpiece",
       "Number of pieces that unbroken bonds hold together and that weigh more than 5 % of the "
       "workpiece.",
       &CutState::pieces},
      {"cut_through", "1", "cut through",
       "Whether every body in the way of the jet has been cut through.", &CutState::cut_through}};
  return list;
}

std::string kind_of_cut(bool is_severed, bool is_punched) {
  return is_punched ? "punched" : is_severed ? "severed" : "holed";
}

namespace {

// Returns a time that may be nan for what has not happened.
std::optional<double> known(double time) {
  return std::isnan(time) ? std::nullopt : std::optional(time);
}

}  // namespace

const MetricList<CutSummary>& CutSummary::metrics() {
  using S = CutSummary;
  static const MetricList<S> list{
      {"cut_through_time", "s", "time to cut through",
       "Time at which the workpiece was first found cut through.",
       [](const S& s) { return s.cut_through ? std::optional(s.cut_through_time) : std::nullopt; }},
      {"cut_through_by", "1", "kind of the cut",
       "`severed` where no piece joins the sides of the jet in any body in its way, `punched` "
       "where "
       "of each a plug is apart from its rim, else `holed`.",
       [](const S& s) {
         return s.cut_through ? std::optional(kind_of_cut(s.severed, s.punched)) : std::nullopt;
       }},
      {"cut_through_place", "m", "position of the front at the cut",
       "Position of the water front on the axis of the jet that cut when the workpiece was cut "
       "through.",
       [](const S& s) {
         return s.cut_through ? std::optional(s.cut_through_place) : std::nullopt;
       }},
      {"cut_by_other_jet", "1", "cut by another jet than the first",
       "Whether what is cut or broken is the work of other jets: the way of another was cut, or "
       "the first had met no solid by then.",
       &S::is_of_other_jet},
      {"front_share_at_cut", "1", "depth of the front at the cut over the thickness",
       "Depth of the front of the jet that cut when the workpiece was cut through, over the depth "
       "at which its axis leaves the workpiece as laid out.",
       [](const S& s) {
         return s.cut_through ? std::optional(s.front_share_at_cut) : std::nullopt;
       }},
      {"cracked_ahead", "1", "cut through by a crack ahead of the water",
       "Whether the front of the water had passed less than half of the thickness when the "
       "workpiece was cut through.",
       [](const S& s) { return s.cracked_ahead(); }},
      {"removed_share_at_cut", "1", "removed share of the opening at the cut",
       "Width of the fractured region over that of the opening, without voids of the layout, when "
       "the workpiece was cut through; the rest is pushed aside.",
       [](const S& s) {
         return s.cut_through ? std::optional(s.removed_share_at_cut) : std::nullopt;
       }},
      {"gave_way", "1", "gave way to the jet",
       "Whether, when the workpiece was cut through, the front of the water was below the far face "
       "as laid out by more than half the width of the jet, or half the thickness where that is "
       "less, or less than half of the opening was removed: the jet had pressed it ahead or aside. "
       "Of a workpiece that is not cut through: whether the front is below that face at the end, "
       "or less than half of the opening is removed.",
       [](const S& s) { return s.gave_way(); }},
      {"water_through_time", "s", "time at which the water is through",
       "First time, from the cut on, at which the water front is within one spacing of the far "
       "face "
       "as laid out.",
       [](const S& s) { return known(s.water_through_time); }},
      {"front_speed", "m/s", "speed of the water front",
       "Least-squares slope of the front depth over time, from contact to the far face.",
       &S::front_speed},
      {"fragment_count", "1", "connected pieces of any size",
       "Number of connected pieces of intact solid of any size at the end.",
       [](const S& s) { return s.fragments.size(); }}};
  return list;
}

const MetricList<Fragment>& Fragment::metrics() {
  static const MetricList<Fragment> list{
      {"mass", extensive("kg"), "mass of the fragment", "Mass of the fragment.", &Fragment::mass},
      {"particles", "1", "particles of the fragment", "Number of its particles.",
       &Fragment::particles},
      {"centre", "m", "centre of the fragment", "Position of its centre of mass.",
       &Fragment::centre},
      {"velocity", "m/s", "velocity of the fragment", "Velocity of its centre of mass.",
       &Fragment::velocity}};
  return list;
}

}  // namespace kerf
