// SPDX-License-Identifier: Apache-2.0
// Bodies are joined where bonds reach from one to the other.
#include "refuse/bad_case.hpp"

namespace kerf {
namespace {

std::string start_of(int dimension) {
  return "title = \"joints\"\ndimension = " + std::to_string(dimension) +
         "\n[time]\nend = \"1 ms\"\n[domain]\nminimum = " +
         (dimension == 2
              ? "[\"-1 m\", \"-1 m\"]\nmaximum = [\"1 m\", \"1 m\"]\n"
              : "[\"-1 m\", \"-1 m\", \"-1 m\"]\nmaximum = [\"1 m\", \"1 m\", \"1 m\"]\n");
}

std::string body(const std::string& name, const std::string& shape, const std::string& keys = "") {
  return "[[body]]\nname = \"" + name + "\"\nmaterial = \"tofu\"\nspacing = \"2 mm\"\n" + keys +
         "shape = { " + shape + " }\n";
}

std::string box(const std::string& low, const std::string& high) {
  return "type = \"box\", minimum = [\"0 mm\", \"" + low + " mm\"], maximum = [\"20 mm\", \"" +
         high + " mm\"]";
}

std::string sphere(const std::string& x) {
  return "type = \"sphere\", radius = \"10 mm\", centre = [\"" + x + " mm\", \"0 mm\", \"0 mm\"]";
}

const std::string joined = "joined_to = \"base\"\n";

// Particles of 2 mm have bonds of up to 2 x 1.3 spacings, 5.2 mm: a gap of 2 mm, with particles 4
// mm apart, is one piece, and one of 4 mm is not.
TEST(RefuseJoints, OfBodiesApart) {
  const std::string base = start_of(2) + body("base", box("-20", "0"));
  for (const char* low : {"0", "2"})
    EXPECT_EQ(message_of(base + body("x", box(low, "30"), joined)), "(no error)") << low;
  for (const char* low : {"4", "24"}) {
    const std::string text = base + body("x", box(low, "30"), joined);
    const std::string apart = low == std::string("4") ? "0.006" : "0.026";
    EXPECT_EQ(message_of(text),
              "bad.toml:" + std::to_string(line_with(text, "joined_to")) +
                  ": body[2].joined_to = \"base\": no bond joins \"x\" to \"base\": their nearest "
                  "particles are about " +
                  apart +
                  " m apart. Allowed: bodies whose nearest particles are less than 0.0052 m apart, "
                  "such as ones that touch. Move the body to the face of the other, or remove the "
                  "key.");
  }
}

// A third body of the piece joins two that do not touch.
TEST(RefuseJoints, NotThroughAnother) {
  const std::string text = start_of(2) + body("base", box("-20", "0")) +
                           body("x", box("10", "30"), joined) + body("between", box("0", "10"));
  EXPECT_NE(message_of(text).find("no bond joins \"x\""), std::string::npos);
  EXPECT_EQ(
      message_of(start_of(2) + body("base", box("-20", "0")) + body("x", box("10", "30"), joined) +
                 body("between", box("0", "10"), joined)),
      "(no error)");
}

// The boxes around the shapes overlap where the bodies are far apart.
TEST(RefuseJoints, OfAnyShape) {
  const std::string corner =
      "type = \"polygon\", vertices = [[\"0 mm\", \"0 mm\"], [\"80 mm\", \"0 mm\"], [\"80 mm\", "
      "\"10 "
      "mm\"], [\"10 mm\", \"10 mm\"], [\"10 mm\", \"80 mm\"], [\"0 mm\", \"80 mm\"]]";
  const auto disc = [](const char* x) {
    return std::string("type = \"disc\", radius = \"10 mm\", centre = [\"") + x +
           " mm\", \"40 mm\"]";
  };
  const std::string base = start_of(2) + body("base", corner);
  EXPECT_EQ(message_of(base + body("x", disc("20"), joined)), "(no error)");
  EXPECT_NE(message_of(base + body("x", disc("50"), joined)).find("about 0.02"), std::string::npos);
  const std::string round = start_of(3) + body("base", sphere("0"));
  EXPECT_EQ(message_of(round + body("x", sphere("20"), joined)), "(no error)");
  EXPECT_NE(message_of(round + body("x", sphere("30"), joined)).find("no bond joins"),
            std::string::npos);
}

}  // namespace
}  // namespace kerf
