// SPDX-License-Identifier: Apache-2.0
// This header declares the labels of the varied keys of a study, which follow from the schema.
#pragma once

#include <string>
#include <vector>

#include "study/axis.hpp"

namespace kerf {

// Returns the label of one of the axes: "traverse speed"; with the table that has the key where
// another axis has the same label, "width of jet lower"; with the entry of a list, "maximum y".
std::string axis_label(const Axis& axis, const std::vector<Axis>& axes);

}  // namespace kerf
