// SPDX-License-Identifier: Apache-2.0
// Fracture criteria with missing or contradictory keys are refused.
#include "refuse/bad_case.hpp"

namespace kerf {
namespace {

TEST(Refuse, IncompleteSoftening) {
  expect_refused({
      {"softening without an energy",
       paper,
       "formulation = \"standard\"\n[materials.curd]\nbase = \"tofu\"\n"
       "criterion = \"crack_band\"",
       "[materials.curd]",
       "materials.curd.fracture_energy: the criterion \"crack_band\" needs it.",
       {"greater than 0"}},
      {"softening without a strain",
       paper,
       "formulation = \"standard\"\n[materials.curd]\nbase = \"tofu\"\n"
       "criterion = \"crack_band\"\nfailure_strain = 0\nfracture_energy = \"2 J/m2\"",
       "failure_strain",
       "materials.curd.failure_strain = 0: the criterion \"crack_band\" needs it.",
       {"greater than 0"}},
      {"softening and flow",
       paper,
       "formulation = \"standard\"\n[materials.curd]\nbase = \"copper\"\n"
       "criterion = \"crack_band\"\nfailure_strain = 0.1\nfracture_energy = \"2 J/m2\"",
       "criterion",
       "materials.curd.criterion = \"crack_band\": the material flows.",
       {"plasticity = \"none\""}},
  });
}

}  // namespace
}  // namespace kerf
