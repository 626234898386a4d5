// SPDX-License-Identifier: Apache-2.0
// Invalid laws of strength over the rate of strain are refused.
#include "refuse/bad_case.hpp"

namespace kerf {
namespace {

TEST(Refuse, StrengthOverTheRateOfStrain) {
  const std::string top = paper,
                    curd =
                        "formulation = \"standard\"\n[materials.curd]\nbase = \"tofu\"\n"
                        "strength_rate_exponent = 0.1\n";
  expect_refused({
      {"no reference",
       top,
       curd,
       "[materials.curd]",
       "materials.curd.strength_reference_rate: a strength_rate_exponent needs it.",
       {"greater than 0 s-1"}},
      {"nothing between its bounds",
       top,
       curd + "strength_reference_rate = \"1 s-1\"\nstrength_greatest_rate = \"0.5 s-1\"",
       "strength_greatest_rate",
       "materials.curd.strength_greatest_rate = \"0.5 s-1\": strength would not depend on the "
       "rate.",
       {"above 1 s-1"}},
      {"a solid that flows",
       top,
       curd + "strength_reference_rate = \"1 s-1\"\nplasticity = \"von_mises\"\n"
              "yield_stress = \"1 kPa\"",
       "strength_rate_exponent",
       "materials.curd.strength_rate_exponent = 0.1: the material flows.",
       {"plasticity is not"}},
      {"too large",
       top,
       "formulation = \"standard\"\n[materials.curd]\nbase = \"tofu\"\n"
       "strength_reference_rate = \"1 s-1\"\nstrength_rate_exponent = 2",
       "strength_rate_exponent = 2",
       "materials.curd.strength_rate_exponent",
       {}},
      {"flaws have a law of their own",
       top,
       "formulation = \"standard\"\n[materials.curd]\nbase = \"granite\"\n"
       "criterion = \"grady_kipp\"\nweibull_k = \"5e34 m-3\"\nweibull_m = 8.5\n"
       "strength_rate_exponent = 0.1",
       "strength_rate_exponent",
       "materials.curd.strength_rate_exponent = 0.1: the key has no meaning here.",
       {"crack_band"}},
  });
}

}  // namespace
}  // namespace kerf
