// SPDX-License-Identifier: Apache-2.0
// Criteria of fracture that lack something or contradict another key.
#include "refuse/bad_case.hpp"

namespace kerf {
namespace {

TEST(Refuse, SofteningThatLacksSomething) {
  expect_refused({
      {"softening without an energy",
       "dimension = 2",
       "dimension = 2\nformulation = \"standard\"\n[materials.curd]\nbase = \"tofu\"\n"
       "criterion = \"crack_band\"",
       "criterion",
       "materials.curd.fracture_energy: the criterion \"crack_band\" spends this energy.",
       {"greater than 0 J/m2"}},
      {"softening without a strain",
       "dimension = 2",
       "dimension = 2\nformulation = \"standard\"\n[materials.curd]\nbase = \"tofu\"\n"
       "criterion = \"crack_band\"\nfailure_strain = 0\nfracture_energy = \"2 J/m2\"",
       "failure_strain",
       "materials.curd.failure_strain = 0: the criterion \"crack_band\" softens from this strain "
       "on.",
       {"greater than 0"}},
      {"softening and flow",
       "dimension = 2",
       "dimension = 2\nformulation = \"standard\"\n[materials.curd]\nbase = \"copper\"\n"
       "criterion = \"crack_band\"\nfailure_strain = 0.1\nfracture_energy = \"2 J/m2\"",
       "criterion",
       "materials.curd.criterion = \"crack_band\": a material that flows does not soften as well.",
       {"plasticity = \"none\""}},
  });
}

// Flaws are given by both numbers, and stand alone.
TEST(Refuse, Flaws) {
  const std::string
      top = "dimension = 2",
      rock =
          "dimension = 2\nformulation = \"standard\"\n[materials.rock]\nbase = \"granite\"\n"
          "criterion = \"grady_kipp\"\nweibull_k = \"5e34 m-3\"\n";
  expect_refused({
      {"no exponent",
       top,
       rock,
       "[materials.rock]",
       "materials.rock.weibull_m: the key is missing.",
       {}},
      {"an energy as well",
       top,
       rock + "weibull_m = 8.5\nfracture_energy = \"9 J/m2\"",
       "fracture_energy",
       "materials.rock.fracture_energy = \"9 J/m2\": the criterion looks at flaws.",
       {"nothing beside the criterion \"grady_kipp\""}},
      {"a solid that flows",
       top,
       rock + "weibull_m = 8.5\nplasticity = \"drucker_prager\"\ncohesion = \"1 MPa\"\n"
              "friction_angle = \"40 deg\"",
       "criterion",
       "materials.rock.criterion = \"grady_kipp\": the material flows.",
       {"plasticity = \"none\""}},
      {"flaws without the criterion",
       "[materials.gel]",
       "[materials.curd]\nbase = \"tofu\"\nweibull_m = 9\n[materials.gel]",
       "weibull_m",
       "materials.curd.weibull_m = 9: the key has no meaning here.",
       {"only where this holds: grady_kipp"}},
  });
}

}  // namespace
}  // namespace kerf
