// SPDX-License-Identifier: Apache-2.0
#include "output/piece_reasons.hpp"

#include <fmt/format.h>

#include <cmath>

#include "machine/simulated_piece.hpp"
#include "machine/travelling_frame.hpp"
#include "model/case.hpp"
#include "model/face_names.hpp"
#include "output/readable.hpp"

namespace kerf {

namespace {

std::string extent_text(const Point& low, const Point& high, int dimension) {
  std::vector<std::string> lengths;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    lengths.push_back(readable(high[a] - low[a], "m"));
  return fmt::format("{}", fmt::join(lengths, " x "));
}

std::string part_sentence(const Case& description) {
  const WorkpieceSetting& workpiece = *description.workpiece;
  const int dimension = description.dimension;
  std::string text =
      fmt::format("{} of the workpiece of {} are simulated",
                  extent_text(workpiece.part.minimum, workpiece.part.maximum, dimension),
                  extent_text({}, workpiece.size, dimension));
  const auto names = names_of(continued_faces(workpiece, description.symmetry, dimension));
  if (!names.empty())
    text += fmt::format("; the workpiece continues beyond {}, which absorb waves",
                        fmt::join(names, ", "));
  return text + ".";
}

std::string depth_sentence(const Case& description) {
  const WorkpieceSetting& workpiece = *description.workpiece;
  const double below = thickness_below(workpiece);
  return below > 0.0 ? fmt::format(
                           "The upper {} of the thickness are simulated, and the run ends as the "
                           "front comes within {} of their end; the law of its depth is carried on "
                           "through the other {}.",
                           readable(workpiece.depth, "m"),
                           readable(bottom_margin * description.jets.back().width, "m"),
                           readable(below, "m"))
                     : std::string();
}

std::string symmetry_sentence(const Case& description) {
  const auto names = names_of(description.symmetry);
  return names.empty()
             ? std::string()
             : fmt::format(
                   "{} {} in the axis of the jet, about which all is symmetric: {} of the "
                   "problem is simulated.",
                   fmt::join(names, " and "),
                   names.size() == 1 ? "is a symmetry plane" : "are symmetry planes",
                   names.size() == 1 ? "half" : "a quarter");
}

std::string resolution_sentence(const WorkpieceSetting& workpiece) {
  if (workpiece.levels == 0)
    return fmt::format("The spacing is {} everywhere.", readable(workpiece.spacing, "m"));
  return fmt::format("The spacing is {} within {} of the jet and {} far from it.",
                     readable(workpiece.spacing, "m"), readable(workpiece.grading_width, "m"),
                     readable(std::ldexp(workpiece.spacing, workpiece.levels), "m"));
}

std::string motion_sentence(const Case& description) {
  const Machine& machine = *description.machine;
  if (machine.traverse_speed == 0.0) return "";
  const std::string feed = readable(machine.traverse_speed, "m/s");
  if (const auto frame = travelling_frame(description))
    return fmt::format(
        "The nozzle moves at {}; the window follows it by {} at a time, up to {} times: solid is "
        "fed in ahead and left behind.{}",
        feed, readable(frame->shift, "m"), frame->most,
        description.time.stop == RunStop::stationary ? " The run ends once the cut is stationary."
                                                     : "");
  if (machine.motion == NozzleMotion::travelling)
    return fmt::format("The nozzle moves at {} in the run.", feed);
  const Jet& jet = description.jets.back();
  const std::string rest = fmt::format(
      "The nozzle stands still in the run, in which it would move by {:.2g} widths of its jet",
      description.time.end / exposure_time(machine, jet, description.dimension));
  if (machine.is_pulsed())
    return fmt::format(
        "{}. The pauses of its jet leave gaps on the path of one that moves: no depth is carried "
        "to "
        "a feed of {}; motion = \"travelling\" simulates it.",
        rest, feed);
  return fmt::format("{}; a feed of {} exposes each point for {}, to which the depth is carried.",
                     rest, feed, readable(exposure_time(machine, jet, description.dimension), "s"));
}

}  // namespace

std::vector<std::string> piece_reasons(const Case& description) {
  std::vector<std::string> sentences;
  if (!description.workpiece) return sentences;
  const auto add = [&](const std::string& sentence) {
    if (!sentence.empty()) sentences.push_back(sentence);
  };
  add(part_sentence(description));
  add(depth_sentence(description));
  add(symmetry_sentence(description));
  add(resolution_sentence(*description.workpiece));
  add(motion_sentence(description));
  return sentences;
}

}  // namespace kerf
