// SPDX-License-Identifier: Apache-2.0
// Invalid flaws of rock are refused.
#include "refuse/bad_case.hpp"

namespace kerf {
namespace {

// Flaws need both numbers and exclude other limits.
TEST(Refuse, Flaws) {
  const std::string top = paper,
                    rock =
                        "formulation = \"standard\"\n[materials.rock]\nbase = \"granite\"\n"
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
       "materials.rock.fracture_energy = \"9 J/m2\": the criterion uses flaws.",
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
