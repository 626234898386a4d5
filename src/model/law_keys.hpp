// SPDX-License-Identifier: Apache-2.0
// The keys of a material that belong to its laws, collected from the lists of laws: a law declares
// them itself (`rows` in core/law_list.hpp).
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/case_key.hpp"
#include "model/material.hpp"

namespace kerf {

struct CriterionKeys;  // fracture/breakable_solid.hpp

struct LawText {
  std::string_view
      chosen_by;  // the key of the case file that chooses the law, such as "elasticity"
  std::string_view word, sentence;
};
// Every law with its sentence, in the order of the lists.
std::span<const LawText> law_texts();

// The keys of the laws that the key `chosen_by` chooses among, as keys of Material.
std::vector<Key> law_keys(std::string_view chosen_by);

// Returns which other keys of a material a fracture criterion needs and excludes.
CriterionKeys keys_of(BondCriterion criterion);

}  // namespace kerf
