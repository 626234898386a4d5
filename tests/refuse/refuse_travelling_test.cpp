// SPDX-License-Identifier: Apache-2.0
// Messages for what a frame that travels with the nozzle cannot have: file, key, value, allowed
// range and remedy.
#include "refuse/bad_case.hpp"
#include "support/travelling.hpp"

namespace kerf {
namespace {

struct TravellingRefusal {
  test::TravellingText text;
  std::vector<std::string> contains;
};

TravellingRefusal refusal(std::string test::TravellingText::*part, const std::string& written,
                          std::vector<std::string> contains) {
  TravellingRefusal bad;
  bad.text.*part = written;
  bad.contains = std::move(contains);
  return bad;
}

TEST(RefuseTravelling, NamesKeyRangeAndRemedy) {
  using Text = test::TravellingText;
  const std::string frame = "frame = \"travelling\"\n";
  std::vector<TravellingRefusal> table{
      refusal(&Text::machine, "traverse_speed = \"10 m/s\"\nmotion = \"standing\"",
              {"machine.motion", "\"travelling\" or \"auto\"", "workpiece.frame"}),
      refusal(&Text::machine, "", {"machine.traverse_speed", "greater than 0 m/s", "feed"}),
      refusal(&Text::frame, frame + "shift = \"4.5 mm\"",
              {"workpiece.shift", "whole coarsest cells of 0.001 m",
               "no more than the window of 0.04 m"}),
      refusal(&Text::frame, frame + "shift = \"41 mm\"", {"workpiece.shift", "0.041 m"}),
      refusal(&Text::frame, frame + "levels = 1",
              {"workpiece.levels", "0 where a 2D frame", "Remove"}),
      refusal(&Text::frame, "frame = \"fixed\"\nshift = \"5 mm\"",
              {"workpiece.shift", "only where this holds: travelling"}),
      refusal(&Text::time, "end = \"1 s\"",
              {"time.end", "at most 0.0285 s", "enlarge the workpiece"}),
      refusal(&Text::time, "relax = \"1 ms\"", {"time.relax", "0 s where", "Remove"}),
      refusal(&Text::rest,
              "[[jet]]\nname = \"other\"\nspeed = \"5 m/s\"\nwidth = \"4 mm\"\nposition = [\"0 "
              "m\", \"0 m\"]\nstandoff = \"5 mm\"\n",
              {"jet", "none where workpiece.frame"}),
      refusal(&Text::rest, "[[body]]\nname = \"table\"\n",
              {"body", "only its own solid is fed in"}),
      refusal(&Text::rest, "[[load]]\nname = \"weight\"\n", {"load", "none where workpiece.frame"}),
      refusal(&Text::rest,
              "[domain]\nminimum = [\"-120 mm\", \"-20 mm\"]\nmaximum = [\"-70 mm\", \"10 mm\"]\n"
              "symmetry = [\"x-\"]",
              {"domain.symmetry", "planes along the path", "Remove the plane"}),
      refusal(&Text::frame, "", {}),
  };
  table.back().text.low = -120.5e-3;
  table.back().text.frame = frame;
  table.back().contains = {"workpiece.maximum", "the window is 0.0405 m",
                           "whole coarsest cells of 0.001 m"};
  for (const TravellingRefusal& bad : table) {
    const std::string message = message_of(bad.text.text());
    EXPECT_EQ(message.find("bad.toml:"), 0u) << message;
    for (const std::string& part : bad.contains)
      EXPECT_NE(message.find(part), std::string::npos)
          << "wanted " << part << "\n  got " << message;
  }
}

TEST(RefuseTravelling, NeedsRoomAndATravellingFrame) {
  test::TravellingText text;
  text.low = 158e-3;
  text.high = 198e-3;
  EXPECT_NE(message_of(text.text()).find("ahead of the window there is no room for a shift"),
            std::string::npos);
  text = {};
  text.frame = "frame = \"fixed\"";
  text.time = "stop = \"stationary\"";
  EXPECT_NE(message_of(text.text()).find("no frame travels"), std::string::npos);
  // A frame that travels, over a workpiece that another error takes away.
  text.frame = test::TravellingText().frame;
  std::string wrong = text.text();
  const std::size_t at = wrong.find("position = [");
  wrong.replace(at, wrong.find('\n', at) - at, "position = [\"0 mm\", \"16 mm\"]");
  const std::string message = message_of(wrong);
  EXPECT_NE(message.find("machine.position"), std::string::npos) << message;
  EXPECT_EQ(message.find("no frame travels"), std::string::npos) << message;
  test::TravellingText space;
  space.dimension = 3;
  space.machine = "traverse_speed = \"10 m/s\"\ntraverse_direction = [1, 0, 1]";
  EXPECT_NE(message_of(space.text()).find("along x or z"), std::string::npos);
}

}  // namespace
}  // namespace kerf
