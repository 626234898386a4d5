// SPDX-License-Identifier: Apache-2.0
// Invalid symmetry planes and absorbing faces are refused.
#include "refuse/bad_case.hpp"

namespace kerf {
namespace {

// Half of a jet on a block on a plate; the symmetry plane is x = 0.
const std::string half_case = R"(title = "half"
dimension = 2
formulation = "standard"
gravity = ["0 m/s2", "-9.81 m/s2"]

[time]
end = "10 ms"

[domain]
minimum = ["0 mm", "-20 mm"]
maximum = ["100 mm", "100 mm"]
symmetry = ["x-"]

[[body]]
name = "block"
material = "tofu"
shape = { type = "box", minimum = ["-20 mm", "0 mm"], maximum = ["20 mm", "20 mm"] }
spacing = "1 mm"
absorbing = ["x+"]

[[body]]
name = "plate"
role = "rigid"
shape = { type = "box", minimum = ["-40 mm", "-4 mm"], maximum = ["40 mm", "0 mm"] }
spacing = "1 mm"

[[jet]]
name = "jet"
speed = "5 m/s"
width = "10 mm"
position = ["0 mm", "20 mm"]
standoff = "20 mm"
spacing = "1 mm"
)";

struct Change {
  std::string from, to;
  std::vector<std::string> contains;
};

std::string changed(const Change& change) {
  std::string text = half_case;
  const auto place = text.find(change.from);
  EXPECT_NE(place, std::string::npos) << change.from;
  if (place != std::string::npos) text.replace(place, change.from.size(), change.to);
  return text;
}

TEST(RefuseSymmetry, AcceptsTheHalfCase) {
  EXPECT_EQ(message_of(half_case), "(no error)");
}

// Ten coarsest cells of 4 mm reach from end to end, five on either side of the plane; then the
// plane is in the middle of a cell.
TEST(RefuseSymmetry, GradedBodiesHaveWholeCellsBesideAPlane) {
  const std::string grading = "\ngrading = { levels = 2, width = \"4 mm\" }\nabsorbing";
  EXPECT_EQ(message_of(changed({"\nabsorbing", grading, {}})), "(no error)");
  std::string text = changed({"\nabsorbing", grading, {}});
  const std::string from = "[\"-20 mm\", \"0 mm\"], maximum = [\"20 mm\"";
  ASSERT_NE(text.find(from), std::string::npos);
  text.replace(text.find(from), from.size(), "[\"-22 mm\", \"0 mm\"], maximum = [\"22 mm\"");
  const std::string message = message_of(text);
  for (const char* part :
       {"body[1].grading", "cuts cells of the coarsest spacing, 0.004 m", "a multiple of 0.004 m"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(RefuseSymmetry, AsymmetricCases) {
  const std::string planes = "symmetry = [\"x-\"]";
  const Change changes[] = {
      {"\"standard\"", "\"shinohara2004\"", {"domain.symmetry", "standard"}},
      {planes, "symmetry = [\"left\"]", {"domain.symmetry", "entry 1", "\"x-\"", "\"y+\""}},
      {planes, "symmetry = [\"z-\"]", {"domain.symmetry", "entry 1"}},
      {planes, "symmetry = \"x-\"", {"domain.symmetry"}},
      {planes, "symmetry = [\"y-\"]", {"domain.symmetry", "gravity acts across", "floor"}},
      {"maximum = [\"100 mm\", \"100 mm\"]\nsymmetry = [\"x-\"]",
       "maximum = [\"2 mm\", \"100 mm\"]\nsymmetry = [\"x-\", \"x+\"]",
       {"domain.symmetry", "images of images", "at least 0.0031 m apart"}},
      {"spacing = \"1 mm\"\nabsorbing",
       "spacing = \"1 mm\"\noffset = [\"0.4 mm\", \"0 mm\"]\nabsorbing",
       {"body[1].spacing", "lie on the symmetry plane \"x-\"", "offset"}},
      {"width = \"10 mm\"",
       "width = \"9 mm\"",
       {"jet[1].spacing", "middle column", "an even number fits", "0.0009 m"}},
      {"position = [\"0 mm\", \"20 mm\"]",
       "position = [\"2 mm\", \"20 mm\"]",
       {"jet[1].position", "beside its axis"}},
      {"standoff = \"20 mm\"",
       "standoff = \"20 mm\"\nangle = \"10 deg\"",
       {"jet[1].position", "beside its axis"}},
  };
  for (const Change& change : changes) {
    const std::string message = message_of(changed(change));
    for (const std::string& part : change.contains)
      EXPECT_NE(message.find(part), std::string::npos)
          << change.to << "\n  wanted " << part << "\n  got    " << message;
  }
}

TEST(RefuseAbsorbing, MissingSides) {
  const std::string faces = "absorbing = [\"x+\"]",
                    box =
                        "shape = { type = \"box\", minimum = "
                        "[\"-20 mm\", \"0 mm\"], maximum = [\"20 mm\", \"20 mm\"] }";
  const Change changes[] = {
      {faces, "absorbing = [\"x-\"]", {"body[1].absorbing", "lies in the symmetry plane"}},
      {faces, "absorbing = [\"z+\"]", {"body[1].absorbing", "entry 1"}},
      {box,
       "shape = { type = \"disc\", centre = [\"30 mm\", \"10 mm\"], radius = \"8 mm\" }",
       {"body[1].absorbing", "has no such faces"}},
      {"role = \"rigid\"", "role = \"rigid\"\nabsorbing = [\"x+\"]", {"body[2].absorbing"}},
  };
  for (const Change& change : changes) {
    const std::string message = message_of(changed(change));
    for (const std::string& part : change.contains)
      EXPECT_NE(message.find(part), std::string::npos)
          << change.to << "\n  wanted " << part << "\n  got    " << message;
  }
}

}  // namespace
}  // namespace kerf
