// SPDX-License-Identifier: Apache-2.0
// Studies of a small case, and laboratories with results in closed form.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "output/files.hpp"
#include "study/laboratory.hpp"
#include "study/limit_plan.hpp"
#include "study/study_plan.hpp"
#include "support/temporary_folder.hpp"

namespace kerf::test {

inline const std::string curd = R"([materials.curd]
base = "tofu"
criterion = "crack_band"
failure_strain = 0.05
fracture_energy = "10 J/m2"
)";

inline const std::string small_case = R"(title = "small"
dimension = 2
[time]
end = "2 ms"
)" + curd + R"([[body]]
name = "block"
material = "curd"
shape = { type = "box", minimum = ["-8 mm", "0 mm"], maximum = ["8 mm", "6 mm"] }
spacing = "2 mm"
[[body]]
name = "other"
material = "gelatin-10"
shape = { type = "box", minimum = ["-8 mm", "-8 mm"], maximum = ["8 mm", "-2 mm"] }
spacing = "2 mm"
[[jet]]
name = "jet"
material = "water"
speed = "5 m/s"
width = "4 mm"
position = ["0 mm", "6 mm"]
standoff = "2 mm"
spacing = "2 mm"
)";

inline const std::string machine_case = R"(title = "small machine"
dimension = 2
[machine]
pressure = "50 kPa"
orifice_diameter = "2 mm"
standoff = "4 mm"
position = ["-6 mm", "6 mm"]
traverse_speed = "2 m/s"
dwell = "1 ms"
[time]
end = "9 ms"
)" + curd + R"([[body]]
name = "block"
material = "curd"
shape = { type = "box", minimum = ["-20 mm", "0 mm"], maximum = ["20 mm", "6 mm"] }
)";

// The plan of a limit of a case.
inline LimitPlan limit_plan_of(const std::string& text, const LimitQuestion& question) {
  const TemporaryFolder folder;
  write_file(folder / "my.toml", text);
  return plan_limit(folder / "my.toml", question);
}
inline LimitQuestion limit_of(const std::string& quantity) {
  LimitQuestion question;
  question.of = quantity;
  return question;
}

// A study of the small case, which is given as a template.
inline StudyPlan plan_of(const std::string& text) {
  const EmbeddedText templates[] = {{"small", small_case}};
  return parse_study("base = \"small\"\n" + text, "my-study.toml", templates);
}

inline double speed_of(const Trial& trial) {
  return trial.setting.numbers.at("jet.jet.speed");
}

// Gives results by a function, and records the requests.
class SyntheticLaboratory : public Laboratory {
 public:
  using Answer = std::function<std::map<std::string, double>(const Trial&)>;

  SyntheticLaboratory(Answer answer, int side_by_side)
      : answer_(std::move(answer)), side_by_side_(side_by_side) {}

  std::vector<Outcome> run(const std::vector<Trial>& trials) override {
    std::vector<Outcome> outcomes;
    for (const Trial& trial : trials) {
      asked.push_back(trial);
      outcomes.push_back({std::to_string(asked.size()), false, "", answer_(trial)});
    }
    ++rounds;
    return outcomes;
  }
  int side_by_side() const override { return side_by_side_; }

  std::vector<Trial> asked;
  int rounds = 0;

 private:
  Answer answer_;
  int side_by_side_;
};

}  // namespace kerf::test
