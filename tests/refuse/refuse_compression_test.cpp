// SPDX-License-Identifier: Apache-2.0
// A compressive strength that no test can have given is refused.
#include "refuse/bad_case.hpp"

namespace kerf {
namespace {

TEST(RefuseCompression, BelowThatOfShearOrWithoutMeaning) {
  const std::string rock =
      "formulation = \"standard\"\n[materials.rock]\nkind = \"elastic\"\ndensity = \"2400 kg/m3\"\n"
      "youngs_modulus = \"30 GPa\"\nfailure_strain = 1e-4\nfracture_energy = \"80 J/m2\"\n";
  expect_refused({
      {"too small",
       paper,
       rock + "poisson_ratio = 0.2\ncriterion = \"crack_band\"\ncompressive_strength = \"3 MPa\"",
       "compressive_strength",
       "materials.rock.compressive_strength = \"3 MPa\": the energy of shear alone bears more "
       "before "
       "the failure_strain is reached.",
       {"0 Pa, or 3354110 Pa or more"}},
      {"nearly incompressible",
       paper,
       rock + "poisson_ratio = 0.45\ncriterion = \"crack_band\"\ncompressive_strength = \"30 MPa\"",
       "compressive_strength",
       "materials.rock.compressive_strength = \"30 MPa\": at a poisson_ratio of 0.45",
       {"0 Pa where the poisson_ratio is above 0.41"}},
      {"another criterion",
       paper,
       "formulation = \"standard\"\n[materials.rock]\nbase = \"tofu\"\ncompressive_strength = \"30 "
       "MPa\"",
       "compressive_strength",
       "materials.rock.compressive_strength = \"30 MPa\": the key has no meaning here.",
       {"crack_band"}},
  });
}

}  // namespace
}  // namespace kerf
