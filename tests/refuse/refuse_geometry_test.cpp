// SPDX-License-Identifier: Apache-2.0
// Invalid shapes, inconsistent bodies and jets, and invalid expressions are refused.
#include "refuse/bad_case.hpp"

namespace kerf {
namespace {

const std::string block_shape =
    "{ type = \"box\", minimum = [\"-20 mm\", \"0 mm\"], maximum = [\"20 mm\", \"20 mm\"] }";

BadCase shape(const std::string& name, const std::string& text, const std::string& start,
              const std::vector<std::string>& contains) {
  return {name, block_shape, text, "material = \"tofu\"\nshape", "", [&] {
            std::vector<std::string> all = contains;
            all.push_back(start);
            return all;
          }()};
}

std::string polygon(const std::string& corners) {
  return "{ type = \"polygon\", vertices = [" + corners + "] }";
}

TEST(Refuse, Shapes) {
  for (const BadCase& bad : {
           shape("two corners", polygon("[\"0 m\", \"0 m\"], [\"1 m\", \"0 m\"]"),
                 "body[1].shape.vertices", {"there are 2 corners", "3 to 100000 corners"}),
           shape(
               "bow tie",
               polygon("[\"0 mm\", \"0 mm\"], [\"9 mm\", \"9 mm\"], [\"9 mm\", \"0 mm\"], "
                       "[\"0 mm\", \"9 mm\"]"),
               "body[1].shape.vertices",
               {"the outline crosses itself at (0.0045 m, 0.0045 m), where the edge from corner 1 "
                "to 2 meets that from corner 3 to 4"}),
           shape("flat",
                 polygon("[\"0 mm\", \"0 mm\"], [\"9 mm\", \"0 mm\"], [\"5 mm\", \"0 mm\"]"),
                 "body[1].shape.vertices", {"the outline is not a simple polygon"}),
           shape("a corner beyond all numbers of the test of outlines",
                 polygon("[\"5 mm\", \"0 mm\"], [\"20 mm\", \"15 mm\"], [\"20 mm\", \"70 mm\"], "
                         "[\"26 mm\", \"70 mm\"], [\"26 Ym\", \"-4 mm\"], [\"9 mm\", \"-4 mm\"]"),
                 "body[1].shape.vertices", {"corner 5: the value is out of range"}),
           shape("inside out",
                 "{ type = \"box\", minimum = [\"20 mm\", \"0 mm\"], maximum = [\"-20 mm\", \"9 "
                 "mm\"] }",
                 "body[1].shape.maximum", {"entry 1 is not greater than that of the minimum"}),
           shape("thin ring",
                 "{ type = \"ring\", centre = [\"0 m\", \"9 mm\"], radius = \"5 mm\", "
                 "inner_radius = \"5 mm\" }",
                 "body[1].shape.inner_radius = \"5 mm\": the ring has no thickness",
                 {"less than the radius"}),
           shape("sphere in 2D",
                 "{ type = \"sphere\", centre = [\"0 m\", \"9 mm\"], radius = \"5 mm\" }",
                 "body[1].shape.type = \"sphere\": a sphere needs a 3D case", {"Use a disc"}),
           shape("one part", "{ type = \"union\", parts = [" + block_shape + "] }",
                 "body[1].shape.parts", {"there are 1 shapes", "at least two shapes"}),
           shape("problem in a part",
                 "{ type = \"union\", parts = [" + block_shape + ", { type = \"blob\" }] }",
                 "body[1].shape.parts[2].type = \"blob\": the word is unknown", {"\"box\""}),
           shape("no particle",
                 "{ type = \"box\", minimum = [\"0 mm\", \"0 mm\"], maximum = [\"0.5 mm\", \"9 "
                 "mm\"] }",
                 "body[1].shape: no particle of the body \"block\" fits into it",
                 {"lattice point at 0.002 m", "smaller spacing"}),
           shape("nothing left",
                 "{ type = \"difference\", parts = [" + block_shape + ", " + block_shape + "] }",
                 "body[1].shape: no particle of the body", {}),
           shape("outside",
                 "{ type = \"box\", minimum = [\"0 mm\", \"90 mm\"], maximum = [\"9 mm\", \"110 "
                 "mm\"] }",
                 "body[1].shape: the body \"block\" reaches from (0 m, 0.09 m) to",
                 {"leaves the domain", "from (-0.1 m, -0.02 m) to (0.1 m, 0.1 m)", "enlarge"}),
           shape("overlap",
                 "{ type = \"box\", minimum = [\"-20 mm\", \"-2 mm\"], maximum = [\"20 mm\", \"20 "
                 "mm\"] }",
                 "the body \"plate\" overlaps the body \"block\", for example at",
                 {"body[2].shape", "bodies that touch at most", "difference"}),
       }) {
    const std::string message = message_of(changed_text(bad));
    for (const std::string& part : bad.contains)
      EXPECT_NE(message.find(part), std::string::npos)
          << bad.name << "\n  wanted " << part << "\n  got    " << message;
  }
}

TEST(Refuse, CountsAndDomain) {
  expect_refused({
      {"too many particles",
       "spacing = \"2 mm\"",
       "spacing = \"1 nm\"",
       "1 nm",
       "body[1].spacing = \"1 nm\": this makes 8e+14 particles.",
       {"at most 5e+08 particles"}},
      {"too much water",
       "spacing = \"1 mm\"",
       "spacing = \"0.1 um\"",
       "0.1 um",
       "jet[1].spacing = \"0.1 um\": this makes 5e+10 particles.",
       {"at most 5e+08 particles"}},
      {"empty domain",
       "maximum = [\"100 mm\", \"100 mm\"]",
       "maximum = [\"-100 mm\", \"100 mm\"]",
       "maximum = [\"-100",
       "domain.maximum",
       {"entry 1 is not greater"}},
      {"probe outside",
       "[[jet]]",
       "[[probe]]\nname = \"p\"\nposition = [\"1 m\", \"0 m\"]\n[[jet]]",
       "position = [\"1 m\"",
       "probe[1].position = [\"1 m\", \"0 m\"]: the probe is outside",
       {"Move the probe"}},
      {"normal of a point",
       "[[jet]]",
       "[[probe]]\nname = \"p\"\nposition = [\"0 m\", \"0 m\"]\nnormal = [0, 1]\n[[jet]]",
       "normal",
       "probe[1].normal = [0, 1]: the key has no meaning here.",
       {"plane"}},
      {"no direction",
       "[[jet]]",
       "[[probe]]\nname = \"p\"\nkind = \"plane\"\nposition = [\"0 m\", \"0 m\"]\n"
       "normal = [0, 0]\n[[jet]]",
       "normal",
       "probe[1].normal = [0, 0]: the normal has no direction.",
       {"any vector but zero"}},
  });
}

TEST(Refuse, Jets) {
  expect_refused({
      {"starts in the block",
       "position = [\"0 mm\", \"20 mm\"]",
       "position = [\"0 mm\", \"-10 mm\"]",
       "\"-10 mm\"",
       "jet[1].position = [\"0 mm\", \"-10 mm\"]: the jet starts inside the body",
       {"\"block\"", "lengthen its standoff"}},
      {"starts outside",
       "standoff = \"20 mm\"",
       "standoff = \"1 m\"",
       "position = [\"0 mm\", \"20",
       "jet[1].position = [\"0 mm\", \"20 mm\"]: the nozzle is outside the domain.",
       {"shorten its standoff"}},
      {"a jet with the name of a body",
       "name = \"jet\"",
       "name = \"plate\"",
       "name = \"plate\"\nspeed",
       "jet[1].name = \"plate\": the name is used already.",
       {"Choose another name"}},
      {"narrower than a particle",
       "width = \"10 mm\"",
       "width = \"0.5 mm\"",
       "spacing = \"1 mm\"",
       "jet[1].spacing = \"1 mm\": not one particle fits across the jet.",
       {"at most the width of the jet"}},
  });
}

TEST(Refuse, Expressions) {
  const auto velocity = [](const std::string& name, const std::string& formula,
                           const std::vector<std::string>& contains) {
    return BadCase{name,
                   block_material,
                   block_material + "\nvelocity_expression = [\"0\", \"" + formula + "\"]",
                   "velocity_expression",
                   "body[1].velocity_expression = [\"0\", \"" + formula,
                   contains};
  };
  expect_refused({
      velocity("unknown variable", "q + 1", {"x, y, z and pi", "\"q\""}),
      velocity("unknown function", "sine(x)", {"sine", "sin, cos"}),
      velocity("brackets", "(x", {"cannot be used"}),
      velocity("assignment", "x = 2", {"'=' assigns"}),
      velocity("two values", "1, 2", {"more than one value"}),
      velocity("empty", "", {"cannot be used"}),
      {"infinite",
       block_material,
       block_material + "\nvelocity_expression = [\"0\", \"1/0\"]",
       "[[body]]",
       "body = ",
       {"a body moves at inf m/s", "that are finite, up to 1e5 m/s"}},
      {"jump",
       block_material,
       block_material + "\ndisplacement_expression = [\"t\", \"1 + t\"]",
       "displacement",
       "body[1].displacement_expression = [\"t\", \"1 + t\"]: \"1 + t\" is 1 at",
       {"formulas that are 0 at t = 0"}},
      {"negative profile",
       speed,
       speed + "\nprofile_expression = \"0.5 - r\"",
       "profile",
       "jet[1].profile_expression = \"0.5 - r\": the profile is -",
       {"not negative"}},
      {"no profile",
       speed,
       speed + "\nprofile_expression = \"0\"",
       "profile",
       "jet[1].profile_expression = \"0\": the profile is 0 everywhere.",
       {}},
  });
}

TEST(Refuse, AVelocityOfABodyThatIsFixed) {
  expect_refused({
      {"fixed with a velocity",
       block_material,
       block_material + "\nfixed = true\nvelocity = [\"1 m/s\", \"0 m/s\"]",
       "fixed",
       "body[1].fixed = true: the body also has a velocity.",
       {"Remove one of the two"}},
  });
}

// The other sections are read to their end without the surface of the mesh.
TEST(Refuse, AMachineCaseWhoseMeshIsMissing) {
  const std::string message = message_of(
      "title = \"part\"\ndimension = 3\n[machine]\npressure = \"20 bar\"\norifice = \"1 mm\"\n"
      "position = [\"0 m\", \"9 mm\", \"0 m\"]\nstandoff = \"5 mm\"\n"
      "[[body]]\nname = \"part\"\nmaterial = \"tofu\"\nspacing = \"1 mm\"\n"
      "shape = { type = \"mesh\", file = \"missing.stl\", scale = \"1 mm\" }\n");
  EXPECT_NE(message.find("missing.stl"), std::string::npos) << message;
}

TEST(Refuse, UndeterminedSpeeds) {
  const std::string still =
      "title = \"still\"\ndimension = 2\n[time]\nend = \"1 s\"\n[[body]]\nname = \"pool\"\n"
      "material = \"water\"\nspacing = \"1 mm\"\n"
      "shape = { type = \"box\", minimum = [\"0 m\", \"0 m\"], maximum = [\"9 mm\", \"9 mm\"] }\n";
  const std::string message = message_of(still);
  EXPECT_NE(message.find("materials.water.sound_speed: no jet or body moves"), std::string::npos)
      << message;
  EXPECT_NE(message.find("[materials.water] with base = \"water\""), std::string::npos) << message;
}

}  // namespace
}  // namespace kerf
