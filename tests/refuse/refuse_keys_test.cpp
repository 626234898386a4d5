// SPDX-License-Identifier: Apache-2.0
// Unknown, missing, inapplicable and contradictory keys are refused.
#include "refuse/bad_case.hpp"

namespace kerf {
namespace {

// budget: function: a table of cases reads best in one place
TEST(Refuse, UnknownKeys) {
  expect_refused({
      {"misspelt key",
       speed,
       "sped = \"5 m/s\"",
       "sped",
       "jet[1].sped = \"5 m/s\": the key is unknown.",
       {"Did you mean \"speed\"?"}},
      {"swapped letters",
       "standoff",
       "standfof",
       "standfof",
       "jet[1].standfof = \"20 mm\": the key is unknown.",
       {"Did you mean \"standoff\"?"}},
      {"misspelt table",
       "[time]",
       "[tiem]",
       "[tiem]",
       "tiem = { ... }: the key is unknown.",
       {"Did you mean \"time\"?"}},
      {"nothing like it",
       "dimension = 2",
       "dimension = 2\nzzzzzzzz = 1",
       "zzzz",
       "zzzzzzzz = 1: the key is unknown.",
       {"Remove it", "title, dimension"}},
      {"of a shape",
       "minimum = [\"-20 mm\"",
       "minimal = [\"-20 mm\"",
       "minimal",
       "body[1].shape.minimal",
       {"the key is unknown", "Did you mean \"minimum\"?"}},
      {"key of another shape",
       "type = \"box\", minimum = [\"-20 mm\", \"0 mm\"],",
       "type = \"box\", radius = \"1 m\", minimum = [\"-20 mm\", \"0 mm\"],",
       "radius",
       "body[1].shape.radius = \"1 m\": the key has no meaning here.",
       {"only where this holds: disc or ring or sphere"}},
      {"material of a rigid body",
       "role = \"rigid\"",
       "role = \"rigid\"\nmaterial = \"tofu\"",
       "material = \"tofu\"\nshape = { type = \"box\", minimum = [\"-40",
       "body[2].material = \"tofu\": the key has no meaning here.",
       {"elastic or water"}},
      {"repulsion of a soft body",
       block_material,
       block_material + "\nrepulsion = \"1 m2/s2\"",
       "repulsion",
       "body[1].repulsion = \"1 m2/s2\": the key has no meaning here.",
       {"only where this holds: rigid", "Remove it."}},
      {"jitter in the paper's formulation",
       block_material,
       block_material + "\njitter = 0.2",
       "jitter",
       "body[1].jitter = 0.2: the key has no meaning here.",
       {"Remove it"}},
      {"viscosity of a solid",
       "poisson_ratio = 0.4",
       "poisson_ratio = 0.4\nviscosity = \"1 Pa s\"",
       "viscosity",
       "materials.gel.viscosity = \"1 Pa s\": the key has no meaning here.",
       {"only where this holds: water"}},
      {"diameter in 2D",
       "width = \"10 mm\"",
       "diameter = \"10 mm\"",
       "diameter",
       "jet[1].diameter = \"10 mm\": the key has no meaning here.",
       {"only where this holds: 3D", "a jet in 2D is a slot and has a width"}},
      {"azimuth in 2D",
       speed,
       speed + "\nazimuth = \"10 deg\"",
       "azimuth",
       "jet[1].azimuth = \"10 deg\": the key has no meaning here.",
       {"3D"}},
  });
}

TEST(Refuse, MissingKeys) {
  expect_refused({
      {"speed",
       speed + "\n",
       "",
       "[[jet]]",
       "jet[1].speed: the key is missing.",
       {"Allowed: a speed", "Add it: Mean speed over the section"}},
      {"width", "width = \"10 mm\"\n", "", "[[jet]]", "jet[1].width: the key is missing.", {}},
      {"dimension",
       "dimension = 2\n",
       "",
       "title",
       "dimension: the key is missing.",
       {"2 = plane strain"}},
      {"end", "end = \"10 ms\"\n", "", "[time]", "time.end: the key is missing.", {}},
      {"material",
       block_material + "\n",
       "",
       "[[body]]",
       "body[1].material: the key is missing.",
       {}},
      {"kind",
       "kind = \"elastic\"\n",
       "",
       "[materials.gel]",
       "materials.gel.kind: the key is missing.",
       {"name a base of the library"}},
      {"modulus",
       "youngs_modulus = \"60 kPa\"\n",
       "",
       "[materials.gel]",
       "materials.gel.youngs_modulus: the key is missing.",
       {"a pressure"}},
      {"corner",
       "minimum = [\"-20 mm\", \"0 mm\"], ",
       "",
       "[\"20 mm\", \"20 mm\"]",
       "body[1].shape.minimum: the key is missing.",
       {"Lowest corner"}},
  });
}

TEST(Refuse, References) {
  expect_refused({
      {"unknown material",
       block_material,
       "material = \"toffu\"",
       "toffu",
       "body[1].material = \"toffu\": there is no such material.",
       {"Allowed: agar, aluminium-6061, apple", "tofu, trabecular-bone, water, gel",
        "Did you mean \"tofu\"?"}},
      {"unknown base",
       "poisson_ratio = 0.4",
       "poisson_ratio = 0.4\nbase = \"rubbr\"",
       "rubbr",
       "materials.gel.base = \"rubbr\": there is no such material.",
       {"Did you mean \"rubber\"?"}},
      {"kind against the base",
       "poisson_ratio = 0.4",
       "poisson_ratio = 0.4\nbase = \"water\"",
       "kind",
       "materials.gel.kind = \"elastic\": the base is of the kind \"water\".",
       {}},
      {"jet of a solid",
       speed,
       speed + "\nmaterial = \"tofu\"",
       "material = \"tofu\"\nwidth",
       "jet[1].material = \"tofu\": a jet is of water",
       {"a material of the kind \"water\""}},
      {"role against the material",
       block_material,
       block_material + "\nrole = \"water\"",
       "role = \"water\"",
       "body[1].role = \"water\": the material \"tofu\" is elastic.",
       {"\"elastic\" or \"rigid\""}},
      {"joined to nobody",
       block_material,
       block_material + "\njoined_to = \"wall\"",
       "joined_to",
       "body[1].joined_to = \"wall\": this is not another elastic body.",
       {}},
      {"joined to itself",
       block_material,
       block_material + "\njoined_to = \"block\"",
       "joined_to",
       "body[1].joined_to = \"block\": this is not another elastic body.",
       {}},
      {"two of a name",
       "name = \"plate\"",
       "name = \"block\"",
       "name = \"block\"\nrole",
       "body[2].name = \"block\": the name is used already.",
       {"Choose another name"}},
      {"back of a 2D plate",
       "role = \"rigid\"",
       "role = \"rigid\"\nrepelling_layer = \"back\"",
       "back",
       "body[2].repelling_layer = \"back\": a 2D body has no such side.",
       {"\"left\""}},
  });
}

TEST(Refuse, Contradictions) {
  const std::string both =
      "velocity = [\"0 m/s\", \"0 m/s\"]\nvelocity_expression = [\"x\", \"y\"]";
  expect_refused({
      {"velocity twice",
       block_material,
       block_material + "\n" + both,
       "velocity_expression",
       "body[1].velocity_expression = [\"x\", \"y\"]: the velocity is given as numbers as well.",
       {"Remove one of the two"}},
      {"profile twice",
       speed,
       speed + "\nprofile = \"power\"\nprofile_expression = \"1\"",
       "profile_expression",
       "jet[1].profile_expression = \"1\": the profile is named as well.",
       {}},
      {"frames twice",
       "end = \"10 ms\"",
       "end = \"10 ms\"\n[output]\nframe_interval = \"1 ms\"\nframe_times = [\"1 ms\"]",
       "frame_times",
       "output.frame_times = [\"1 ms\"]: an interval is given as well.",
       {}},
      {"sound twice",
       "[materials.gel]",
       "[materials.juice]\nbase = \"water\"\nsound_speed = \"9 m/s\"\nsound_speed_factor = 9\n"
       "[materials.gel]",
       "sound_speed_factor",
       "materials.juice.sound_speed_factor = 9: the sound speed itself is given as well.",
       {}},
      {"energy of cracks in the paper's formulation",
       "[materials.gel]",
       "[materials.curd]\nbase = \"tofu\"\nfracture_energy = \"2 J/m2\"\n[materials.gel]",
       "fracture_energy",
       "materials.curd.fracture_energy = \"2 J/m2\": this formulation breaks particles at a "
       "strain.",
       {"formulation = \"standard\""}},
      {"fracture twice",
       paper,
       "formulation = \"standard\"\n[materials.curd]\nbase = \"tofu\"\n"
       "failure_strain = 0.2\nfracture_energy = \"2 J/m2\"",
       "fracture_energy",
       "materials.curd.fracture_energy = \"2 J/m2\": a failure_strain is given as well.",
       {"Allowed: one of failure_strain and fracture_energy, or both with criterion = "
        "\"crack_band\"",
        "Add criterion = \"crack_band\", which uses both"}},
      {"stop before start",
       speed,
       speed + "\nstart = \"2 ms\"\nstop = \"1 ms\"",
       "stop",
       "jet[1].stop = \"1 ms\": the jet stops before it starts.",
       {"\"none\""}},
      {"fixed and moving",
       block_material,
       block_material + "\nfixed = true\ndisplacement_expression = [\"t\", \"0\"]",
       "fixed",
       "body[1].fixed = true: the body also has a displacement_expression.",
       {}},
  });
}

TEST(Refuse, TomlSyntax) {
  EXPECT_NE(message_of("title = \"x\ndimension = 2\n").find("bad.toml:1: this is not valid TOML"),
            std::string::npos);
  EXPECT_NE(message_of("title = \"x\"\ndimension = 2\ndimension = 3\n").find("bad.toml:3: "),
            std::string::npos);
  EXPECT_NE(message_of("").find("dimension: the key is missing"), std::string::npos);
  EXPECT_NE(message_of("title = \"x\"\nquality = draft  # rough\n")
                .find("bad.toml:2: this is not valid TOML"),
            std::string::npos);
  EXPECT_NE(message_of("title = \"x\"\nquality = draft  # rough\n")
                .find("A text is in quotes: quality = \"draft\"."),
            std::string::npos);
  EXPECT_EQ(message_of("title = \"x\"\ndimension = 2..5\n").find("in quotes"), std::string::npos);
}

// The end of a case without a table [time] is missing by its whole name; where it would follow from
// a machine that has a problem, only the problem is told.
TEST(Refuse, MissingEnd) {
  const std::string without_time = "title = \"x\"\ndimension = 2\n";
  EXPECT_NE(message_of(without_time).find("time.end: the key is missing"), std::string::npos);
  const std::string machine =
      "[machine]\npressure = \"30 kpa\"\norifice_diameter = \"0.15 mm\"\nstandoff = \"3 mm\"\n"
      "[workpiece]\nmaterial = \"tofu\"\nsize = [\"300 mm\", \"50 mm\"]\n";
  const std::string message = message_of(without_time + machine);
  EXPECT_NE(message.find("machine.pressure = \"30 kpa\""), std::string::npos) << message;
  EXPECT_EQ(message.find("the key is missing"), std::string::npos) << message;
}

TEST(Refuse, ManyProblemsAtOnce) {
  std::string text = good_case;
  for (int i = 0; i < 14; ++i) text.insert(0, "wrong" + std::to_string(i) + " = 1\n");
  const std::string message = message_of(text);
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 10);
  EXPECT_NE(message.find("\n... and 4 more"), std::string::npos);
}

TEST(Refuse, MissingFiles) {
  try {
    read_case("/nowhere/case.toml");
    FAIL();
  } catch (const UserError& error) {
    EXPECT_EQ(error.exit_code(), exit_files);
    EXPECT_NE(std::string(error.what()).find("/nowhere/case.toml"), std::string::npos);
  }
}

}  // namespace
}  // namespace kerf
