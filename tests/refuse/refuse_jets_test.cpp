// SPDX-License-Identifier: Apache-2.0
// What is wrong with pulses and with nozzles beside one another.
#include <fmt/format.h>

#include "refuse/bad_case.hpp"

namespace kerf {
namespace {

struct SecondJet {
  std::string position = "[\"0 mm\", \"20 mm\", \"0 mm\"]";
  std::string more = "";
};

// Two round jets of 6 mm onto a plate of 40 mm; the first travels where `first` says so.
std::string two_jets(const SecondJet& second, const std::string& first = "") {
  const auto jet = [](const std::string& name, const std::string& position,
                      const std::string& more) {
    return fmt::format(
        "[[jet]]\nname = \"{}\"\nspeed = \"10 m/s\"\ndiameter = \"6 mm\"\nspacing = \"1 mm\"\n"
        "standoff = \"8 mm\"\nposition = {}\n{}",
        name, position, more);
  };
  return "title = \"two\"\ndimension = 3\n[time]\nend = \"4 ms\"\n[domain]\n"
         "minimum = [\"-40 mm\", \"0 mm\", \"-40 mm\"]\nmaximum = [\"40 mm\", \"60 mm\", \"40 "
         "mm\"]\n"
         "[[body]]\nname = \"plate\"\nrole = \"rigid\"\nspacing = \"1 mm\"\nshape = { type = "
         "\"box\", minimum = [\"-20 mm\", \"16 mm\", \"-20 mm\"], maximum = [\"20 mm\", \"20 mm\", "
         "\"20 mm\"] }\n" +
         jet("a", "[\"0 mm\", \"20 mm\", \"0 mm\"]", first) +
         jet("b", second.position, second.more);
}

constexpr const char* overlaps = "the nozzle of \"b\" overlaps that of \"a\"";

void expect_overlap(const std::string& text, const std::string& when = "") {
  const std::string message = message_of(text);
  EXPECT_NE(message.find(overlaps + when), std::string::npos) << message;
  EXPECT_NE(message.find("jet[2].position = "), std::string::npos) << message;
  EXPECT_NE(message.find("Allowed: nozzles that are beside one another"), std::string::npos);
}

TEST(RefuseJets, OfNozzlesThatOverlap) {
  for (const char* x : {"0", "3", "-5"})
    for (const char* z : {"0", "2"})
      expect_overlap(two_jets({fmt::format("[\"{} mm\", \"20 mm\", \"{} mm\"]", x, z)}));
  // At an angle, from a nozzle that is in the other; the flow is at other times.
  expect_overlap(two_jets({"[\"0 mm\", \"20 mm\", \"0 mm\"]", "angle = \"10 deg\"\n"}));
  expect_overlap(
      two_jets({"[\"1 mm\", \"20 mm\", \"0 mm\"]", "start = \"2 ms\"\n"}, "stop = \"1 ms\"\n"));
}

TEST(RefuseJets, NotOfThoseBesideOneAnother) {
  for (const char* position :
       {"[\"6 mm\", \"20 mm\", \"0 mm\"]", "[\"-4.3 mm\", \"20 mm\", \"4.3 mm\"]"})
    EXPECT_EQ(message_of(two_jets({position})), "(no error)") << position;
  // Jets that meet in flight, from nozzles that are apart.
  const SecondJet aside{"[\"0 mm\", \"26 mm\", \"0 mm\"]", "angle = \"60 deg\"\n"};
  EXPECT_EQ(message_of(two_jets(aside)), "(no error)");
}

// A nozzle at 10 m/s reaches one that is 20 mm away, both 6 mm wide, after 1.4 ms.
TEST(RefuseJets, OfNozzlesThatMeetLater) {
  const SecondJet away{"[\"20 mm\", \"20 mm\", \"0 mm\"]"};
  EXPECT_EQ(message_of(two_jets(away)), "(no error)");
  expect_overlap(two_jets(away, "traverse = [\"10 m/s\", \"0 m/s\", \"0 m/s\"]\n"), " after 0.001");
  EXPECT_EQ(message_of(two_jets(away, "traverse = [\"0 m/s\", \"0 m/s\", \"10 m/s\"]\n")),
            "(no error)");
}

TEST(RefuseJets, OfPulsesThatNeverPause) {
  const auto with = [](const std::string& more) {
    return message_of(two_jets({"[\"8 mm\", \"20 mm\", \"0 mm\"]"}, more));
  };
  const std::string alone = with("pulse_frequency = \"1 kHz\"\n");
  EXPECT_NE(alone.find("jet[1].pulse_frequency = \"1 kHz\": without a duty below 1"),
            std::string::npos)
      << alone;
  EXPECT_NE(alone.find("such as duty = 0.5"), std::string::npos) << alone;
  EXPECT_EQ(with("pulse_frequency = \"1 kHz\"\nduty = 0.5\n"), "(no error)");
  EXPECT_EQ(with("pulse_frequency = \"0 Hz\"\n"), "(no error)");
}

// A question has its own mark.
TEST(RefuseJets, AQuestionEndsWithItsMark) {
  const std::string message =
      message_of(two_jets({"[\"8 mm\", \"20 mm\", \"0 mm\"]"}, "standof = \"1 mm\"\n"));
  EXPECT_NE(message.find("Did you mean \"standoff\"?"), std::string::npos) << message;
  EXPECT_EQ(message.find("?."), std::string::npos) << message;
}

}  // namespace
}  // namespace kerf
