// SPDX-License-Identifier: Apache-2.0
// What is wrong with a [workpiece] and its [machine] is told by the keys that the user wrote.
#include "refuse/bad_case.hpp"

namespace kerf {
namespace {

std::string workpiece_case(int dimension, const std::string& material, const std::string& machine,
                           const std::string& time = "") {
  return "title = \"slab\"\ndimension = " + std::to_string(dimension) + "\nquality = \"draft\"\n" +
         time + "[machine]\npressure = \"30 MPa\"\norifice_diameter = \"0.15 mm\"\n" +
         "standoff = \"3 mm\"\n" + machine + "[workpiece]\nmaterial = \"" + material + "\"\n" +
         (dimension == 3 ? "size = [\"300 mm\", \"5 mm\", \"200 mm\"]\n"
                         : "size = [\"300 mm\", \"5 mm\"]\n");
}

void expect_only(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "wanted " << part << "\ngot " << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;  // one problem
}

TEST(RefuseWorkpiece, OfWater) {
  EXPECT_EQ(message_of(workpiece_case(2, "tofu", "")), "(no error)");
  expect_only(message_of(workpiece_case(2, "water", "")),
              {"bad.toml:9: workpiece.material = \"water\": this is water",
               "Allowed: a material of the kind \"elastic\"", "`kerf materials`"});
}

TEST(RefuseWorkpiece, BesideTheJet) {
  expect_only(message_of(workpiece_case(2, "tofu", "position = [\"400 mm\", \"0 mm\"]\n")),
              {"bad.toml:8: machine.position = [\"400 mm\", \"0 mm\"]: with entry 1 the jet passes "
               "beside the workpiece",
               "Allowed: entry 1 from -0.15 m to 0.15 m", "Correct the position"});
  expect_only(
      message_of(workpiece_case(3, "tofu", "position = [\"0 mm\", \"0 mm\", \"150 mm\"]\n")),
      {"machine.position = ", "entry 3 from -0.1 m to 0.1 m", "enlarge workpiece.size"});
  const std::string travelling =
      workpiece_case(2, "tofu", "traverse_speed = \"10 m/s\"\nposition = [\"400 mm\", \"0 mm\"]\n");
  expect_only(message_of(travelling), {"machine.position = "});
}

TEST(RefuseWorkpiece, ARelaxationBeyondTheEnd) {
  const auto with = [](const std::string& time) {
    return message_of(workpiece_case(2, "tofu", "", "[time]\n" + time));
  };
  EXPECT_EQ(with("end = \"1 ms\"\nrelax = \"1 ms\"\n"), "(no error)");
  expect_only(with("end = \"1 ms\"\nrelax = \"1.5 ms\"\n"),
              {"bad.toml:6: time.relax = \"1.5 ms\": the run ends before it",
               "Allowed: at most the end of the run, 0.001 s", "choose a later time.end"});
}

// The spacing follows from the jet, whose width is that of the orifice and grows with the standoff.
TEST(RefuseWorkpiece, ASpacingIntoWhichItDoesNotFit) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = workpiece_case(2, "tofu", "");
    text.replace(text.find(from), from.size(), to);
    return message_of(text);
  };
  const std::string allowed = "Allowed: a spacing of less than 0.005 m";
  expect_only(with("standoff = \"3 mm\"", "standoff = \"100 m\""),
              {"bad.toml:7: machine.standoff = \"100 m\": no particle fits into the workpiece",
               "that of the jet, which is", allowed, "Correct this length"});
  expect_only(with("0.15 mm", "400 mm"),
              {"bad.toml:6: machine.orifice_diameter = \"400 mm\": no particle fits", allowed});
  expect_only(with("\"5 mm\"", "\"0.005 mm\""),
              {"bad.toml:10: workpiece.size = [\"300 mm\", \"0.005 mm\"]: no particle fits",
               "Correct this length or its unit, or give workpiece.spacing"});
  expect_only(with("standoff =", "spacing = \"20 mm\"\nstandoff ="),
              {"bad.toml:7: machine.spacing = \"20 mm\": the width of the grading is less",
               "smaller spacing"});
  expect_only(with("size =", "spacing = \"20 mm\"\nlevels = 0\nsize ="),
              {"bad.toml:10: workpiece.spacing = \"20 mm\": no particle fits into the workpiece at "
               "the spacing of 0.02 m. Allowed",
               allowed, "Lower it"});
}

// The spacing of a body that states none follows from the jet too.
TEST(RefuseWorkpiece, ABodyIntoWhichTheSpacingOfTheJetDoesNotFit) {
  const auto with = [](const std::string& standoff, const std::string& spacing) {
    return message_of(
        "title = \"far\"\ndimension = 2\n[machine]\npressure = \"50 kPa\"\n"
        "orifice_diameter = \"2 mm\"\nstandoff = \"" +
        standoff +
        "\"\nposition = [\"0 mm\", \"0 mm\"]\n[[body]]\nname = \"gel\"\nmaterial = \"tofu\"\n" +
        spacing +
        "shape = { type = \"box\", minimum = [\"-10 mm\", \"-6 mm\"], maximum = [\"10 mm\", "
        "\"0 mm\"] }\n");
  };
  EXPECT_EQ(with("6 mm", ""), "(no error)");
  expect_only(with("90 m", ""),
              {"bad.toml:6: machine.standoff = \"90 m\": no particle of the body \"gel\" fits into "
               "it at the spacing of",
               "that of the jet, which is", "after a standoff of 90 m", "Correct this length"});
  expect_only(
      with("90 m", "spacing = \"50 mm\"\n"),
      {"bad.toml:12: body[1].shape", "no particle of the body \"gel\" fits into it. Allowed"});
}

// The grading and the shape of a workpiece are keys of its table.
TEST(RefuseWorkpiece, ByItsOwnKeys) {
  std::string text = workpiece_case(2, "tofu", "");
  text += "grading_width = \"0.01 mm\"\nlevels = 2\n";
  expect_only(message_of(text),
              {"bad.toml:11: workpiece.grading_width = \"0.01 mm\": the width of the grading is "
               "less than the coarsest spacing"});
  // A body beside the workpiece is the first [[body]] of the file.
  text = workpiece_case(2, "tofu", "") +
         "[[body]]\nname = \"far\"\nrole = \"rigid\"\nspacing = \"1 mm\"\n"
         "shape = { type = \"box\", minimum = [\"0 mm\", \"-900 mm\"], maximum = [\"9 mm\", "
         "\"-890 mm\"] }\n";
  expect_only(message_of(text), {"bad.toml:15: body[1].shape: the body", "leaves the domain"});
}

}  // namespace
}  // namespace kerf
