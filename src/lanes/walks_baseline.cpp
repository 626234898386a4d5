// SPDX-License-Identifier: Apache-2.0
// The walks for any processor of this architecture.
#define KERF_LANES baseline
#include "lanes/walks_of_one_set.hpp"
