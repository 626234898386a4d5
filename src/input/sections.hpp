// SPDX-License-Identifier: Apache-2.0
// The rows of each section of a case file. Each function is in the file that reads the section.
#pragma once

#include <vector>

#include "core/case_key.hpp"

namespace kerf {

// case_sections.cpp has the top level and the tables of a few plain keys.
std::vector<Key> top_keys();
std::vector<Key> time_keys();
std::vector<Key> domain_keys();
std::vector<Key> back_flow_removal_keys();
std::vector<Key> artificial_stress_keys();
std::vector<Key> numerics_keys();

std::vector<Key> material_keys();  // material_section.cpp
std::vector<Key> body_keys();      // body_section.cpp
std::vector<Key> grading_keys();
std::vector<Key> load_keys();       // load_section.cpp
std::vector<Key> shape_keys();      // shape_section.cpp
std::vector<Key> machine_keys();    // machine_section.cpp
std::vector<Key> workpiece_keys();  // workpiece_section.cpp
std::vector<Key> jet_keys();        // jet_section.cpp
std::vector<Key> probe_keys();      // output_section.cpp
std::vector<Key> output_keys();

}  // namespace kerf
