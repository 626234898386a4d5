// SPDX-License-Identifier: Apache-2.0
// The state of a run as a message from rank 0 to the others: all but the particles, which rank 0
// divides among the ranks.
#pragma once

#include <string>

#include "parallel/ranks.hpp"
#include "simulation/archive.hpp"

namespace kerf {

ranks::Bytes message_of(const Archive& archive);
Archive archive_of(const ranks::Bytes& message);

}  // namespace kerf
