// SPDX-License-Identifier: Apache-2.0
// A case whose jets meet no body says where their water passes.
#include "refuse/bad_case.hpp"

namespace kerf {
namespace {

// Two blocks with a gap from x = -10 to 20 mm.
std::string gap_case(const std::vector<std::string>& places, const std::string& angle = "0 deg") {
  const auto block = [](const std::string& name, const std::string& from, const std::string& to) {
    return "[[body]]\nname = \"" + name +
           "\"\nmaterial = \"tofu\"\nspacing = \"2 mm\"\nshape = { type = \"box\", minimum = [\"" +
           from + " mm\", \"-20 mm\"], maximum = [\"" + to + " mm\", \"0 mm\"] }\n";
  };
  std::string text =
      "title = \"aims\"\ndimension = 2\n[time]\nend = \"1 ms\"\n[domain]\nminimum = [\"-0.1 m\", "
      "\"-0.1 m\"]\nmaximum = [\"0.1 m\", \"0.1 m\"]\n" +
      block("left", "-50", "-10") + block("right", "20", "50");
  int number = 0;
  for (const std::string& place : places)
    text += "[[jet]]\nname = \"jet" + std::to_string(++number) +
            "\"\nspeed = \"5 m/s\"\nwidth = \"10 mm\"\nspacing = \"1 mm\"\nstandoff = \"20 mm\"\n" +
            "position = [\"" + place + "\", \"0 mm\"]\nangle = \"" + angle + "\"\n";
  return text;
}

TEST(RefuseAim, ThroughAGapOrBeside) {
  const std::string text = gap_case({"0 mm"});
  EXPECT_EQ(
      message_of(text),
      "bad.toml:" + std::to_string(line_with(text, "position")) +
          ": jet[1].position = [\"0 mm\", \"0 mm\"]: the jet passes beside every body: its "
          "water is 0.005 m from the nearest, \"left\". Allowed: a position and an angle whose "
          "line meets a body. Aim the jet at the workpiece: angle 0 is straight down.");
  EXPECT_NE(message_of(gap_case({"58 mm"})).find("is 0.003 m from the nearest, \"right\""),
            std::string::npos);
  EXPECT_NE(message_of(gap_case({"80 mm"}, "90 deg")).find("the jet points away from every body"),
            std::string::npos);
}

// A jet that aims at a block meets it, however far the domain reaches beyond.
TEST(RefuseAim, NoJetThatAimsAtABodyInALargeDomain) {
  for (const std::string size : {"0.1 m", "1e5 m"}) {
    std::string text = gap_case({"30 mm"});
    for (const std::string sign : {"-", ""}) {
      const std::string corner = "[\"" + sign + "0.1 m\"";
      text.replace(text.find(corner), corner.size(), "[\"" + sign + size + "\"");
    }
    EXPECT_EQ(message_of(text), "(no error)") << size;
  }
}

// A jet of 1000 km has one particle each 100 km, by default: its breadth is at fault.
TEST(RefuseAim, OfAJetBetweenWhoseParticlesTheBodiesLie) {
  std::string text = gap_case({"30 mm"});
  text.replace(text.find("width = \"10 mm\"\nspacing = \"1 mm\""), 32, "width = \"1e6 m\"");
  const auto domain = text.find("[domain]");
  text.erase(domain, text.find("[[body]]") - domain);
  const std::string message = message_of(text);
  EXPECT_NE(message.find(": jet[1].width = \"1e6 m\": the bodies lie between the particles"),
            std::string::npos)
      << message;
  EXPECT_EQ(message.find("position"), std::string::npos) << message;
}

// Beyond a symmetry plane the nozzle has no water: it does not travel, and no end would help.
TEST(RefuseAim, FromBeyondASymmetryPlane) {
  std::string text = gap_case({"30 mm"}, "45 deg");
  const std::string domain = "minimum = [\"-0.1 m\", \"-0.1 m\"]";
  text.replace(text.find(domain), domain.size(),
               "symmetry = [\"x-\"]\nminimum = [\"20 mm\", \"-0.1 m\"]");
  const auto left = text.find("[[body]]");
  text.erase(left, text.find("[[body]]", left + 1) - left);
  int refused = 0;
  for (const char* angle : {"45 deg", "-45 deg"}) {
    std::string leaning = text;
    leaning.replace(leaning.find("45 deg"), 6, angle);
    const std::string place = "position = [\"30 mm\"";
    leaning.replace(leaning.find(place), place.size(), "position = [\"20 mm\"");
    const std::string message = message_of(leaning);
    EXPECT_EQ(message.find("traverse"), std::string::npos) << message;
    if (message == "(no error)") continue;
    ++refused;
    EXPECT_NE(message.find("jet[1].position = [\"20 mm\", \"0 mm\"]: the nozzle is outside the "
                           "domain"),
              std::string::npos)
        << message;
  }
  EXPECT_EQ(refused, 1);
}

TEST(RefuseAim, OfAllJets) {
  EXPECT_EQ(message_of(gap_case({"80 mm", "30 mm"})), "(no error)");
  EXPECT_EQ(message_of(gap_case({"30 mm", "80 mm"})), "(no error)");
  const std::string both = message_of(gap_case({"80 mm", "0 mm"}));
  EXPECT_NE(both.find("jet[1].position = [\"80 mm\", \"0 mm\"]: the jet passes beside"),
            std::string::npos);
  EXPECT_NE(both.find("jet[2].position = [\"0 mm\", \"0 mm\"]: the jet passes beside"),
            std::string::npos);
}

// A jet between two walls meets none of them, but flows along them: whether its edge touches a
// wall, is beside it by less than a spacing, or its outermost particles alone are beside it.
TEST(RefuseAim, NoJetThatFlowsAlongAWall) {
  const auto channel = [](const std::string& gap, const std::string& angle) {
    std::string text = gap_case({"0 mm"}, angle);
    for (const auto& [from, to] : {std::pair<std::string, std::string>{"\"-10 mm\"", "\"-" + gap},
                                   std::pair<std::string, std::string>{"\"20 mm\"", "\"" + gap}})
      text.replace(text.find(from), from.size(), to + " mm\"");
    return message_of(text);
  };
  for (const char* gap : {"4.7", "5", "5.000000000000001", "6.9"})
    EXPECT_EQ(channel(gap, "0 deg"), "(no error)") << gap;
  EXPECT_NE(channel("7.1", "0 deg").find("its water is 0.0021 m from the nearest"),
            std::string::npos);
}

// A round jet through a round hole that is wider by 1 mm on every side.
TEST(RefuseAim, ThroughAHole) {
  const std::string text =
      "title = \"hole\"\ndimension = 3\n[time]\nend = \"1 ms\"\n[domain]\nminimum = [\"-30 mm\", "
      "\"-30 mm\", \"-30 mm\"]\nmaximum = [\"30 mm\", \"30 mm\", \"30 mm\"]\n"
      "[[body]]\nname = \"plate\"\nmaterial = \"tofu\"\nspacing = \"0.8 mm\"\nshape = { type = "
      "\"difference\", parts = [{ type = \"box\", minimum = [\"-12 mm\", \"-4 mm\", \"-12 mm\"], "
      "maximum = [\"12 mm\", \"0 mm\", \"12 mm\"] }, { type = \"disc\", centre = [\"0 mm\", \"-5 "
      "mm\", "
      "\"0 mm\"], axis = [0, 1, 0], length = \"6 mm\", radius = \"3 mm\" }] }\n"
      "[[jet]]\nname = \"jet\"\nspeed = \"1 m/s\"\ndiameter = \"4 mm\"\nspacing = \"0.8 mm\"\n"
      "standoff = \"6 mm\"\nposition = [\"0 mm\", \"0 mm\", \"0 mm\"]\n";
  EXPECT_NE(message_of(text).find("its water is 0.001 m from the nearest, \"plate\""),
            std::string::npos)
      << message_of(text);
}

}  // namespace
}  // namespace kerf
